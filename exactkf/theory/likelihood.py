# SPDX-License-Identifier: MIT
r"""Maximum-likelihood estimation with possibly perfect measurements.

The measurement is :math:`y = Hx + v` with a Gaussian `v` of covariance `R`, which may
be singular.

Main definitions
----------------
``likelihood_matrix``      :math:`Z = \begin{pmatrix} R & H \\ H^T & 0 \end{pmatrix}`
``symmetric_inverse``      any symmetric `G` with :math:`ZGZ = Z`
``likelihood_blocks``      the blocks `W`, `U`, `T` of such a `G`
``estimate``, ``error_covariance``    :math:`U^T y` and :math:`-T`
``is_estimable``, ``full_rank_factors``, ``estimable_part``   the case of dependent columns

Main statements
---------------
If `H` has independent columns and `R` is nonnegative definite, then for every choice
of `G`: :math:`U^T H = I`, :math:`RU + HT = 0`, :math:`H^T W H = 0`, :math:`RWH = 0`,
and with :math:`\Delta = R - RWR`: :math:`HTH^T = -\Delta`, :math:`RUH^T = \Delta`.
The block `T` and the matrix :math:`\Delta` do not depend on the choice.

Notation
--------
The print defines :math:`\Delta` in NWL92 (A.7) as `R + RWR`; (A.3) with (A.8), (A.9)
forces the minus sign, and so does ``R = H = 1`` with `W = 0`, ... or ``H = (1, 0)^T``, ``R = I``.

References
----------
NWL92 (2.1)-(2.27), Lemmas 2.1 and 2.2, Appendix A.
"""
