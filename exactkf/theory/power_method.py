# SPDX-License-Identifier: MIT
r"""The state of the fast filter after many steps, by repeated squaring.

The Riccati equation behind the filter is the action of one symplectic matrix
`S` of order `2n` (BLZ94 Section 6), so a state far ahead is a power of `S`
away.  The power is taken in :math:`\mathbb{Q}[z]` modulo the characteristic
polynomial of `S`, over the integers.

Main definitions
----------------
``state_after``            the exact state :math:`(a(T), g(T))`
``power_modulo``           :math:`z^T` modulo an integer polynomial, without fractions
``symplectic_matrix_of``   the matrix `S` of a state
``symplectic_rows``        its rows, over any field

Main statements
---------------
Let :math:`A = J - qh'` with :math:`q = a + g`, and

.. math:: S = \begin{pmatrix} A'^{-1} & -A'^{-1}hh' \\ gg'A'^{-1} & A - gg'A'^{-1}hh' \end{pmatrix},
          \qquad \begin{pmatrix} X_t \\ Y_t \end{pmatrix} = S^t \begin{pmatrix} I \\ 0 \end{pmatrix}.

Then :math:`P_t = Y_t X_t^{-1}` solves BLZ94 (2.2) with :math:`P_0 = 0`, and with
:math:`u = P_t h`, :math:`r_t = 1 - u_1`, :math:`F = J - ah'`,

.. math:: q(t) = a + (g - Fu)/r_t, \qquad g(t) = X_t'^{-1} g / r_t .

The second formula follows from :math:`X_{t+1} = (F - k_t h')'^{-1} X_t` and
:math:`r_{t+1} g(t+1) = (F - k_t h') r_t g(t)`; it settles the sign that
:math:`P_{t+1} - P_t = r_t g(t) g(t)'` leaves open.

The matrix `S` exists if :math:`\alpha_n = a_n + g_n \ne 0`.  Otherwise
:math:`\alpha` ends in `m` zeros, the first :math:`n - m` entries of
:math:`\alpha` and the last :math:`n - m` entries of :math:`\gamma` evolve
by themselves, and the power is taken for them.

References
----------
BLZ94 (2.2), (2.8), (2.17), (6.4)-(6.17); BLM91 (2.18)-(2.20).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from math import isqrt
from typing import Any

from flint import fmpq, fmpq_mat, fmpz, fmpz_mat, fmpz_poly, nmod_mat

from exactkf.exact._messages import check_count
from exactkf.theory._matrices import as_fmpq_mat
from exactkf.theory._scalars import Scalar, Vector, refused, unify_pair
from exactkf.theory.fast_filter import State, ag_from_alpha_gamma, alpha_gamma_from_ag, step_alpha_gamma
from exactkf.theory.orbits import escape_before, exact_orbit

_FARTHEST = 10**7  # steps: the state has about as many digits
_MOST_BITS, _LARGE = 1 << 32, 10**4
_PRIME = (1 << 61) - 1
_MANY, _FEW = 1000, 4  # steps from which, and the order up to which, minors are quicker than stepping modulo a prime

__all__ = ["Arrival", "power_modulo", "state_after", "symplectic_matrix_of", "symplectic_rows"]


@dataclass(frozen=True)
class Arrival:
    r"""The outcome of `state_after`: exactly one of the attributes is not None.

    Attributes
    ----------
    state : State or None
        :math:`(a(T), g(T))` with entries of type ``fmpq``.
    escape : int or None
        The first ``t < T`` with :math:`\gamma_t^2 = 1`: no state ``t + 1`` exists.
    """

    state: State | None
    escape: int | None


def symplectic_matrix_of(a: Sequence[Scalar], g: Sequence[Scalar]) -> fmpq_mat:
    r"""Return the matrix `S` of order ``2n`` displayed above (BLZ94 (6.8a)).

    Unlike the print it needs no nonsingular `F`, only :math:`\alpha_n \ne 0`.

    Raises
    ------
    BadInput
        If :math:`a_n + g_n = 0`, the entries are not rational or the lengths differ.

    Examples
    --------
    >>> symplectic_matrix_of([1], [1]).tolist()
    [[-1/2, 1/2], [-1/2, -3/2]]
    """
    a, g = as_fmpq_mat("(a, g)", unify_pair(a=a, g=g)).tolist()
    n = len(a)
    if a[-1] + g[-1] == 0:
        raise refused(f"a[{n - 1}] + g[{n - 1}]", fmpq(0), "S does not exist", "use state_after, which reduces n")
    return fmpq_mat(symplectic_rows([x + y for x, y in zip(a, g, strict=True)], g))


def symplectic_rows(q: Sequence[Any], g: Sequence[Any]) -> list[list[Any]]:
    """Return the rows of `S` for entries of any one field; the last of `q` is not zero."""
    n, zero = len(q), 0 * q[-1]
    # A = J - q h', so A' e_i = e_{i+1} - q_i e_1 and A' e_n = -q_n e_1
    inverse = [[zero + int(j == i + 1) for j in range(n)] for i in range(n - 1)] + [[-x / q[-1] for x in (1 + zero, *q[:-1])]]
    along = [sum((g[k] * inverse[k][j] for k in range(n)), zero) for j in range(n)]
    low = [[x * y for y in along] for x in g]
    top = [[*row, -row[0], *[zero] * (n - 1)] for row in inverse]
    return top + [[*row, *((zero + int(j == i + 1)) - (q[i] + row[0] if j == 0 else zero) for j in range(n))] for i, row in enumerate(low)]


def power_modulo(exponent: int, modulus: fmpz_poly) -> tuple[fmpz_poly, int]:
    r"""Return `N` and `e` with :math:`N / \ell^e = z^T` modulo `modulus`, where :math:`\ell` leads `modulus`.

    Parameters
    ----------
    exponent : int
        ``T >= 0``.
    modulus : fmpz_poly
        Of degree at least one.

    Returns
    -------
    N : fmpz_poly
        Of lower degree than `modulus`.
    e : int
        At most ``max(0, T - deg + 1)``: no power of the leading coefficient is wasted.
        Irrelevant if the leading coefficient is one.

    Raises
    ------
    BadInput
        If `exponent` is negative or no integer, the power too large for the memory, or `modulus` is no such polynomial.

    Examples
    --------
    >>> from flint import fmpz_poly
    >>> power_modulo(5, fmpz_poly([-1, -1, 1]))[0]
    5*x + 3
    >>> power_modulo(2, fmpz_poly([-1, 0, 3]))
    (1, 1)
    """
    check_count("exponent", exponent)
    if not isinstance(modulus, fmpz_poly) or modulus.degree() < 1:
        raise refused("modulus", modulus, "not an integer polynomial of degree at least one", "pass an fmpz_poly")
    degree, lead = modulus.degree(), modulus.leading_coefficient()
    value, e = fmpz_poly([1]), 0
    for place, bit in enumerate(bin(exponent)[2:], 1):
        value, e = value * value, 2 * e
        if (height := value.height_bits()) > _LARGE and height << (exponent.bit_length() - place) > _MOST_BITS:  # it doubles in each turn from here on
            raise refused("exponent", exponent, f"the power has more than {_MOST_BITS} bits", "pass a smaller one, or compute modulo a prime")
        if bit == "1":
            value = value.left_shift(1)
        while value.degree() >= degree:
            factor = value.leading_coefficient() * modulus
            value, e = lead * value - factor.left_shift(value.degree() - degree), e + 1
    return value, e


def _krylov(S: fmpq_mat, g: Vector) -> tuple[list[fmpz_mat], fmpz]:
    r"""Return integer matrices and a denominator: entry `k` is the denominator times :math:`(X_k' \mid Y_k'h)`.

    The last column of :math:`(X_k' \mid Y_k' h)` is the first row of :math:`Y_k`.
    """
    n = len(g)
    Z = fmpq_mat([[int(i == j) for j in range(n)] for i in range(2 * n)])
    tables = []
    for _ in range(2 * n):
        table = Z.tolist()
        tables.append(fmpq_mat([[table[j][i] for j in range(n)] + [table[n][i]] for i in range(n)]))
        Z = S * Z
    pairs = [table.numer_denom() for table in tables]
    common = fmpz(1)
    for _, denominator in pairs:
        common = common.lcm(denominator)
    return [numerator * (common // denominator) for numerator, denominator in pairs], common


def _arrive(a: Vector, g: Vector, steps: int) -> State:
    """Return the state after `steps` steps; no escape on the way and ``a_n + g_n != 0`` are assumed."""
    n = len(a)
    S = symplectic_matrix_of(a, g)
    characteristic = S.charpoly().numer()
    power, e = power_modulo(steps, characteristic)
    basis, common = _krylov(S, g)
    total = fmpz_mat(n, n + 1)
    for coefficient, matrix in zip(power.coeffs(), basis, strict=False):
        total += matrix * coefficient
    # Solve X'(u, w) = (Y'h, g), all multiplied by common * lead^e and by the denominator of g.
    g_numerator, g_denominator = fmpq_mat([[x] for x in g]).numer_denom()
    weight = common * characteristic.leading_coefficient() ** e
    rows = [
        [x * g_denominator for x in row] + [weight * y]
        for row, (y,) in zip(total.tolist(), g_numerator.tolist(), strict=True)
    ]
    reduced, det, _ = fmpz_mat(rows).rref()
    # minors of a power of S have hardly more digits than its entries: nearly all of the powers of `lead` cancel
    spare = characteristic.leading_coefficient() ** max(0, (e - 4 * n) * (n - 1))
    det, *columns = _divided([det, *(reduced[i, k] for k in (n, n + 1) for i in range(n))], spare)
    u, w = columns[:n], columns[n:]  # det * P_T h and det * X_T'^{-1} g
    r = det - u[0]  # det * r_T
    # F u = J u - a u_1, so q(T) r_T = a r_T + g - F u = a + g - J u.
    q_numerator = [det * (x + y) - z for x, y, z in zip(a, g, [*u[1:], 0], strict=True)]
    return tuple((x - y) / r for x, y in zip(q_numerator, w, strict=True)), tuple(fmpq(y, r) for y in w)


def _divided(values: list[fmpz], factor: fmpz) -> list[fmpz]:
    """Return the quotients if the factor divides all values, else the values."""
    pairs = [divmod(x, factor) for x in values]
    return values if any(rest for _, rest in pairs) else [quotient for quotient, _ in pairs]


def _escape_excluded(a: Vector, g: Vector, steps: int) -> bool:
    r"""Say whether a prime shows that there is no escape before `steps`: it divides no ``det X_t``, ``t <= steps + 1``.

    ``det X_{t+1}`` is a multiple of :math:`\det X_t r_t`, and :math:`r_t` is the product of the :math:`1 - \gamma_k^2`, ``k < t``.  With
    ``t = i + jB`` it is a sum of products of minors (Cauchy and Binet), and all are the entries of one product of matrices.
    """
    n, p, size = len(a), _PRIME, isqrt(steps + 1) + 1
    numerator, denominator = symplectic_matrix_of(a, g).numer_denom()
    if denominator % p == 0:
        return False
    S = nmod_mat(numerator, p) * int(pow(int(denominator), -1, p))
    leap, minors = S**size, list(combinations(range(2 * n), n))

    def read(matrix: nmod_mat, transposed: bool) -> list[int]:
        table = [[int(matrix[j, i] if transposed else matrix[i, j]) for j in range(2 * n)] for i in range(n)]
        return [int(nmod_mat(n, n, [row[j] for row in table for j in chosen], p).det()) for chosen in minors]

    near, far = S**0, S**0
    rows, columns = [], []
    for _ in range(size):
        rows.append(read(near, False))
        columns.append(read(far, True))
        near, far = near * S, far * leap
    product = nmod_mat(size, len(minors), [x for row in rows for x in row], p) * nmod_mat(size, len(minors), [x for row in columns for x in row], p).transpose()
    return all(map(int, product.entries()))


def state_after(a: Sequence[Scalar], g: Sequence[Scalar], T: int) -> Arrival:
    r"""Return the exact state of the fast filter after `T` steps.

    Parameters
    ----------
    a, g : sequences of rationals, length n
        The state at time zero.
    T : int
        Number of steps, nonnegative.

    Returns
    -------
    Arrival
        The state, or the time of escape.  The result has of the order of ``T`` digits.

    Raises
    ------
    BadInput
        If the entries are not rational, the lengths differ, or `T` is negative or more than 10,000,000.

    Examples
    --------
    >>> state_after([0], [2], 2).state
    ((2,), (-8/7,))
    >>> state_after([2], [-2], 1000).state, state_after([-2], [fmpq(1, 2)], 1000).escape
    (((0,), (0,)), 1)
    """
    start, g_start = (tuple(row) for row in as_fmpq_mat("(a, g)", unify_pair(a=a, g=g)).tolist())
    check_count("T", T, 0, _FARTHEST, "exactkf.dynamics.digits_ahead gives the digits of the state")
    n = len(start)
    excluded = T > _MANY and n <= _FEW and start[-1] + g_start[-1] != 0 and _escape_excluded(start, g_start, T)
    escape = None if excluded else escape_before(start, g_start, T)
    if escape is not None:
        return Arrival(None, escape)
    if 2 * n >= T:
        return Arrival(exact_orbit(start, g_start, T).states[-1], None)
    if start[-1] + g_start[-1] != 0:
        return Arrival(_arrive(start, g_start, T), None)
    return Arrival(_arrive_reduced(start, g_start, T), None)


def _arrive_reduced(a: Vector, g: Vector, T: int) -> State:
    r"""Return the state after ``T > 2n`` steps when :math:`\alpha_n = 0`; no escape before `T` is assumed."""
    n = len(a)
    if escape_before(a, g, T + n) is not None:  # the coordinates (alpha, gamma) do not exist at T
        return exact_orbit(a, g, T).states[-1]
    alpha, gamma = alpha_gamma_from_ag(a, g)
    k = max((i + 1 for i, value in enumerate(alpha) if value != 0), default=0)
    if k == 0:
        return (fmpq(0),) * n, (fmpq(0),) * n
    # Time runs n - k steps ahead in the last k Schur parameters.
    small = alpha_gamma_from_ag(*_arrive(*ag_from_alpha_gamma(alpha[:k], gamma[n - k :]), T - (n - k)))
    ahead = list(small[1])
    for _ in range(n - k):
        small = step_alpha_gamma(*small)
        ahead.append(small[1][-1])
    return ag_from_alpha_gamma((*small[0], *(fmpq(0),) * (n - k)), ahead)
