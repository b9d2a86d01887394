# SPDX-License-Identifier: MIT
"""Lemmas for (A-17): sigma_{j+m,j} = r_j pi_m for the parameters gamma_{s+j}, gamma_{s+j+1}, .., for every j and m.

Beside sigma_ij there are the same forms with the reversed polynomials,

    tau_ij = (psi_i*(z) phi_j(1/z) - phi_i*(z) psi_j(1/z)) / 2,        chi_ij = (phi_i*(z) psi_j*(1/z) + psi_i*(z) phi_j*(1/z)) / 2.

By (3.5) a step of the first index takes (sigma, tau) to (z sigma + gamma tau, tau + gamma z sigma), which is what it does to
pi_m and (psi_m* - phi_m*)/2; and a step of both indices takes (sigma, tau, chi) = (r, 0, r) at i = j to (1 - gamma^2)(r, 0, r).
So sigma_{j+m,j} has the exponents 1, .., m if m > 0.

They are numbered as they stand in `SIGMA`.
"""

from __future__ import annotations

from exactkf.evidence import lemma, use
from exactkf.language import Expr, Z, always, coeff, function, recip, symbols, when
from proofs.blz94.notation import HALF, gamma, i, j, m, phi, phis, pi, psi, psis, r, s, sigma, t

__all__ = ["ENDS", "EXPONENTS", "FORMS", "OPENED_FOR_SIGMA", "SIGMA", "chi", "tau"]

tau, chi, l = symbols("tau chi l")
#: what the lemmas speak of
FORMS = (
    function(tau, [s, i, j], HALF * (psis(s, i) * recip(phi(s, j)) - phis(s, i) * recip(psi(s, j)))),
    function(chi, [s, i, j], HALF * (phis(s, i) * recip(psis(s, j)) + psis(s, i) * recip(phis(s, j)))),
)
OPENED_FOR_SIGMA = {"supported": [phi, phis, psi, psis], "closed": [sigma]}
_CLOSED = (sigma, tau, chi)

_g = gamma[s + j]
_t, _t_flip = tau(s, j, j), recip(tau(s, j, j))
_OPEN = [use(x, s, y, y) for x in (sigma, tau, chi) for y in (j, j + 1)]
_FIRST = lemma(i, always(s, always(j, (sigma(s, i + 1, j) == Z * sigma(s, i, j) + gamma[s + i] * tau(s, i, j))
                                   & (tau(s, i + 1, j) == tau(s, i, j) + gamma[s + i] * Z * sigma(s, i, j)))),
               direct=True, in_values=True, closed=_CLOSED, uses=[use(x, s, y, j) for x in (sigma, tau) for y in (i, i + 1)])
_BOTH = lemma(j, always(s, (sigma(s, j + 1, j + 1) == sigma(s, j, j) - _g**2 * chi(s, j, j) + _g * Z * _t_flip + _g / Z * _t)
                        & (tau(s, j + 1, j + 1) == 1 / Z * _t - _g * chi(s, j, j) + _g * sigma(s, j, j) + _g**2 * Z * _t_flip)
                        & (chi(s, j + 1, j + 1) == chi(s, j, j) - _g**2 * sigma(s, j, j) - _g / Z * _t - _g * Z * _t_flip)),
              direct=True, in_values=True, closed=_CLOSED, uses=_OPEN)
_DIAGONAL = lemma(j, always(s, (sigma(s, j, j) == r(s, j)) & (tau(s, j, j) == 0) & (chi(s, j, j) == r(s, j))), in_values=True, closed=_CLOSED,
                  uses=[use(1, j=j, s=s), use(2, j=j, s=s), use(r, s, j + 1), use(r, s, j)], base=[*(use(x, s, 0, 0) for x in (sigma, tau, chi)), use(r, s, 0)])
SIGMA = (_FIRST, _BOTH, _DIAGONAL)
#: fourth of a list: no other exponents than 1, .., m; for m = 0 zero alone
EXPONENTS = lemma(m, always(s, always(j, always(l, (coeff(sigma(s, j + m, j), -l) == when(m == 0, when(l == 0, r(s, j), 0), 0))
                                                & (coeff(tau(s, j + m, j), -l) == 0)
                                                & (coeff(sigma(s, j + m, j), m + 1 + l) == 0) & (coeff(tau(s, j + m, j), m + 1 + l) == 0)))),
                  uses=[*(use(0, i=j + m, s=s, j=j, z=x) for x in (-l, m + 2 + l)), *(use(3, m=m, s=s, j=j, l=x) for x in (l, l + 1))],
                  base=[use(2, j=j, s=s, z=x) for x in (-l, l + 1)])


def COLUMN(number: int, second: Expr | None = None) -> dict:
    """(A-17c), as the lemma so numbered; ``second`` is the recursion that goes with that of pi, if pi has one of its own."""
    other = HALF * (psis(s + j, m) - phis(s + j, m)) if second is None else second(s + j, m)
    return lemma(m, always(s, always(j, (sigma(s, j + m, j) == r(s, j) * pi(s + j, m)) & (tau(s, j + m, j) == r(s, j) * other))), in_values=True, closed=_CLOSED,
                 uses=[use(0, i=j + m, s=s, j=j), use(number, m=m, s=s, j=j)], base=[use(2, j=j, s=s)])


#: fifth of a list: leading and constant coefficients
ENDS = lemma(t, always(s, (coeff(psi(s, t), t) == 1) & (coeff(phi(s, t), t) == 1) & (coeff(phis(s, t), 0) == 1) & (coeff(psis(s, t), 0) == 1)
                       & (coeff(psi(s, t), 0) == -coeff(phi(s, t), 0))), start=1, uses=[use(4, t=t, s=s)])
