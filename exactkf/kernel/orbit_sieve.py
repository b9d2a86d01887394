# SPDX-License-Identifier: MIT
r"""Orbits of the fast filter that never escape, by congruences: what is checked about them.

Main definitions
----------------
`check_never_singular`  no X_t, t >= 0, is singular
`zeros_modulo`          the t at which det X_t vanishes modulo a prime
`exponent`              how often a prime divides a number
`intertwiner`           the matrix K of statement 6
`has_null_vector`       whether columns are dependent modulo a power of a prime
`intersected`           what two periodic sets of integers have in common
`symplectic`            the matrix S_m
`reading`               numbers modulo a power of a prime

Main statements
---------------
(X_t; Y_t) are the powers of S_m applied to (I; 0).  With r_t = 1 - h'P_t h, P_t = Y_t X_t^-1, X_{t+1} = A'^-1 (X_t - hh'Y_t) has
the determinant det X_t r_t / det A', and r_t is the product of the first t of the 1 - g^2: the orbit escapes
exactly if some det X_t, t >= 0, is zero, two steps before the first of them.

1. *One prime.*  If p divides no denominator and S_m^L = I modulo p, det X_t modulo p depends on t modulo L only.  Where it is
   not zero modulo p it is not zero.
2. *Several primes.*  A t with det X_t = 0 is in the periodic set of every prime, and so in their intersection.
3. *Orbits that come from an escape.*  If X_{-k}, k > 0, has a kernel of dimension r > 0, then -k is in all these sets.  Let p >= 3, M = S_m^L = I + pB
   over the p-adic integers.  X_{-k + Ls} = X_{-k} + p s (W + p U(s)), U power series with integral coefficients, because p^j binomial(s, j) is
   s times a polynomial with the coefficients of p^j / j!, divisible by p for j = 1 and by p^2 for j > 1.  A basis of the kernel over the p-adic integers
   goes on to one of the whole space; in it r columns of X_{-k} are zero, so det X_{-k + Ls} = (ps)^r (f + p u(s)), u like U.  If that is
   not zero modulo p^{r+1} at s = 1, p does not divide f, and there is no other zero of the form -k + Ls.
4. *Algebraic data.*  theta is a zero of an irreducible polynomial F (`exactkf.kernel.irreducible`), monic and p-integral, and r a zero of F modulo
   p.  A p-integral polynomial that vanishes at theta is a multiple of F, also among p-integral ones, so theta -> r defines a homomorphism; a place is p with r.
   If r is a simple zero it lifts to the p-adic integers, and the homomorphism with it.
5. *Powers of a prime.*  If S_m^L = I modulo p then S_m^{L p^a} = I modulo p^{a+1}: (I + p^j A)^p = I + p^{j+1} (...) for j > 0.  So det X_t
   modulo p^{a+1} depends on t modulo L p^a only.  If the common period of several primes is a multiple of that, as L' of another may have the factor p, each
   time that is left can be tested modulo p^{a+1}: one in p^a or so stays.
6. *Two kinds of zeros.*  Let K be the matrix with K A'^i h = A^i g.  Then AK = KA', K' = K (h'A^j g = g'A'^j h), Kh = g, and K is regular, as
   (A, g) is reachable.  With R: (x; y) -> (K^-1 y; Kx) this gives S_m R S_m = R, block by block, and S_m^t R S_m^t = R.  So if S_m^t (u; 0) = (0; w), R applied
   to both and exchanged gives S_m^t (K^-1 w; 0) = (0; Ku): K^-1 Y_t is an involution of ker X_t.  If det X_t = 0, there is a rational u, not zero, with
   X_t u = 0 and Y_t u = Ku or Y_t u = -Ku, p-integral and not zero modulo p.  Hence it is enough that for either sign e, for every t >= 0, the matrix
   (X_t; Y_t - eK) has full rank over the rational numbers; if it has not, there is a vector, not zero modulo p, that it takes to zero modulo p^{a+1}.
   Modulo p that is so for one t in p or so, where det X_t vanishes for two.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from fractions import Fraction
from itertools import islice
from math import comb, gcd, isqrt
from operator import mul
from struct import iter_unpack
from typing import Any

from exactkf.kernel.algebraic import Algebraic
from exactkf.kernel.limits import MINORS, STEPS, WORK, within
from exactkf.kernel.linear import Matrix, char_coefficients, echelon
from exactkf.kernel.numbers import Undefined, need
from exactkf.kernel.orbit_wandering import modular

__all__ = ["backward", "check_never_singular", "exponent", "has_null_vector", "intersected", "intertwiner", "minors", "reading",
           "step_matrix", "symplectic", "zeros_modulo"]

_MOST = 10**5  # times that several primes leave


def check_never_singular(Q: list, S: list, places: Any, before: Any, sign: int = 0, read: dict[Any, set[int]] | None = None) -> None:
    """Accept if no det X_t, t >= 0, of a reduced pair is zero; with a sign, if none is for the kind of statement 6 that it names.

    Parameters
    ----------
    Q, S : lists of Fraction or Algebraic
    places : list
        ``[p, L]`` or, for algebraic data, ``[p, L, r]``.
    before : list
        The k of statement 3.
    sign : int
        1 or -1, or 0 for both kinds at once.
    read : dict
        Zeros modulo primes that are known from a call for the other sign with the same pair.
    """
    read = {} if read is None else read
    need(bool(places), "no prime is named")
    m, period, left, work = len(Q) - 1, 1, [0], 0
    depths: dict[int, int] = {}
    for i, (p, L, root) in enumerate(map(_place, places)):
        need(type(p) is int and 1 < p < STEPS and all(p % r for r in range(2, isqrt(p) + 1)), "a place is not a prime")
        need(type(L) is int and 0 < L < STEPS, "a period is not a positive integer")
        values = reading([*Q[-2::-1], *S[-2::-1]], p, root)
        if (p, L, root) not in read:
            work += comb(2 * m, m) * L
            within(work, 5 * WORK, "minors")
            read[p, L, root] = zeros_modulo(values[:m], values[m:], p, L)
        found = read[p, L, root]
        period, left = intersected(period, left, L, _deeper(Q, S, found, p, L, root, 0, sign) if sign else found, _MOST)
        need(len(left) < _MOST, "too many times are left")
        for j, (r, K, residue) in enumerate(map(_place, places[:i + 1])):
            a = exponent(period // K, r)
            if a > depths.get(j, 0):
                left, depths[j] = _deeper(Q, S, left, r, K, residue, a, sign), a
    if left:
        singular = _singular_before(Q, S, before)
        alone = [(k, L) for k, r in singular for p, L, root in map(_place, places) if p > 2 and L > k and _alone(Q, S, k, r, p, L, root)]
        need(all(any((t + k) % L == 0 for k, L in alone) for t in left), f"nothing excludes an escape at times {left[0]} modulo {period}")


def _place(data: Any) -> tuple[Any, Any, Any]:
    need(len(data) in (2, 3), "a place is a prime, a period and, for algebraic data, a residue")
    return data[0], data[1], data[2] if len(data) == 3 else None


def intersected(M: int, first: Iterable[int], L: int, second: Iterable[int], most: int | None = None) -> tuple[int, list[int]]:
    """The integers congruent to one of the first modulo M and to one of the second modulo L: a period and residues, at most so many."""
    common = gcd(M, L)
    by_rest: dict[int, list[int]] = {}
    for t in second:
        by_rest.setdefault(t % common, []).append(t)
    u = pow(M // common, -1, L // common) if L > common else 0
    left = (s + M * ((t - s) // common * u % (L // common)) for s in first for t in by_rest.get(s % common, ()))
    return M // common * L, list(islice(left, most))


def exponent(n: int, p: int) -> int:
    """How often p divides n."""
    a = 0
    while n % p == 0:
        n, a = n // p, a + 1
    return a


def _deeper(Q: list, S: list, left: Collection[int], p: int, L: int, root: int | None, a: int, sign: int) -> list[int]:
    """The times with det X_t = 0, or with X_t u = 0 and Y_t u = sign Ku, also modulo p^{a+1}, where S_m^L = I modulo p; see statements 5 and 6.

    S^t is a product of powers S^{d 32^i}, 0 <= d < 32, from a table.
    """
    N, m, period = p ** (a + 1), len(Q) - 1, L * p**a
    within(len(left) * 4 * m**3 * (1 + period.bit_length() // 5), 5 * WORK, "products of matrices")
    values = reading([*Q[-2::-1], *S[-2::-1]], p, root, a + 1)
    base, table = step_matrix(values[:m], values[m:], N), []
    for _ in range(0, period.bit_length(), 5):
        columns = [list(c) for c in zip(*base, strict=True)]
        powers = [[[int(i == j) for j in range(2 * m)] for i in range(2 * m)]]
        for _ in range(32):
            powers.append(_product(powers[-1], columns, N))
        base = powers.pop()
        table.append(powers)
    K = intertwiner(values[:m], values[m:], N)

    def vanishes(t: int) -> bool:
        t, columns = t % period, [[int(i == j) for j in range(2 * m)] for i in range(m)]
        for powers in table:
            t, d = divmod(t, 32)
            columns = _product(columns, powers[d], N) if d else columns
        if not sign:
            return minors([column[:m] for column in columns], N)[0] == 0
        less = [[*column[:m], *((y - sign * k) % N for y, k in zip(column[m:], row, strict=True))] for column, row in zip(columns, K, strict=True)]
        return has_null_vector(less, p, N)

    return [t for t in left if vanishes(t)]


def intertwiner(q: list[int], g: list[int], N: int) -> list[list[int]]:
    """The symmetric K of statement 6 modulo N: Ke_1 = g, and e_{i+1} = A'e_i + q_i e_1, so Ke_{i+1} = AKe_i + q_i g."""
    image, rows = list(g), list[list[int]]()
    for i in range(len(q)):
        rows.append(image)
        moved = [(x - q[k] * image[0]) % N for k, x in enumerate([*image[1:], 0])]
        image = [(x + q[i] * y) % N for x, y in zip(moved, g, strict=True)]
    return rows


