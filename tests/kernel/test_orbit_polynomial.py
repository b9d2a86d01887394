# SPDX-License-Identifier: MIT
"""Orbits with multiple zeros of D that are roots of unity: polynomials in the time exclude an escape, and nothing else does."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest
from flint import fmpq

from exactkf.dynamics.every_order import decide
from exactkf.kernel.numbers import Undefined
from exactkf.kernel.orbit_n import reduce_pair, spectral_polynomial, start_pair
from exactkf.kernel.orbit_polynomial import _has_positive_integer, check_by_polynomials, determinants, interpolated
from exactkf.kernel.replay import Rejected, replay
from tests.dynamics.test_every_order import edited, stepped, times, with_spectrum

#: z^m D: factors of the circle, one of them double
SPECTRA = [([1, 0, 1], [1, -1, 1], [1, -1, 1]), ([1, 1, 1], [1, 0, 1], [1, 0, 1]), ([1, -1, 1], [1, 1], [1, 1]), ([1, 0, 0, 0, 1], [1, 1, 1], [1, 1, 1])]


def starts(count):
    """Rational starts with these spectra."""
    rng, found = random.Random(4), []
    while len(found) < count:
        chi = [fmpq(1)]
        for f in SPECTRA[len(found) % len(SPECTRA)]:
            chi = times(chi, [fmpq(c) for c in f])
        made = with_spectrum(rng, chi[len(chi) // 2:])
        if made is not None:
            found.append(made)
    return found


def test_they_are_decided_as_stepping_says():
    """The orbit escapes as soon as stepping does, or never, with a certificate that replays; another order is rejected."""
    seen = set()
    for a, g in starts(24):
        answer = decide(a, g)
        _, escape = stepped(a, g, 80)
        assert answer.escape == escape
        seen.add(answer.behaviour)
        replay(answer.certificate)
        if "order" in answer.certificate["evidence"]:
            assert answer.torus_dimension == 0
            for N in (1, 0, -12, "12", answer.certificate["evidence"]["order"] + 1, 10**6):
                with pytest.raises(Rejected):
                    replay(edited(answer.certificate, ("evidence", "order"), N))
    assert seen == {"escapes", "not convergent, not periodic"}


def test_an_escape_is_never_excluded():
    """Orbits of this kind that escape are refused at every order."""
    tried = 0
    for a, g in starts(40):
        if decide(a, g).behaviour == "escapes":
            Q, S = start_pair({"a": [str(x) for x in a], "g": [str(x) for x in g]})
            reduced = reduce_pair(Q, S)
            if reduced.escape is None and len(reduced.Q) > 1:
                tried += 1
                with pytest.raises(Undefined):
                    check_by_polynomials(reduced.Q, reduced.S, spectral_polynomial(reduced.Q, reduced.S), 12 if len(a) < 4 else 24)
    assert tried > 0


def test_a_wandering_zero_is_refused():
    """D with a zero that is no root of unity is not for this argument."""
    a, g = [fmpq(-1, 2), fmpq(1)], [fmpq(3), fmpq(1, 3)]
    Q, S = start_pair({"a": [str(x) for x in a], "g": [str(x) for x in g]})
    with pytest.raises(Undefined, match="no root of unity"):
        check_by_polynomials(Q, S, spectral_polynomial(Q, S), 12)


def test_the_parts():
    """Interpolation, positive integer zeros, and determinants back in time that start with one."""
    p = [Fraction(c) for c in (5, Fraction(-1, 3), 0, 2)]
    assert interpolated([sum((c * s**i for i, c in enumerate(p)), Fraction(0)) for s in range(7)]) == p
    for zeros, expected in (((3,), True), ((-3,), False), ((0,), False), ((1, 5), True), ((Fraction(7, 2), 2**40), True), ((Fraction(7, 2), -1), False)):
        f = [Fraction(1)]
        for z in zeros:
            f = [x - z * y for x, y in zip([Fraction(0), *f], [*f, Fraction(0)], strict=True)]
        assert _has_positive_integer(f) is expected
    assert not _has_positive_integer([Fraction(2)])
    a, g = starts(1)[0]
    Q, S = start_pair({"a": [str(x) for x in a], "g": [str(x) for x in g]})
    assert determinants(Q, S, 3)[0] == 1
