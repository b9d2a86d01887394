# SPDX-License-Identifier: MIT
"""Benchmarks of exactkf.exact against bare baselines; run with ``pytest -m benchmark -s tests/benchmarks``.

Timings need a quiet machine, so without ``-m benchmark`` they are skipped.
"""

import time

import pytest
from flint import fmpz_mpoly_ctx

from exactkf.exact import RatField, cyclotomic_real, inertia, ldlt, matrix
from exactkf.exact.polynomials import SturmSequence

pytestmark = pytest.mark.benchmark
NAMES = ("x1", "x2", "x3", "x4", "x5")


@pytest.fixture(autouse=True)
def only_when_asked(request):
    """Skip the timings unless they were selected with ``-m``."""
    if "benchmark" not in request.config.getoption("markexpr", ""):
        pytest.skip("timings run with -m benchmark")


def best_of(n, *functions):
    """Return the shortest of n times of each function, the functions taking turns."""
    best = [float("inf")] * len(functions)
    for _ in range(n):
        for k, function in enumerate(functions):
            start = time.perf_counter()
            function()
            best[k] = min(best[k], time.perf_counter() - start)
    return best


def by_hand(maps, z, one):
    """Compose Möbius maps on a pair of polynomials and take one gcd at the end."""
    num, den = z, one
    for a, b, c, d in maps:
        num, den = a * num + b * den, c * num + d * den
    common = num.gcd(den)
    return num // common, den // common


def by_field(maps, z):
    """Compose Möbius maps with RatFunc, to lowest terms."""
    for a, b, c, d in maps:
        z = (a * z + b) / (c * z + d)
    return z.numerator(), z.denominator()


def sparse_maps(g):
    """Return the maps z -> (x z + 1)/(z + x)."""
    return [(x, 1, 1, x) for x in g]


def dense_maps(g):
    """Return five maps with polynomial coefficients."""
    g = [*g, *g]
    return [(g[i] + g[i + 1], g[i] * g[i + 2] - 1, g[i + 3] + 2, g[i + 4] * g[i] + 3) for i in range(5)]


@pytest.mark.parametrize("family", [sparse_maps, dense_maps])
def test_five_moebius_maps(family):
    """Five maps in 5 variables take at most twice the time of a hand-written pair with one gcd."""
    field = RatField(NAMES)
    ctx = fmpz_mpoly_ctx.get(NAMES, field.ctx.ordering())
    g, G = ctx.gens(), field.gens()
    plain, maps = family(g), family(G)
    num, den = by_hand(plain, g[0], ctx.constant(1))
    assert by_field(maps, G[0]) in ((num, den), (-num, -den))
    base, ours = best_of(200, lambda: by_hand(plain, g[0], ctx.constant(1)), lambda: by_field(maps, G[0]))
    print(
        f"\n{family.__name__}: pair of fmpz_mpoly {base * 1e6:.0f} us, RatFunc {ours * 1e6:.0f} us, x{ours / base:.2f}"
    )
    assert ours <= 2 * base


def test_inertia_is_faster_than_elimination():
    """Inertia by the characteristic polynomial is faster than an exact LDL' factorisation."""
    n = 16
    A = matrix([[(i * j + 3 * i + 3 * j) % 7 - 3 for j in range(n)] for i in range(n)])
    base, ours = best_of(10, lambda: ldlt(A), lambda: inertia(A))
    print(f"\n16x16: ldlt {base * 1e6:.0f} us, inertia {ours * 1e6:.0f} us, x{ours / base:.2f}")
    assert ours <= base


def test_sign_is_faster_than_a_sturm_sequence():
    """The sign of an element of a field of degree 23 is faster than one Sturm sequence of its polynomial."""
    field = cyclotomic_real(47)
    x = field.two_cos(5) + field.two_cos(7) - 1
    base, ours = best_of(20, lambda: SturmSequence(field.minpoly).count(-1, 1), x.sign)
    print(f"\nQ(2cos(2pi/47)): Sturm {base * 1e6:.0f} us, sign {ours * 1e6:.0f} us, x{ours / base:.2f}")
    assert ours <= base