def has_null_vector(columns: list[list[int]], p: int, N: int) -> bool:
    """Whether a combination of the columns, not all coefficients divisible by p, is zero modulo a power N of p: the last elementary divisor is zero."""
    columns = [list(c) for c in columns]
    power = 1
    while columns:
        pivot = next(((k, i) for k, c in enumerate(columns) for i, x in enumerate(c) if x % (power * p)), None)
        if pivot is None:  # every entry that is left is divisible by the next power
            power *= p
            if power == N:
                return True
            continue
        k, i = pivot
        first = columns.pop(k)
        inverse = pow(first[i] // power, -1, N)
        for c in columns:
            u = c[i] // power * inverse
            c[:] = [(x - u * y) % N for x, y in zip(c, first, strict=True)]
    return False


# ---------------------------------------------------------------------- modulo N
def reading(values: list, p: int, root: int | None = None, power: int = 1) -> list[int]:
    """Numbers modulo a power of a prime; algebraic ones by a zero modulo p of the modulus of their field; see statement 4."""
    field = next((x.field for x in values if isinstance(x, Algebraic)), None)
    if field is None:
        need(root is None, "rational data have no generator")
        return modular(values, p**power)
    need(field.irreducible, "the modulus of the field is not known to be irreducible")
    if type(root) is not int:
        raise Undefined("the residue of the generator is missing")
    need(type(p) is int and 1 < p < 10**11 and all(p % r for r in range(2, isqrt(p) + 1)), "a place is not a prime")
    modulus = modular([Fraction(c) / field.modulus[-1] for c in field.modulus], p**power)
    value = _horner(modulus, root, p**power)
    need(value % p == 0, f"the residue of the generator is no zero modulo {p}")
    if power > 1:  # Hensel's lemma
        slope = _horner([k * c for k, c in enumerate(modulus)][1:], root, p)
        need(slope != 0, f"the residue of the generator is no simple zero modulo {p}")
        for _ in range(power - 1):  # each time for one more power
            root = (root - _horner(modulus, root, p**power) * pow(slope, -1, p)) % p**power
    return [_horner(modular(x.c, p**power), root, p**power) if isinstance(x, Algebraic) else modular([x], p**power)[0] for x in values]


def _horner(f: list[int], x: int, N: int) -> int:
    acc = 0
    for c in reversed(f):
        acc = (acc * x + c) % N
    return acc


# ---------------------------------------------------------------------- powers of the symplectic matrix
def zeros_modulo(q: list[int], g: list[int], p: int, L: int) -> set[int]:
    """The t from 0 to L - 1 with det X_t = 0 modulo p, where S_m^L = I modulo p.

    With S^{i + jB} in two parts, det X is a sum of products of minors (Cauchy and Binet). For one j the sums for all i come from
    products with integers that hold one minor for all i, 64 bits each, which none of the sums exceeds.
    """
    S, size = step_matrix(q, g, p), isqrt(L) + 1
    m, eye = len(q), [[int(i == j) for j in range(2 * len(q))] for i in range(2 * len(q))]
    within(comb(2 * m, m) * size, MINORS, "minors")
    need(comb(2 * m, m) * p * p < 1 << 64, "the minors are too many")
    top, rows = [minors(eye[:m], p)], [list(row) for row in zip(*S, strict=True)]
    power = eye[:m]
    for _ in range(size - 1):
        power = _product(power, rows, p)
        top.append(minors(power, p))
    leap = _power(S, size, p)
    need(_product(_power(leap, L // size, p), [list(c) for c in zip(*_power(S, L % size, p), strict=True)], p) == eye, f"S is not of order {L} modulo {p}")
    packed = [sum(x << 64 * i for i, x in enumerate(column)) for column in zip(*top, strict=True)]
    columns, found = eye[:m], set()  # the first m columns of S^{jB}, as rows
    for start in range(0, L, size):
        sums = sum(map(mul, packed, minors(columns, p)))
        found |= {start + i for i, (x,) in enumerate(iter_unpack("<Q", sums.to_bytes(8 * size, "little"))) if x % p == 0}
        columns = _product(columns, leap, p)
    return {t for t in found if t < L}


def minors(rows: list[list[int]], p: int) -> list[int]:
    """The minors of all rows modulo p, in an order that depends on the shape only."""
    found = {0: 1}
    for row in rows:
        following: dict[int, int] = {}
        for chosen, value in found.items():
            for j, x in enumerate(row):
                if not chosen >> j & 1:
                    sign = -1 if (chosen >> j).bit_count() & 1 else 1
                    following[chosen | 1 << j] = following.get(chosen | 1 << j, 0) + sign * value * x
        found = {k: v % p for k, v in following.items()}
    return [found[k] for k in sorted(found)]


def _product(A: list[list[int]], columns: list[list[int]], p: int) -> list[list[int]]:
    """A B modulo p, B given by its columns."""
    return [[sum(map(mul, row, column)) % p for column in columns] for row in A]


def _power(A: list[list[int]], k: int, p: int) -> list[list[int]]:
    out = [[int(i == j) for j in range(len(A))] for i in range(len(A))]
    columns = [list(c) for c in zip(*A, strict=True)]
    for bit in bin(k)[2:]:
        out = _product(out, [list(c) for c in zip(*out, strict=True)], p)
        if bit == "1":
            out = _product(out, columns, p)
    return out


def step_matrix(q: list[int], g: list[int], N: int) -> list[list[int]]:
    """S_m modulo N."""
    need(gcd(q[-1], N) == 1, f"S is singular modulo {N}")
    return [[x % N for x in row] for row in symplectic(q, g, pow(q[-1], -1, N))]


def symplectic(q: list, g: list, unit: Any) -> list[list]:
    """S_m over any ring, unit the inverse of q_m: (X; Y) -> (A'^-1 (X - hh'Y); gg'X' + AY), A = J - qh', X' the new X."""
    m = len(q)
    X = [[int(i == j) for j in range(2 * m)] for i in range(m)]
    Y = [[int(i + m == j) for j in range(2 * m)] for i in range(m)]
    W = [[x - y for x, y in zip(X[0], Y[0], strict=True)], *X[1:]]
    last = [-x * unit for x in W[0]]  # row i of A'V is row i - 1 of V; row 0 is -q'V
    for i in range(m - 1):
        last = [x - q[i] * unit * y for x, y in zip(last, W[i + 1], strict=True)]
    new_x = [*W[1:], last]
    along = [_dot(g, column) for column in zip(*new_x, strict=True)]
    new_y = [[g[i] * s - q[i] * y + (Y[i + 1][j] if i + 1 < m else 0) for j, (s, y) in enumerate(zip(along, Y[0], strict=True))] for i in range(m)]
    return new_x + new_y


# ---------------------------------------------------------------------- times before the start
def backward(X: list, Y: list, q: list, g: list) -> tuple[list, list]:
    """The plane before: Y = A^-1 (Y' - gg'X'), X = A'X' + hh'Y."""
    m = len(q)
    along = [_dot(g, column) for column in zip(*X, strict=True)]
    R = [[y - g[i] * s for y, s in zip(Y[i], along, strict=True)] for i in range(m)]
    top = [-r / q[-1] for r in R[-1]]  # A v = r: v_{i+1} = r_i + q_i v_1
    new_y = [top, *([r + q[i] * t for r, t in zip(R[i], top, strict=True)] for i in range(m - 1))]
    new_x = [[-_dot(q, column) for column in zip(*X, strict=True)], *X[:-1]]
    new_x[0] = [x + y for x, y in zip(new_x[0], new_y[0], strict=True)]
    return new_x, new_y


def _dot(x: Iterable, y: Iterable) -> Any:
    first, *rest = map(mul, x, y)
    return sum(rest, first)


def _singular_before(Q: list, S: list, before: Any) -> list[tuple[int, int]]:
    """The k of those named with det X_{-k} = 0, and the dimension of the kernel of X_{-k}, exactly."""
    need(all(type(k) is int and 0 < k < 1000 for k in before), "times before the start are positive numbers")
    q, g, zero = Q[-2::-1], S[-2::-1], Q[-1] - Q[-1]
    X: list = [[zero + int(i == j) for j in range(len(q))] for i in range(len(q))]
    Y: list = [[zero] * len(q) for _ in q]
    found = []
    for k in range(1, max(before, default=0) + 1):
        X, Y = backward(X, Y, q, g)
        if k in before and (r := len(q) - len(echelon(Matrix(X))[1])):
            found.append((k, r))
    return found


def _alone(Q: list, S: list, k: int, r: int, p: int, L: int, root: int | None) -> bool:
    """Whether det X_{L-k} is not zero modulo p^{r+1}; see statement 3, where the kernel of X_{-k} and S^L = I modulo p are known."""
    m, N = len(Q) - 1, p ** (r + 1)
    values = reading([*Q[-2::-1], *S[-2::-1]], p, root, r + 1)
    X = [row[:m] for row in _power(step_matrix(values[:m], values[m:], N), L - k, N)[:m]]
    return char_coefficients(Matrix(X))[0] % N != 0
