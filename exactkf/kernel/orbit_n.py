# SPDX-License-Identifier: MIT
r"""Answers about orbits of the fast filter of any order, checked.

An orbit starts at two polynomials, `Q` monic of degree `n` and `S` (the paper's
:math:`Q^*`) of lower degree, and goes on by

    g = S[n-1] / Q[n],   Q, S  <-  Q - g z S,  z S - g Q,

unless g^2 = 1: then it escapes.  A polynomial is its list of coefficients from z^0 up.

Main statements
---------------
D = Q(z)Q(1/z) - S(z)S(1/z) is multiplied by 1 - g^2 in a step.  Common factors of Q and S
stay; if Q(0) = 0, both polynomials are divisible by z after a step.  So `reduce_pair` comes to a
coprime pair of order m with Q(0) != 0, or to S = 0, an equilibrium, or to an escape.

For such a coprime pair let S_m be the symplectic matrix of order 2m whose powers carry the
Riccati equation (BLZ94 (6.8)); its characteristic polynomial is proportional to z^m D.

1. S_m has one Jordan block for each eigenvalue, and Im(I; 0) meets no S_m-invariant
   Lagrangian subspace, real or complex: for (x; 0) in such a subspace W the form of (x; 0) and
   its image is (g'x)(g'A'^-1 x) = 0; a vector space is not the union of two proper subspaces,
   so one factor vanishes on all of W, W is invariant under A' or its inverse, and is zero
   because (A, g) is reachable.
2. If every zero of D on the circle has even multiplicity, S_m^t Im(I; 0) tends to the dominant
   subspace, so the orbit escapes or tends to the only equilibrium (w, 0) with
   D proportional to w(z) w(1/z) and no zero of w outside the closed disc (BLZ94 Theorem 7.1).
3. If D >= 0 and all zeros of Q lie inside the circle, S/Q is bounded by one outside the
   circle (v = (Q+S)/2(Q-S) has real part >= 0 there); then g^2 < 1 from there on, by Schwarz' lemma.
   The positive real region is smaller: D > 0 on the circle, and all zeros of a = Q - S inside, for the pair
   with its common factor (BLZ94 (2.13), (2.14)). With D > 0, |S| < |Q| on the circle, so Q and Q - S have as many zeros
   inside, by Rouche. D only takes up factors in a step, and the common factor only factors z; so an orbit as in 2
   comes to the region if and only if the D of the coprime pair and the common factor have no zero on the circle and
   the common factor none outside, and then at the very step at which the coprime pair is bounded as above.
4. If D changes sign on the circle the orbit tends to no equilibrium, for D would be a
   multiple of |w|^2.
5. The orbit has a period p if and only if S_m^p = I: periodicity makes (S_m^p - c)^j Im(I; 0),
   the last one that is not zero, a part of an invariant isotropic subspace, which 1 forbids;
   so S_m^p = c, c = 1 or -1, and Q, S return with the sign c of S.  The states before the reduced
   pair do not: as long as Q(0) = 0 the common factor of Q and S grows in every step, and afterwards never.
6. What holds in the integers modulo N: if 1 - g^2 is a unit at every step of the orbit modulo N from some step on, where N divides no denominator,
   1 - g^2 is never zero from there; the orbit modulo N is finite.  Other congruences are in `exactkf.kernel.orbit_sieve`, and
   sums of powers with one that outgrows the others in `exactkf.kernel.orbit_dominated`.

References
----------
BLZ94 Sections 6 and 7; BLM91 (2.25)-(2.28); I. Schur, J. reine angew. Math. 147 (1917).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from math import gcd, lcm
from typing import Any, NamedTuple

from exactkf.kernel.algebraic import Algebraic, AlgebraicField
from exactkf.kernel.intervals import Interval, around, does_not_escape, is_schur, product
from exactkf.kernel.irreducible import check_irreducible
from exactkf.kernel.limits import BITS, ORDER, STEPS, WORK, within
from exactkf.kernel.numbers import Undefined, divide, fraction, need, sign
from exactkf.kernel.orbit_dominated import last_escape
from exactkf.kernel.orbit_polynomial import check_by_polynomials
from exactkf.kernel.orbit_sieve import check_never_singular, reading
from exactkf.kernel.orbit_wandering import check_never_escapes, check_torus, has_infinite_order, modular_step
from exactkf.kernel.roots import circle_sign_of, count_circle, count_real, divmod_poly, gcd_poly, times_poly, value_at
from exactkf.kernel.spectral import check_circle_part, enclosed_factor

__all__ = ["Reduced", "check_orbit", "coprime", "exact_factor", "factor_within", "is_around", "is_bounded", "number", "power_of_z", "reduce_pair",
           "same_number", "spectral_polynomial", "spectral_sign", "start_pair", "state_at", "states", "step"]

_FIELDS = ("order", "behaviour", "escape", "never_escapes", "limit", "rate", "monotone_from", "region", "period", "preperiod",
           "torus_dimension", "enters_positive_real")


class Reduced(NamedTuple):
    """The coprime pair at step `start`, the product of all factors taken out, and the escape on the way."""

    start: int
    Q: list
    S: list
    removed: list
    escape: int | None


def check_orbit(question: Mapping[str, Any], answer: Mapping[str, Any], evidence: Mapping[str, Any]) -> None:
    """Accept the answer if it follows from the question.

    Parameters
    ----------
    question : mapping
        ``{"a": [...], "g": [...]}`` and, for algebraic data, ``"field": [modulus, lo, hi]``; numbers
        are "p/q" or lists of coefficients in theta.
    answer : mapping
        The fields of `exactkf.dynamics.answer.Answer` that are decided.
    evidence : mapping
        Hints: the field and the spectral factor of the limit, moduli, exponents.

    Raises
    ------
    Undefined
        With the step that does not follow.
    """
    need(set(answer) == set(_FIELDS), "the answer does not have the fields of an answer")
    Q, S = start_pair(question)
    n = len(Q) - 1
    need(type(answer["order"]) is int and answer["order"] == n, f"the order is {n}")
    need(answer["rate"] is None and answer["monotone_from"] is None and answer["region"] == "", "a field that is not decided is filled")
    behaviour = answer["behaviour"]
    need(behaviour in _CHECKS, f"behaviour {behaviour!r} is not decided for every order")
    required = _REQUIRED[behaviour]
    filled = {k for k in ("escape", "limit", "period", "preperiod", "torus_dimension", "enters_positive_real") if answer[k] is not None}
    need(required[0] <= filled <= required[0] | required[1], f"{behaviour!r} goes with other fields than {sorted(filled)}")
    never = behaviour in ("converges", "periodic", "eventually periodic", "not convergent, not periodic")
    need(answer["never_escapes"] is never or behaviour == "not convergent, not periodic" and answer["never_escapes"] is False,
          "never_escapes does not go with the behaviour")
    _CHECKS[behaviour](Q, S, answer, evidence)


# ---------------------------------------------------------------------- the orbit
def number(x: Any, field: AlgebraicField | None) -> Any:
    """A number of a certificate, of the field if there is one."""
    if isinstance(x, list):
        need(field is not None, "an algebraic number needs the field")
        return field.element([fraction(c) for c in x])  # type: ignore[union-attr]
    need(isinstance(x, str), "a number is a string p/q")
    return field.element([fraction(x)]) if field is not None else fraction(x)


def _field(data: Any) -> AlgebraicField | None:
    return None if data is None else AlgebraicField.of(data)


def start_pair(question: Mapping[str, Any]) -> tuple[list, list]:
    """The two polynomials of a question."""
    need({"a", "g"} <= set(question) <= {"a", "g", "field", "order"}, "the question is not a pair a, g")
    field = _field(question.get("field"))
    a, g = ([number(x, field) for x in question[k]] for k in ("a", "g"))
    need(len(a) == len(g) > 0, "a and g are of different or zero length")
    within(len(a), ORDER, "the order")
    need(question.get("order", len(a)) == len(a), "the order is not the length of a")
    one = number("1", field)
    return [x + y for x, y in zip(a, g, strict=True)][::-1] + [one], g[::-1] + [one - one]


def step(Q: list, S: list, g: Any) -> tuple[list, list]:
    """The next monic pair."""
    r = 1 - g * g
    moved = [S[-1], *S[:-1]]
    pairs = list(zip(Q, moved, strict=True))
    return [divide(x - g * y, r) for x, y in pairs], [divide(y - g * x, r) for x, y in pairs]


def states(Q: list, S: list) -> Iterator[tuple[list, list]]:
    """The orbit, each pair up to a common factor; it ends with the pair that escapes.

    Rational pairs are kept as integers: after a step without fractions the leading coefficient
    before the last divides everything, which is tested and not assumed.
    """
    work = 0
    if any(isinstance(x, Algebraic) for x in Q):
        while True:
            work += sum(map(_bits, [*Q, *S]))
            within(work, WORK, "bits of the states of the orbit")
            yield Q, S
            g = S[-2] / Q[-1]
            if g * g == 1:
                return
            Q, S = step(Q, S, g)
    d = lcm(*(x.denominator for x in [*Q, *S]))
    Q, S = [int(x * d) for x in Q], [int(x * d) for x in S]
    divisor, following = 1, 1
    while True:
        work += sum(map(_bits, [*Q, *S]))
        within(work, WORK, "bits of the states of the orbit")
        yield Q, S
        if Q[-1] ** 2 == S[-2] ** 2:
            return
        lead, first = Q[-1], S[-2]
        moved = [0, *S[:-1]]
        pairs = [divmod(lead * x - first * y, divisor) for x, y in zip(Q, moved, strict=True)]
        stars = [divmod(lead * y - first * x, divisor) for x, y in zip(Q, moved, strict=True)]
        if any(r for _, r in pairs + stars):  # cannot happen; the undivided pair is right all the same
            divisor, pairs, stars = 1, [(lead * x - first * y, 0) for x, y in zip(Q, moved, strict=True)], [
                (lead * y - first * x, 0) for x, y in zip(Q, moved, strict=True)]
        Q, S = [q for q, _ in pairs], [q for q, _ in stars]
        divisor, following = following, Q[-1]


def reduce_pair(Q: list, S: list) -> Reduced:
    """Take out common factors and step while Q(0) = 0."""
    zero, t = Q[-1] - Q[-1], 0
    removed = [zero + 1]
    while True:
        common = gcd_poly(Q, S)
        removed = times_poly(removed, common)
        Q = [zero + x for x in divmod_poly(Q, common)[0]]
        S = [zero + x for x in _padded(divmod_poly(S, common)[0] if any(x != 0 for x in S) else [], len(Q))]
        if len(Q) == 1 or Q[0] != 0:
            return Reduced(t, Q, S, removed, None)
        g = S[-2]
        if g * g == 1:
            return Reduced(t, Q, S, removed, t)
        Q, S = step(Q, S, g)
        t += 1


def _padded(p: list, length: int) -> list:
    return [*p, *[0] * (length - len(p))]


def spectral_polynomial(Q: list, S: list) -> list:
    """z^m D, of degree 2m."""
    return [x - y for x, y in zip(times_poly(Q, Q[::-1]), times_poly(S, S[::-1]), strict=True)]


def spectral_sign(D: list) -> str:
    """The sign of D on the circle, from z^m D."""
    return circle_sign_of(D)


# ---------------------------------------------------------------------- behaviours
def _escapes(Q: list, S: list, answer: Mapping[str, Any], evidence: Mapping[str, Any]) -> None:
    """Step exactly; the orbit ends where the answer says."""
    T = _step_number(answer["escape"], "escape")
    count = 0
    for count, (q, _) in enumerate(states(Q, S)):
        if count > T:
            break
        need(q[-1] != 0, "a leading coefficient is zero")
    need(count == T and _is_escape(Q, S, T), f"the orbit does not escape at step {T}")


def _is_escape(Q: list, S: list, T: int) -> bool:
    q, s = state_at(Q, S, T)
    return s[-2] * s[-2] == q[-1] * q[-1]


def state_at(Q: list, S: list, T: int) -> tuple[list, list]:
    """The pair at step T, up to a common factor."""
    for t, state in enumerate(states(Q, S)):
        if t == T:
            return state
    raise Undefined(f"the orbit escapes before step {T}")


def _converges(Q: list, S: list, answer: Mapping[str, Any], evidence: Mapping[str, Any]) -> None:
    reduced = reduce_pair(Q, S)
    need(reduced.escape is None, f"the orbit escapes at step {reduced.escape}")
    m = len(reduced.Q) - 1
    D = spectral_polynomial(reduced.Q, reduced.S)
    shape = spectral_sign(D) if m else "+"
    need(shape in ("+", "0+", "-", "-0"), "D changes sign on the circle")
    need((answer["period"] is not None) == (not any(x != 0 for x in S)), "an equilibrium, and nothing else that converges, has period one")
    need(answer["period"] is None or _step_number(answer["period"], "period") == 1, "an equilibrium has period one")
    T = answer["enters_positive_real"]
    need((T is not None) == (shape in ("+", "-") and _is_schur(reduced.removed)), "the orbit comes to the positive real region exactly if D has no zero "
          "on the circle and a and b have no zero in common that is not inside")
    _settles(Q, S, reduced, _step_number(evidence["bounded"], "bounded") if T is None else _step_number(T, "enters_positive_real"))
    if answer["limit"] is not None:
        _limit(reduced, D, answer["limit"], evidence)


def _settles(Q: list, S: list, reduced: Reduced, T: int) -> None:
    """The pair at step T is bounded, and the one before is not."""
    late = T >= reduced.start
    first = reduced.start if late else 0
    before: tuple[list, list] | None = None
    state: tuple[list, list] | None = None
    if late and first:
        before = state_at(Q, S, first - 1) if T == first else None
    if late and len(reduced.Q) == 1:
        need(T == first or T == 0, "the orbit rests before that step")
        state = (reduced.Q, [0])
    else:
        for t, pair in enumerate(states(reduced.Q, reduced.S) if late else states(Q, S), first):
            if t == T - 1:
                before = pair
            if t == T:
                state = pair
                break
    need(state is not None, f"the orbit escapes before step {T}")
    need(T == 0 or before is not None and sign(before[1][-2] * before[1][-2] - before[0][-1] * before[0][-1]) > 0,
          "the orbit had settled a step earlier")
    q, s = state  # type: ignore[misc]
    if not late:
        q, s = coprime(q, s)
    need(is_bounded(q, s), f"the orbit has not settled at step {T}")


def coprime(Q: list, S: list) -> tuple[list, list]:
    q, s = ([Fraction(x) if isinstance(x, int) else x for x in p] for p in (Q, S))
    common, zero = gcd_poly(q, s), q[-1] - q[-1]
    q = [zero + x for x in divmod_poly(q, common)[0]]
    return q, [zero + x for x in _padded(divmod_poly(s, common)[0] if any(x != 0 for x in s) else [], len(q))]


def is_bounded(Q: list, S: list) -> bool:
    """D >= 0 and every zero of Q inside the circle, for a coprime pair."""
    return len(Q) == 1 or spectral_sign(spectral_polynomial(Q, S)) in ("+", "0+") and _is_schur(Q)


def _is_schur(p: list) -> bool:
    return count_circle(p)[0] == len(p) - 1


def _limit(reduced: Reduced, D: list, limit: Any, evidence: Mapping[str, Any]) -> None:
    """The limit is the stable spectral factor of D times the factors taken out."""
    if "center" in evidence:
        _enclosed_limit(reduced, D, limit, evidence)
        return
    w = exact_factor(D, evidence)
    one = w[-1]
    full = times_poly(w, [one * x for x in reduced.removed])
    need(set(limit) == {"alpha", "gamma"} and limit["gamma"] == "0" and len(limit["alpha"]) == len(full) - 1, "the limit is not of the form alpha, 0")
    for claimed, value in zip(limit["alpha"], reversed(full[:-1]), strict=True):
        need(same_number(claimed, value), "the limit is another number than the coefficient of the spectral factor")


def exact_factor(D: list, evidence: Mapping[str, Any]) -> list:
    """The exact monic w of the evidence: D is proportional to w(z) w(1/z), and w has no zero outside the closed disc."""
    field = next((x.field for x in D if isinstance(x, Algebraic)), None) or _field(evidence.get("field"))
    w = [number(x, field) for x in evidence["factor"]]
    need(2 * len(w) == len(D) + 1 and w[-1] == 1, "the spectral factor is not monic of the order of the reduced pair")
    need(w[0] != 0, "the spectral factor vanishes at zero")
    square = times_poly(w, w[::-1])
    need(all(x * D[-1] == y * square[-1] for x, y in zip(square, D, strict=True)), "w(z) w(1/z) is not proportional to D")
    if len(w) > 1:
        stable = is_schur(w) if field is not None and spectral_sign(D) in ("+", "-") else count_circle(w)[2] == 0
        need(stable, "the spectral factor has a zero outside the closed disc")
    return w


def factor_within(D: list, evidence: Mapping[str, Any]) -> tuple[list[Interval], int]:
    """Intervals over 2^bits around the coefficients of the same w, and the bits."""
    field = next((x.field for x in D if isinstance(x, Algebraic)), None)
    e, pairs = [number(x, field) for x in evidence["circle"]], [(fraction(lo), fraction(hi), k) for lo, hi, k in evidence.get("pairs", ())]
    bits, center = evidence["bits"], evidence["center"]
    need(type(bits) is int and 64 <= bits < 1 << 16 and all(type(v) is int for v in center), "the center is not a list of integers")
    check_circle_part(D, e, pairs)
    return enclosed_factor(D, e, pairs, center, bits), bits


def _enclosed_limit(reduced: Reduced, D: list, limit: Any, evidence: Mapping[str, Any]) -> None:
    """The same in intervals."""
    w, bits = factor_within(D, evidence)
    full = product(w, [around(x, bits) for x in reduced.removed], bits)
    need(set(limit) == {"alpha", "gamma"} and limit["gamma"] == "0" and len(limit["alpha"]) == len(full) - 1, "the limit is not of the form alpha, 0")
    for claimed, (lo, hi) in zip(limit["alpha"], reversed(full[:-1]), strict=True):
        need(is_around(claimed, (lo, hi), bits), "the limit is not within the interval")


def is_around(claimed: Any, found: Interval, bits: int) -> bool:
    """A number of the answer is an interval that contains another over 2^bits."""
    if not isinstance(claimed, dict) or set(claimed) != {"interval"}:
        return False
    lo, hi = map(fraction, claimed["interval"])
    return lo <= Fraction(found[0], 1 << bits) and Fraction(found[1], 1 << bits) <= hi


def same_number(claimed: Any, value: Any) -> bool:
    """A number of the answer is the value."""
    if isinstance(claimed, str):
        return value == fraction(claimed)
    need(set(claimed) == {"minpoly", "interval"}, "a number of the limit is not a zero of a polynomial in an interval")
    p, (lo, hi) = [fraction(c) for c in claimed["minpoly"]], (fraction(x) for x in claimed["interval"])
    need(lo < hi and count_real(p, lo, hi) - (value_at(p, hi) == 0) == 1, "an interval of the limit does not hold exactly one root")
    return value > lo and value < hi and value_at(p, value) == 0


def _periodic(Q: list, S: list, answer: Mapping[str, Any], evidence: Mapping[str, Any]) -> None:
    reduced = reduce_pair(Q, S)
    p = _step_number(answer["period"], "period")
    need(reduced.escape is None and len(reduced.Q) > 1, "the pair is not periodic")
    before = 0 if answer["preperiod"] is None else _step_number(answer["preperiod"], "preperiod")
    need(reduced.start == before and (before > 0) == (answer["preperiod"] is not None), f"the orbit comes back to step {reduced.start} first")
    D = spectral_polynomial(reduced.Q, reduced.S)
    D = [divide(c, D[-1]) for c in D]
    need(p > 1 and power_of_z(p, D) == [1], f"the zeros of D are not distinct roots of unity of order {p}")
    primes, rest = list[int](), p
    degree = (len(D) - 1) * (len(D[-1].field.modulus) - 1 if isinstance(D[-1], Algebraic) else 1)
    for q in range(2, degree + 2):  # a root of unity of an order that q divides has degree at least q - 1
        while rest % q == 0:
            primes, rest = [*primes, q], rest // q
    need(rest == 1 and all(power_of_z(p // q, D) != [1] for q in primes), f"a divisor of {p} is a period")
    if isinstance(D[-1], Algebraic):
        need(does_not_escape(reduced.Q, reduced.S, p, evidence["bits"]), "the orbit may escape within a period")
    else:
        count = sum(1 for _, _ in zip(range(p + 1), states(reduced.Q, reduced.S), strict=False))
        need(count == p + 1, "the orbit escapes within a period")


def power_of_z(k: int, modulus: list) -> list:
    """z^k modulo a polynomial of degree at least one, without trailing zeros."""
    out: list[Any] = [1]
    for bit in bin(k)[2:]:
        out = times_poly(out, out)
        if bit == "1":
            out = [0, *out]
        out = divmod_poly([Fraction(x) if isinstance(x, int) else x for x in out], modulus)[1]
        # they do not grow where the zeros are roots of unity; a search with faster types looks out for itself
        within(sum(_bits(x) for x in out if isinstance(x, (Fraction, Algebraic))), BITS, "bits of a power of z")
    return out


def _bits(x: Any) -> int:
    """About as many as an exact number is written with."""
    if isinstance(x, Algebraic):
        return sum(map(int.bit_length, x.whole)) + x.below.bit_length()
    return int(x.numerator).bit_length() + int(x.denominator).bit_length()


def _wanders(Q: list, S: list, answer: Mapping[str, Any], evidence: Mapping[str, Any]) -> None:
    algebraic = next((x for x in Q if isinstance(x, Algebraic)), None)
    if algebraic is not None:
        check_irreducible(algebraic.field, evidence["irreducible"])
    reduced = _nonconvergent(Q, S)
    D = spectral_polynomial(reduced.Q, reduced.S)
    _aperiodic(D, 1 if algebraic is None else len(algebraic.field.modulus) - 1, evidence["aperiodic"])
    if answer["never_escapes"] is False:  # the planes of the powers of S go on after an escape as before
        _searched(Q, S, evidence)
    elif "modulus" in evidence:
        need(algebraic is None, "a modulus alone is for rational data")
        if "after" in evidence:
            Q, S = state_at(reduced.Q, reduced.S, _step_number(evidence["after"], "after"))
            Q, S = ([Fraction(x) / Q[-1] for x in p] for p in (Q, S))
        check_never_escapes(Q, S, evidence["modulus"])
    elif "order" in evidence:
        need(algebraic is None, "polynomials in the time are for rational data")
        check_by_polynomials(reduced.Q, reduced.S, D, evidence["order"])
    elif "dominated" in evidence:
        need(algebraic is None, "sums of powers are for rational data")
        T = last_escape(reduced.Q, reduced.S, evidence["dominated"])
        _searched(reduced.Q, reduced.S, {"searched": T, "modulus": evidence["dominated"]["modulus"]})
    elif "signs" in evidence:
        read: dict[Any, set[int]] = {}
        for sign, places in zip((1, -1), evidence["signs"], strict=True):
            check_never_singular(reduced.Q, reduced.S, places, evidence["before"], sign, read)
    else:
        check_never_singular(reduced.Q, reduced.S, evidence["places"], evidence["before"])
    if answer["torus_dimension"] is not None:
        check_torus(D, _step_number(answer["torus_dimension"], "torus_dimension"), evidence["torus"])


def _aperiodic(D: list, degree: int, place: Any) -> None:
    """The zeros of D are not distinct roots of unity."""
    need(len(place) in (1, 2), "a place is a modulus and, for algebraic data, a residue")
    p, root = place[0], place[1] if len(place) == 2 else None
    need(type(p) is int and p > 1, "a modulus is an integer above one")
    need(has_infinite_order(reading([divide(c, D[-1]) for c in D], p, root), (len(D) - 1) * degree, p), "S may be of finite order")


def _nonconvergent(Q: list, S: list) -> Reduced:
    reduced = reduce_pair(Q, S)
    need(reduced.escape is None and len(reduced.Q) > 1, "the orbit escapes or comes to rest")
    need(spectral_sign(spectral_polynomial(reduced.Q, reduced.S)) == "+-", "D does not change sign on the circle")
    return reduced


def _undecided(Q: list, S: list, answer: Mapping[str, Any], evidence: Mapping[str, Any]) -> None:
    """Nothing is said but that there is no escape in the steps searched."""
    _searched(Q, S, evidence)


def _searched(Q: list, S: list, evidence: Mapping[str, Any]) -> None:
    """No escape in the steps searched, seen modulo N."""
    steps, N = _step_number(evidence["searched"], "searched"), evidence.get("modulus")
    if N is None:
        count = sum(1 for _ in zip(range(steps + 1), states(Q, S), strict=False))
        need(count == steps + 1 and (steps == 0 or not _is_escape(Q, S, steps - 1)), "the orbit escapes in the steps searched")
    else:
        q, s = (reading(p, N, evidence.get("residue")) for p in (Q, S))
        for _ in range(steps):
            r = 1 - s[-2] * s[-2]
            need(gcd(r, N) == 1, "the orbit may escape in the steps searched")
            q, s = modular_step(q, s, N)


_CHECKS = {"escapes": _escapes, "converges": _converges, "periodic": _periodic, "eventually periodic": _periodic,
           "not convergent, not periodic": _wanders, "undecided": _undecided}
# fields that go with a behaviour, and fields that may
_REQUIRED: dict[str, tuple[set[str], set[str]]] = {
    "escapes": ({"escape"}, set()), "converges": (set(), {"enters_positive_real", "limit", "period"}), "periodic": ({"period"}, set()),
    "eventually periodic": ({"period", "preperiod"}, set()),
    "not convergent, not periodic": (set(), {"torus_dimension"}), "undecided": (set(), set()),
}


def _step_number(x: Any, name: str) -> int:
    need(type(x) is int and x >= 0, f"{name} is not a number of steps")
    within(x, STEPS, name)
    return x
