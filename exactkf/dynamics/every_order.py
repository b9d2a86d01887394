# SPDX-License-Identifier: MIT
r"""What the fast filter of any order does, decided exactly.

Main definitions
----------------
``decide``        the answer for a state :math:`(a, g)`
``limit_digits``  the digits of the limit
``rate_digits``   the digits of the rate
``LimitDigits``   what `limit_digits` returns
``state_of``      the state behind an answer

Main statements
---------------
The statements and their proofs are those of `exactkf.kernel.orbit_n`, whose functions
decide here as well.  For the coprime pair that is left after reduction, with :math:`Q(0) \ne 0`:

* If `D` has only zeros of even multiplicity on the unit circle, the orbit escapes at one of finitely
  many steps or converges to :math:`(w, 0)`, `w` the stable spectral factor of `D`.  As
  :math:`r_t` tends to a limit that is not zero, :math:`|\gamma_t| < 1` from some step on; the first such step is one after the
  last with :math:`|\gamma_t| > 1`. There it enters the positive real region, if `D` has no zero on the circle and the common
  factor has all zeros inside; otherwise it never does.
  BLZ94 Theorem 7.1 says this of :math:`w\theta`, :math:`\theta` the common factor.  No
  condition on the initial subspace is left over: coprime data never meet the codominant subspace (BLZ94 Lemma 6.12).
* If `D` changes sign on the circle the orbit never converges.  It is periodic if and only if the zeros
  of `D` are distinct roots of unity; its period is then the least common multiple of their
  orders.  If steps were needed to come to :math:`Q(0) \ne 0`, it is eventually periodic and never comes back to its start.
  With :math:`S_m^p = -I` for half of it, `a` and `b` are exchanged after `p` steps.
* Otherwise the orbit fills a torus in the limit.  That it never escapes is decided where a modulus shows it, or valuations; that is
  a question about zeros of linear recurring sequences, for which no general method is known.  What it does is decided all the same.

The positive real region is that of BLZ94 (2.13)-(2.15), the region :math:`\mathcal P_n` of its Section 5: `D` is positive on the circle,
and `a` and `b`, common factors included, have all zeros inside; for order one it is the open diamond of BLM91, Fig. 1.  The function
:math:`v = b/2a`, in which common factors cancel, can have :math:`\operatorname{Re} v \ge 0` outside the circle for a state that is not in it.

References
----------
BLZ94 Theorem 7.1, Corollary 7.2, Lemmas 6.7-6.12, Proposition 8.1.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import cached_property
from itertools import islice
from math import lcm
from typing import Any, NamedTuple

from flint import arb, fmpq, fmpq_poly, fmpz

from exactkf._errors import BadInput
from exactkf.dynamics.answer import Answer, Fact
from exactkf.dynamics.dominance import dominating
from exactkf.dynamics.enclosed_limit import EnclosedLimit
from exactkf.dynamics.exact_json import element_json, field_json, number_json, number_latex, number_words
from exactkf.dynamics.irreducible import irreducible_at
from exactkf.dynamics.order_one_facts import of_field
from exactkf.dynamics.sieve import places_of_signs
from exactkf.dynamics.spectral_factor import Factor, factor_json, number_of_choices, spectral_factor
from exactkf.dynamics.speed import Speed, rate_ball, speed
from exactkf.dynamics.torus import torus_evidence
from exactkf.dynamics.wandering import (
    Readings,
    aperiodic_place,
    apparent_orders,
    common_period,
    convergence_modulo,
    escape_seen,
    escapes_before,
    modulus_without_escape,
    no_escape_modulo,
    places_without_escape,
    primes,
)
from exactkf.dynamics.zeros import circle_points
from exactkf.exact._messages import MOST_DIGITS, bad, check_count
from exactkf.exact.balls import precision
from exactkf.exact.circle import sign_on_circle
from exactkf.exact.numberfield import RealField, RealNumber
from exactkf.exact.polynomials import count_roots
from exactkf.kernel.intervals import does_not_escape
from exactkf.kernel.numbers import Undefined
from exactkf.kernel.orbit_n import Reduced, coprime, is_bounded, power_of_z, reduce_pair, spectral_polynomial, spectral_sign, start_pair, step
from exactkf.kernel.orbit_polynomial import check_by_polynomials
from exactkf.kernel.replay import seal
from exactkf.kernel.roots import count_circle, times_poly
from exactkf.theory._scalars import Scalar, unify_pair
from exactkf.theory.orbits import first_escape, integer_orbit

__all__ = ["LimitDigits", "ball_between", "decide", "limit_digits", "rate_digits", "state_of"]

MAX_STEPS = 2000
_MOST_STEPS = 10**7
_FEW = 60
_MOST_CHOICES, _MOST_BITS = 32, 4096  # degree, and its product with the bits of D, up to which a limit is written as roots, not enclosed
_LARGE, _BILLION = ((1 << 61) - 1, (1 << 89) - 1), 10**9

_SIGNS = {"+": "positive", "0+": "nonnegative, with zeros", "-": "negative", "-0": "nonpositive, with zeros", "+-": "of both signs"}
_LATEX_SIGNS = {"+": "> 0", "0+": r"\ge 0", "-": "< 0", "-0": r"\le 0"}


class _Case(NamedTuple):
    """The question, the pair, what is left of it, and z^m D of that."""

    a: tuple[Any, ...]
    g: tuple[Any, ...]
    Q: list
    S: list
    reduced: Reduced
    D: list
    facts: list[Fact]

    @property
    def rational(self) -> bool:
        return not isinstance(self.a[0], RealNumber)


def decide(a: Sequence[Scalar], g: Sequence[Scalar], *, max_steps: int = MAX_STEPS) -> Answer:
    r"""Return what the orbit of the state :math:`(a, g)` does.

    Parameters
    ----------
    a, g : sequences of rationals or of elements of one `RealField`, length n
        The coefficients below the leading one; :math:`b = a + 2g`.
    max_steps : int, optional
        The number of steps within which the entry into the positive real region, or an escape
        that nothing excludes, is sought.

    Returns
    -------
    Answer
        With a certificate of kind ``orbit``.  "undecided" carries the reason.  For algebraic data, and where it would have
        a degree above 32 or thousands of digits, the limit is enclosed in intervals of 50 digits (`limit_digits` gives more).

    Raises
    ------
    BadInput
        If the lengths differ or an entry is neither rational nor in the field of the others.

    Examples
    --------
    >>> decide([fmpq(-3, 10)], [fmpq(1, 2)]).behaviour
    'converges'
    >>> decide([0, 1], [0, 0]).period
    1
    """
    check_count("max_steps", max_steps, 0, _MOST_STEPS, "what is settled does not need them; more than 10^4 help seldom")
    case = _case(a, g)
    reduced = case.reduced
    if reduced.escape is not None:
        return _escaped(case, reduced.escape)
    if len(reduced.Q) == 1:
        return _convergent(case, "+", max_steps)
    shape = _sign(case.D)
    _describe(case, shape)
    if shape != "+-":
        return _convergent(case, shape, max_steps)
    pair = Readings.of(reduced.Q, reduced.S, case.D)
    aperiodic = aperiodic_place(pair)
    period = _period(case) if aperiodic is None else None
    if period is not None:
        return _returning(case, period)
    return _wandering(case, pair, aperiodic, max_steps)


def _case(a_0: Sequence[Scalar], g_0: Sequence[Scalar]) -> _Case:
    a: Any
    g: Any
    a, g = unify_pair(a=a_0, g=g_0)
    algebraic = isinstance(a[0], RealNumber)
    for name, vector in (("a", a), ("g", g)):
        for i, x in enumerate(vector):
            if not isinstance(x, RealNumber if algebraic else (fmpq, Fraction)) or isinstance(x, RealNumber) and x.field != a[0].field:
                raise BadInput(f"{name}[{i}] = {x}: not in the field of a[0]; pass rationals, or elements of one RealField")
    if not algebraic:
        a, g = (tuple(fmpq(x.numerator, x.denominator) for x in v) for v in (a, g))
    elif all(x.is_rational() for x in (*a, *g)):
        a, g = (tuple(x.rational_value() for x in v) for v in (a, g))
    one = a[0] - a[0] + 1
    Q = [x + y for x, y in zip(a, g, strict=True)][::-1] + [one]
    S = [*g[::-1], one - one]
    reduced = reduce_pair(Q, S)
    facts = [of_field(a[0].field)] if isinstance(a[0], RealNumber) else list[Fact]()
    D = spectral_polynomial(reduced.Q, reduced.S)
    theta = len(reduced.removed) - 1
    if theta and len(reduced.Q) > 1:
        facts.append(Fact(f"{theta} factor{'s' * (theta > 1)} that a and b have in common, or come to have in {reduced.start} steps, "
                          f"stay{'s' * (theta == 1)}; a pair of order {len(reduced.Q) - 1} is left.",
                          f"$\\theta = (a, b)$ has degree ${theta}$ after ${reduced.start}$ steps; a coprime pair of order ${len(reduced.Q) - 1}$ is left."))
    return _Case(a, g, Q, S, reduced, D, facts)


def _describe(case: _Case, shape: str) -> None:
    m = len(case.reduced.Q) - 1
    d = case.D[m:]
    whose = " of that pair" if len(case.reduced.removed) > 1 else ""
    if d[0] != 0:
        kappa, names = [2 * x / d[0] for x in d[1:]], ["kappa_1", *(["..."] * (m > 2)), f"kappa_{m}"][:m + (m > 2)]
        case.facts.append(Fact(f"The invariant{'s' * (m > 1)} {', '.join(names)}{whose} {'are' if m > 1 else 'is'} {', '.join(map(number_words, kappa))}.",
                               f"$(\\kappa_1, \\dots, \\kappa_{{{m}}}) = ({', '.join(map(number_latex, kappa))})${whose}."))
    else:
        case.facts.append(Fact(f"d_0 = 0; the point of projective space{whose} is ({' : '.join(map(number_words, d))}).",
                               f"$d_0 = 0$, $(d_0 : \\dots : d_{{{m}}}) = ({' : '.join(map(number_latex, d))})${whose}."))
    if shape == "+-":
        case.facts.append(Fact(f"D{whose} changes sign on the unit circle: the orbit does not converge.",
                               f"$D(z, z^{{-1}})${whose} changes sign on $|z| = 1$."))
    else:
        case.facts.append(Fact(f"D{whose} is {_SIGNS[shape]} on the unit circle.", f"$D(z, z^{{-1}}) {_LATEX_SIGNS[shape]}${whose} on $|z| = 1$."))


# ---------------------------------------------------------------------- answers
def _answer(case: _Case, behaviour: str, evidence: dict[str, Any], reason: str = "", **fields: Any) -> Answer:
    """The answer; where it converges the limit, with the evidence for it, is found when it is asked for."""
    entries = {"behaviour": behaviour, "facts": tuple(case.facts), "reason": reason, **fields}
    later = _LATER_OF_LIMITS if behaviour == "converges" else _LATER
    return Answer.of_entries(len(case.a), entries, later, (case.a, case.g, evidence))


def _sealed(answer: Answer) -> dict[str, Any]:
    from exactkf.dynamics.certified import parts

    a, g, evidence = answer.__dict__["_start"]
    if answer.behaviour == "converges":
        evidence = {**evidence, **_found(answer).evidence}
    said, more = parts(answer, a, g)
    return seal("orbit", "orbit", {"question": _question(a, g), "answer": {**answer.decided(), **said}}, {**evidence, **more})


def _limit(answer: Answer) -> dict[str, Any]:
    return _found(answer).limit


def _structure(answer: Answer) -> dict[str, Any]:
    from exactkf.dynamics.certified import structure_of

    return structure_of(answer, *answer.__dict__["_start"][:2])


def _speed(answer: Answer) -> Speed:
    """The speed, kept for the other half of it; of an equilibrium there is none."""
    if "_speed" not in answer.__dict__:
        behind = answer.__dict__.get("_behind")  # the structure, if it has been asked for
        D = _case(*answer.__dict__["_start"][:2]).D if behind is None else [*behind.reduced[:0:-1], *behind.reduced]
        circle = [] if len(D) == 1 else behind.circle_zeros if behind is not None and behind.d == behind.reduced else circle_points(D)
        answer.__dict__["_speed"] = Speed(None, None) if answer.period == 1 else speed(D, circle)
    return answer.__dict__["_speed"]


def _rate(answer: Answer) -> Any:
    return _speed(answer).rate


def _slow(answer: Answer) -> int | None:
    return _speed(answer).slow


_LATER = {"certificate": _sealed, "structure": _structure}
_LATER_OF_LIMITS = {**_LATER, "limit": _limit, "rate": _rate, "slow": _slow}


def _found(answer: Answer) -> _Limit | EnclosedLimit:
    """The limit, which may take long to find, kept for the certificate."""
    if "_found" not in answer.__dict__:
        a, g, _ = answer.__dict__["_start"]
        case = _case(a, g)
        exact = len(case.D) == 1 or case.rational and _is_written(case.D)
        answer.__dict__["_found"] = _Limit(case) if exact else EnclosedLimit.of(case.D, case.reduced.removed)
    return answer.__dict__["_found"]


def _is_written(D: Sequence[Any]) -> bool:
    """Whether the limit is written as roots: these have about as many digits as their degree times those of `D`."""
    degree = number_of_choices(D)
    return degree <= _MOST_CHOICES and degree * fmpq_poly(list(D)).numer().height_bits() <= _MOST_BITS


def _question(a: Sequence[Any], g: Sequence[Any]) -> dict[str, Any]:
    if not isinstance(a[0], RealNumber):
        return {"order": len(a), "a": [str(x) for x in a], "g": [str(x) for x in g], "field": None}
    return {"order": len(a), "a": [element_json(x) for x in a], "g": [element_json(x) for x in g], "field": field_json(a[0].field)}


def _escaped(case: _Case, t: int) -> Answer:
    case.facts.append(Fact(f"gamma^2 = 1 at step {t}: there is no next state.", f"$\\gamma_{{{t}}}^2 = 1$."))
    return _answer(case, "escapes", {}, escape=t)


def _convergent(case: _Case, shape: str, max_steps: int) -> Answer:
    entry = _entry(case, max_steps)
    if isinstance(entry, Answer):
        return entry
    missed = _missed(case, shape)
    if missed is None:
        case.facts.append(Fact(f"The orbit is positive real from step {entry} on, so it never escapes.",
                               f"$v_t$ is positive real exactly for $t \\ge {entry}$, hence $|\\gamma_t| < 1$ there."))
    else:
        case.facts.append(Fact(f"From step {entry} on v, without factors in common, has a real part >= 0 outside the circle, so the orbit never escapes.",
                               f"$\\operatorname{{Re}} v_t \\ge 0$ on $|z| > 1$ for $t \\ge {entry}$, without common factors, hence $|\\gamma_t| < 1$ there."))
        case.facts.append(missed)
    fields: dict[str, Any] = {"never_escapes": True, "enters_positive_real": entry if missed is None else None}
    if all(x == 0 for x in case.g):
        fields["period"] = 1
    elif len(case.D) == 1:
        case.facts.append(Fact(f"The orbit rests from step {case.reduced.start} on.", f"$g_t = 0$ for $t \\ge {case.reduced.start}$."))
    case.facts.append(Fact("The limit is the stable spectral factor of D times the factors in common.",
                           r"$\alpha_\infty = \tilde\alpha_\infty\theta$ with $D$ proportional to $|\tilde\alpha_\infty|^2|\theta|^2$ on $|z| = 1$."))
    return _answer(case, "converges", {} if missed is None else {"bounded": entry}, **fields)


def _missed(case: _Case, shape: str) -> Fact | None:
    """Why the orbit, which converges, never comes to the positive real region, or None if it does."""
    removed = case.reduced.removed
    if len(removed) > 1 and count_circle(removed)[0] < len(removed) - 1:
        return Fact("It never is positive real: a and b have a zero in common that is not inside the circle.",
                    r"It never is positive real: $\theta = (a, b)$ has a zero with $|z| \ge 1$.")
    if shape in ("0+", "-0"):
        return Fact("It never is positive real: D has a zero on the circle.", "It never is positive real: $D$ has a zero on $|z| = 1$.")
    return None


class _Limit:
    """The limit of an orbit that converges, found when it is asked for."""

    def __init__(self, case: _Case) -> None:
        self.case = case

    @cached_property
    def factor(self) -> Factor:
        """The spectral factor of D."""
        if len(self.case.D) > 1:
            return spectral_factor(self.case.D)
        field = None if self.case.rational else self.case.a[0].field
        return Factor(field, (fmpq(1) if field is None else field(1),))

    @property
    def limit(self) -> dict[str, Any]:
        """The limit as an answer has it."""
        full = times_poly(self.factor.coefficients, self.case.reduced.removed)
        return {"alpha": [number_json(x) for x in reversed(full[:-1])], "gamma": "0"}

    @property
    def evidence(self) -> dict[str, Any]:
        """The spectral factor in its field, for the checker."""
        return factor_json(self.factor)


def _entry(case: _Case, max_steps: int) -> int | Answer:
    """Return the first step at which the coprime pair is bounded, or an answer if the orbit escapes before or does not arrive.

    That is tested at steps that double in distance.  From the entry on |gamma| < 1, and
    at the step before it |gamma| > 1.
    """
    common = case.reduced.removed
    last, test = -1, 0  # the last step with |gamma| > 1, and the next step to be tested
    for t, (Q, S) in enumerate(_pairs(case)):
        if t >= test:
            if _enters(Q, S, common, case.reduced.start <= t):
                return last + 1
            test = 2 * t - case.reduced.start + 1 if t >= case.reduced.start else t + 1
        lead, first = Q[-1] * Q[-1], S[-2] * S[-2]
        if first == lead:
            return _escaped(case, t)
        if first > lead:
            last = t
        if t >= max_steps:
            break
    return _undecided(case, max_steps, f"the orbit has not escaped in {max_steps} steps, nor come to where |gamma| < 1 for good, "
                                       "as it will if it never escapes; ask with more steps")


def _pairs(case: _Case) -> Any:
    """Yield the orbit as polynomials from z^0 up, as integers up to a factor if it is rational."""
    if case.rational:
        for lead_first, star in integer_orbit(case.a, case.g):
            yield list(lead_first[::-1]), [*star[::-1], fmpz(0)]
        return
    Q, S = case.Q, case.S
    while True:
        yield Q, S
        first = S[-2]
        if first * first == 1:
            return
        Q, S = step(Q, S, first)


def _enters(Q: list, S: list, common: list, late: bool) -> bool:
    """Whether the pair is bounded; late pairs are divided by the known common factor."""
    Q, S = ([fmpq(x) if isinstance(x, fmpz) else x for x in p] for p in (Q, S))
    if late and len(common) > 1:
        Q, S = _quotient(Q, common), _quotient(S, common)
    elif not late:
        Q, S = coprime(Q, S)
    if any(isinstance(x, RealNumber) for x in Q):  # a zero of a quotient is none
        return is_bounded(Q, S)
    return len(Q) == 1 or count_roots(fmpq_poly(Q).numer()).inside == len(Q) - 1 and _sign(spectral_polynomial(Q, S)) in ("+", "0+")


def _sign(D: list) -> str:
    """The sign of D on the circle as `exactkf.kernel.orbit_n.spectral_sign` has it, quicker for rational data."""
    if isinstance(D[0], RealNumber):
        return spectral_sign(D)
    return {"positive": "+", "nonnegative": "0+", "negative": "-", "nonpositive": "-0", "indefinite": "+-"}[sign_on_circle(D[len(D) // 2:])]


def _quotient(p: list, q: list) -> list:
    """Divide exactly by a monic polynomial."""
    p, out = list(p), []
    for _ in range(len(p) - len(q) + 1):
        c = p[-1]
        out.append(c)
        for i, x in enumerate(q):
            p[len(p) - len(q) + i] = p[len(p) - len(q) + i] - c * x
        p.pop()
    return out[::-1]


def _period(case: _Case) -> int | None:
    """Return the least p with z^p = 1 modulo D, if there is one."""
    if case.rational:
        return common_period(case.D) if _is_simple(case.D) else None
    guess = _guess_order(case.D)
    return _least(guess, case.D) if guess and power_of_z(guess, case.D) == [1] else None


def _least(order: int, D: list) -> int:
    """Return the order of z modulo D, a divisor of `order`."""
    for p, _ in fmpz(order).factor():
        while order % int(p) == 0 and power_of_z(order // int(p), D) == [1]:
            order //= int(p)
    return order


def _returning(case: _Case, period: int) -> Answer:
    start = case.reduced.start
    for t, (Q, S) in zip(range(start + period), _pairs(case), strict=False):
        if Q[-1] * Q[-1] == S[-2] * S[-2]:
            return _escaped(case, t)
    case.facts.append(Fact(f"The zeros of D are distinct roots of unity, of orders with least common multiple {period}: "
                           f"the orbit has the period {period}{f' from step {start} on' * (start > 0)}.",
                           f"$S^{{{period}}} = I$: the orbit has the period ${period}${f' from step ${start}$ on' * (start > 0)}."))
    if start:
        case.facts.append(Fact(f"It does not come back to a state before step {start}: up to there the common factor of a and b grows with every step.",
                               f"$\\deg (a, b)$ grows until step ${start}$, so no state before it comes back."))
    evidence: dict[str, Any] = {}
    if not case.rational:
        reduced = reduce_pair(*start_pair(_question(case.a, case.g)))
        evidence["bits"] = next(bits for k in range(12) if does_not_escape(reduced.Q, reduced.S, period, bits := (256 + 4 * period) << k))
    if start:
        return _answer(case, "eventually periodic", evidence, never_escapes=True, period=period, preperiod=start)
    return _answer(case, "periodic", evidence, never_escapes=True, period=period)


def _wandering(case: _Case, pair: Readings, aperiodic: list[Any] | None, max_steps: int) -> Answer:
    seen = escape_seen(pair, min(max_steps, _FEW))
    escape = None if seen is None else _first_escape(case, case.reduced.start + seen)
    if escape is not None:
        return _escaped(case, escape)
    reason = "D changes sign on the circle, so the orbit does not converge; "
    if aperiodic is None:
        return _undecided(case, 0, reason + "its zeros seem to be roots of unity, of an order too large to decide whether it repeats")
    irreducible = {} if pair.field is None else {"irreducible": irreducible_at(pair.field)}
    if irreducible.get("irreducible", 1) is None:
        return _undecided(case, 0, f"{reason}the polynomial of the field of the data, of degree {pair.field.degree if pair.field else 1}, was not shown to be "
                                   "irreducible, as it must be to read the data modulo primes, and nothing else excludes an escape")
    found, reason = _no_escape(case, pair), ""
    if found is None:
        steps = max_steps if case.rational else min(max_steps, _FEW)
        escape = _first_escape(case, steps) if case.rational else None
        if escape is not None:
            return _escaped(case, escape)
        found = _searched(case, pair, steps)
        reason = (f"whether the orbit ever escapes; it does not before step {found['searched']}, and no prime was found, nor several together, that exclude "
                  "it later" + ", which is rare where D has multiple zeros" * (not _is_simple(case.D)))
    case.facts.append(Fact("The zeros of D are not distinct roots of unity: the orbit does not repeat.", r"$S^p \ne I$ for every $p$."))
    dimension, torus, why = torus_evidence(_fractions(case.D) if case.rational else case.D)
    if dimension is None:
        case.facts.append(Fact(f"The dimension of the torus is not decided: {why}.", f"{why}."))
    else:
        case.facts.append(Fact(f"In the limit the orbit fills a torus of dimension {dimension}.",
                               f"The closure of the orbit is, in the limit, a torus of dimension ${dimension}$."))
    evidence = {**found, **irreducible, "aperiodic": aperiodic, "torus": torus}
    return _answer(case, "not convergent, not periodic", evidence, reason, never_escapes=not reason, torus_dimension=dimension)


def _no_escape(case: _Case, pair: Readings) -> dict[str, Any] | None:
    """Evidence that the orbit never escapes, or None if none was found."""
    before = escapes_before(pair)
    N = common_period(case.D) if case.rational else None
    if N is not None:
        try:
            check_by_polynomials(case.reduced.Q, case.reduced.S, case.D, N)
        except Undefined:
            return None
        case.facts.append(Fact(f"The zeros of D are roots of unity, some multiple: along t = k, k + {N}, k + {2 * N}, ... the determinants whose zeros are the "
                               "escapes are polynomials in t, and none vanishes at an integer t >= 0: the orbit never escapes.",
                               f"$S^{{{N}}}$ is unipotent, and the polynomials $\\det X_{{k + {N}s}}$ in $s$ have no zero with $k + {N}s \\ge 0$."))
        return {"order": N}
    if not _is_simple(case.D) and (dominated := _dominated(case, pair)):
        return dominated
    if case.rational and not before and not _is_simple(case.D):
        modulus = modulus_without_escape(_fractions(case.Q), _fractions(case.S))  # with multiple zeros orders modulo p are multiples of p
        if modulus is not None:
            case.facts.append(Fact(f"The orbit does not escape modulo {modulus}, so it never does.",
                                   f"$1 - \\gamma_t^2$ is no multiple of ${modulus}$, so it is never zero."))
            return {"modulus": modulus}
    apart = f", apart from {', '.join(str(-k) for k in before)}, where it would have escaped before the start" if before else ""
    places = places_without_escape(pair, before)
    if places is not None:
        shown = ", ".join(str(p) for p, *_ in places)
        case.facts.append(Fact(f"There is no time at which gamma^2 = 1 modulo {'each of ' * (len(places) > 1)}{shown}{apart}: the orbit never escapes.",
                               f"$\\gamma_t^2 \\equiv 1$ modulo {'each of ' * (len(places) > 1)}${shown}$ has no solution $t \\ge 0$ that lifts."))
        return {"places": places, "before": list(before)}
    reduced = case.reduced
    if pair.integral is not None and (settled := convergence_modulo(_fractions(reduced.Q), _fractions(reduced.S), pair.integral)):
        prime, after = settled
        case.facts.append(Fact(f"From step {reduced.start + after} on gamma vanishes modulo {prime}, and there is no escape before: the orbit never escapes.",
                               f"$\\gamma_t$ is a multiple of ${prime}$ for $t \\ge {reduced.start + after}$, hence $\\gamma_t^2 \\ne 1$."))
        return {"modulus": prime, "after": after}
    if _is_simple(case.D) and (dominated := _dominated(case, pair)):
        return dominated
    signs = places_of_signs(pair, before)
    if signs is None:
        return None
    first, second = (", ".join(str(p) for p, *_ in places) for places in signs)
    case.facts.append(Fact(f"The determinants whose zeros are the escapes have zeros of two kinds: modulo powers of {first} there is no time for one of the "
                           f"first kind{apart}, and modulo powers of {second} none for one of the second: the orbit never escapes.",
                           f"$X_t u = 0$ and $Y_t u = Ku$ modulo powers of ${first}$, or $Y_t u = -Ku$ modulo powers of ${second}$, "
                           "has no solution $t \\ge 0$, $u \\ne 0$ that lifts."))
    return {"signs": signs, "before": list(before)}


def _dominated(case: _Case, pair: Readings) -> dict[str, Any] | None:
    """Evidence from an absolute value at which one product of zeros of D is the largest, or None."""
    if pair.integral is None or (found := dominating(_fractions(case.reduced.Q), _fractions(case.reduced.S), pair.integral)) is None:
        return None
    evidence, steps = found
    p, t = evidence.get("prime"), case.reduced.start + steps
    words, field = (f"in the {p}-adic numbers", f"\\mathbb{{Q}}_{{{p}}}") if p else ("in size", r"\mathbb{C}")
    case.facts.append(Fact(f"In the determinants whose zeros are the escapes one power outgrows all others {words}: "
                           f"none vanishes from step {t} on, and there is no escape before.",
                           f"$\\det X_t$ is a sum of powers, one of them the largest in ${field}$ for $t \\ge {t}$, "
                           f"and not zero for $t < {t}$."))
    return {"dominated": evidence}


def _is_simple(D: Sequence[Any]) -> bool:
    """Whether rational `D` has simple zeros only; True for other data."""
    p = fmpq_poly(list(D)) if not isinstance(D[0], RealNumber) else fmpq_poly([0, 1])
    return p.gcd(p.derivative()).degree() == 0


def _first_escape(case: _Case, steps: int) -> int | None:
    """The escape within so many steps."""
    if case.rational:
        return first_escape(case.a, case.g, steps)
    return next((t for t, (Q, S) in zip(range(steps + 1), _pairs(case), strict=False) if Q[-1] * Q[-1] == S[-2] * S[-2]), None)


def _fractions(values: Sequence[Any]) -> list[Fraction]:
    return [Fraction(int(x.numerator), int(x.denominator)) for x in values]


def _undecided(case: _Case, steps: int, reason: str) -> Answer:
    return _answer(case, "undecided", _searched(case, None, steps), reason)


def _searched(case: _Case, pair: Readings | None, steps: int) -> dict[str, Any]:
    """Evidence that there is no escape in so many steps: modulo a large prime, if one is found, or by exact steps."""
    if case.rational and steps:
        modulus = next((N for N in _LARGE if no_escape_modulo(_fractions(case.Q), _fractions(case.S), steps, N)), None)
        return {"searched": steps, **({"modulus": modulus} if modulus else {})}
    if pair is not None and steps:
        for p, root in islice(((q, r) for q in primes(_BILLION) for r in pair.roots(q)), _FEW):
            Q, S = (pair.read(x, p, root) for x in (case.Q, case.S))
            if Q and S and no_escape_modulo(Q, S, steps, p):
                return {"searched": steps, "modulus": p, "residue": root}
    return {"searched": steps if pair is None else 0}


def _guess_order(D: list) -> int | None:
    """Return a common multiple of the orders that the zeros of D seem to have as roots of unity, from balls."""
    found = apparent_orders(D)
    return None if found is None else lcm(*found)


# ---------------------------------------------------------------------- digits
class LimitDigits(NamedTuple):
    """Balls around the coefficients of the limit."""

    alpha: tuple[arb, ...]


def limit_digits(answer: Answer, digits: int) -> LimitDigits:
    r"""Return the limit :math:`\alpha_\infty` to a number of digits.

    Parameters
    ----------
    answer : Answer
        Of an orbit that converges.
    digits : int
        The relative error of each coefficient is at most ``10**-digits``; where the limit is given in intervals, that of coefficients below one is absolute.

    Returns
    -------
    LimitDigits

    Raises
    ------
    BadInput
        If the answer has no limit, or `digits` is not a positive integer.
    """
    _check_asked(answer, digits)
    if answer.limit is None or "alpha" not in answer.limit:
        raise BadInput(f"answer = {answer.behaviour!r}: it has no limit written as numbers; pass the answer for data that converge to such a limit")
    values = answer.limit["alpha"] if isinstance(answer.limit["alpha"], list) else [answer.limit["alpha"]]
    if any(isinstance(x, dict) and "minpoly" not in x for x in values):
        case = _case(*state_of(answer))
        found, bits, *_ = EnclosedLimit.of(case.D, case.reduced.removed).enclosed(digits)
        return LimitDigits(tuple(ball_between(lo, hi, bits) for lo, hi in found))
    numbers = [RealField([0, 1], (0, 0))(fmpq(*map(fmpz, x.split("/")))) if isinstance(x, str) else RealField(x["minpoly"], x["interval"]).gen()
               for x in values]
    return LimitDigits(tuple(x.enclose(digits) for x in numbers))


def rate_digits(answer: Answer, digits: int) -> arb:
    """Return a ball around the rate of an orbit that converges, with relative error at most ``10**-digits``.

    Raises
    ------
    BadInput
        If the answer has no rate, or `digits` is not a positive integer.
    """
    _check_asked(answer, digits)
    if answer.rate is None:
        raise BadInput(f"answer = {answer.behaviour!r}: it has no rate; pass the answer for data that converge faster than 1/t")
    enclosed = isinstance(answer.rate, dict) and "minpoly" not in answer.rate  # never so in order one
    return rate_ball(answer.rate, _case(*state_of(answer)).D if enclosed else [], digits)


def _check_asked(answer: Any, digits: Any) -> None:
    if not isinstance(answer, Answer):
        raise bad("answer", "is not an Answer", answer, "pass what decide returns")
    check_count("digits", digits, 1, MOST_DIGITS)


def ball_between(lo: int, hi: int, bits: int) -> arb:
    """Return a ball around the interval from lo / 2^bits to hi / 2^bits."""
    with precision(bits + 64):
        return arb(fmpq(lo, 1 << bits)).union(arb(fmpq(hi, 1 << bits)))


def state_of(answer: Answer) -> tuple[Sequence[Any], Sequence[Any]]:
    """Return the state (a, g) of the filter that an answer is about."""
    if start := answer.__dict__.get("_start"):
        first, second = start[:2]
        return (first, second) if isinstance(first, (tuple, list)) else ([first - second], [second + 0 * first])
    question = answer.certificate.get("statement", {}).get("question")
    if question is None:
        raise bad("answer", "does not know its question", answer.behaviour, "pass what analyze or decide returned")
    field = None if question["field"] is None else RealField(question["field"][0], question["field"][1:])
    first, second = ([_element(x, field) for x in question[key]] for key in (("a", "g") if "a" in question else ("alpha", "gamma")))
    return ([x - y for x, y in zip(first, second, strict=True)], second) if "alpha" in question else (first, second)


def _element(x: Any, field: RealField | None) -> Any:
    if field is None:
        return fmpq(*map(fmpz, x.split("/")))
    return field([fmpq(*map(fmpz, c.split("/"))) for c in (x if isinstance(x, list) else [x])])
