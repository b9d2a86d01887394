# SPDX-License-Identifier: MIT
r"""Pictures of filters and their orbits.

Points are computed exactly and rounded once, when they are drawn; a picture
decides nothing.

Main definitions
----------------
``draw_plane``         the (alpha, gamma) plane of order one: regions, corridors, hyperbola, escape lines, orbit
``draw_gamma``         gamma_t against t
``draw_alpha_plane``   the alpha plane of order two for fixed gamma: positive real, sign definite, indefinite
``draw_spectrum``      the eigenvalues of S and the unit circle
``save``               a figure as PNG or SVG
``require_matplotlib`` what to install

Main statements
---------------
For order one :math:`D(e^{i\vartheta}) = 1 + \alpha^2 - \gamma^2 + 2\alpha\cos\vartheta`, so that D is nonnegative on the
circle where :math:`|\gamma| \le |1 - |\alpha||`, nonpositive where :math:`|\gamma| \ge 1 + |\alpha|`, and indefinite
between.  For order two D is a quadratic in :math:`\cos\vartheta`, whose extrema on [-1, 1] are at the ends or at the vertex.

References
----------
BLM91 (3.10)-(3.13), Figures 1-3; BLZ94 section 8, Figures 8.1-8.6.
"""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from flint import fmpq

from exactkf._errors import BadInput, ExactkfError, Unsupported
from exactkf.dynamics.filter import Filter
from exactkf.dynamics.numbers import Number
from exactkf.exact.numberfield import RealNumber
from exactkf.theory.fast_filter import step_ag
from exactkf.theory.invariants import pseudo_polynomial
from exactkf.theory.orbits import exact_orbit, orbit

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["draw_alpha_plane", "draw_gamma", "draw_plane", "draw_spectrum", "require_matplotlib", "save"]

# dark enough for print, and apart for readers who do not see red and green as different
_POSITIVE, _DEFINITE, _NEGATIVE, _INK, _ORBIT = "#9ecae1", "#deebf7", "#fdd9b5", "#333333", "#b2182b"
_LARGEST = 1e6  # a coordinate beyond it is off the picture
_FARTHEST = 1e100  # of a start


def require_matplotlib() -> None:
    """Say how to install matplotlib where it is missing.

    Raises
    ------
    ExactkfError
        If it is.
    """
    if find_spec("matplotlib") is None:
        raise ExactkfError("pictures need matplotlib; install it: python -m pip install matplotlib")


def _figure(width: float = 6.4, height: float = 4.8) -> tuple[Figure, Axes]:
    require_matplotlib()
    import matplotlib
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    matplotlib.rcParams["svg.hashsalt"] = "exactkf"  # the same file each time
    figure = Figure(figsize=(width, height), layout="constrained")
    FigureCanvasAgg(figure)
    return figure, figure.subplots()


def save(figure: Figure, path: str | Path) -> None:
    """Write a figure; the ending .png or .svg says how.

    Raises
    ------
    BadInput
        If the ending is another one, or the folder does not exist.
    """
    path = Path(path)
    if path.suffix.lower() not in (".png", ".svg"):
        raise BadInput(f"argument path = {str(path)!r} ends in neither .png nor .svg; pass a file name that does")
    if not path.absolute().parent.is_dir():
        raise BadInput(f"argument path = {str(path)!r} lies in a folder that does not exist; create it first")
    metadata = {"Date": None} if path.suffix.lower() == ".svg" else None
    figure.savefig(path, dpi=160, metadata=metadata)


def _float(x: Any) -> float:
    """The nearest float, for drawing; infinity beyond all of them."""
    if isinstance(x, RealNumber):
        return float(x.enclose(17).mid())
    try:
        return int(x.p) / int(x.q)
    except OverflowError:
        return float("inf") if x > 0 else float("-inf")


def _drawable(*coordinates: float) -> None:
    """Refuse a start that no picture shows."""
    if not all(abs(x) < _FARTHEST for x in coordinates):
        raise Unsupported(f"a coordinate of the start is beyond {_FARTHEST:g}, too far out to draw")


def _states(filter: Filter, steps: int) -> tuple[list[tuple[tuple, tuple]], int | None]:
    """States (a, g) of the orbit, and the step of escape."""
    if filter.field is None:
        found = exact_orbit(filter.a, filter.g, steps)
    else:
        found = orbit(step_ag, (filter.a, filter.g), steps)
    return list(found.states), found.escape


def draw_plane(filter: Filter, steps: int = 40) -> Figure:
    r"""The plane of order one with its regions, the invariant hyperbola and the orbit.

    Parameters
    ----------
    filter : Filter
        Of order one.
    steps : int
        How far the orbit is drawn.

    Raises
    ------
    BadInput
        If the order is not one.
    """
    if filter.order != 1:
        raise BadInput(f"argument filter has order {filter.order}; the (alpha, gamma) plane is drawn for order one")
    states, escape = _states(filter, steps)
    alpha = np.array([_float(a[0] + g[0]) for a, g in states])  # a = alpha - gamma
    gamma = np.array([_float(g[0]) for a, g in states])
    _drawable(alpha[0], gamma[0])
    figure, axes = _figure(6.4, 6.0)
    seen = np.isfinite(alpha) & (np.abs(alpha) < _LARGEST) & (np.abs(gamma) < _LARGEST)
    typical = max(np.quantile(np.abs(alpha[seen]), 0.9), np.quantile(np.abs(gamma[seen]), 0.9)) if seen.any() else 0
    reach = float(np.clip(1.15 * max(typical, abs(alpha[0]), abs(gamma[0])), 2.5, 12))
    _regions(axes, reach)
    _hyperbola(axes, filter, reach)
    axes.plot(alpha, gamma, "-", color=_ORBIT, lw=0.5, alpha=0.25)
    axes.plot(alpha, gamma, ".", color=_ORBIT, ms=5, label=rf"$(\alpha_t, \gamma_t)$, $t = 0, \dots, {len(states) - 1}$")
    axes.plot(alpha[:1], gamma[:1], "o", mfc="white", mec=_ORBIT, ms=8, label="start")
    if escape is not None:
        axes.plot(alpha[-1:], gamma[-1:], "X", color=_ORBIT, ms=10, label=rf"escape: $\gamma_{{{escape}}}^2 = 1$")
    outside = int(np.sum((np.abs(alpha) > reach) | (np.abs(gamma) > reach)))
    title = rf"order one, $\alpha_0 = {_shown(filter.a[0] + filter.g[0])}$, $\gamma_0 = {_shown(filter.g[0])}$"
    axes.set(xlim=(-reach, reach), ylim=(-reach, reach), xlabel=r"$\alpha$", ylabel=r"$\gamma$",
             title=title + (f"\n{outside} of {len(states)} points lie outside the picture" if outside else ""))
    axes.set_aspect("equal")
    figure.legend(loc="outside lower center", ncols=2, frameon=False, fontsize=9)  # outside: it would hide a region
    return figure


def _shown(x: Number) -> str:
    """A short fraction as it is, anything else to eight digits."""
    x = x.rational_value() if isinstance(x, RealNumber) and x.is_rational() else x
    return str(x) if isinstance(x, fmpq) and len(str(x)) <= 9 else f"{_float(x):.8g}"


def _regions(axes: Axes, reach: float) -> None:
    """Regions I to IV; what stays white are the sign indefinite corridors."""
    far = 2 * reach + 2
    axes.fill([1, 0, -1, 0], [0, 1, 0, -1], color=_POSITIVE, lw=0)
    for s in (1, -1):
        axes.fill([s, s * far, s * far], [0, far - 1, 1 - far], color=_DEFINITE, lw=0)
        axes.fill([0, far, -far], [s, s * (far + 1), s * (far + 1)], color=_NEGATIVE, lw=0)
    for sign in (1, -1):
        for shift in (1, -1):
            axes.plot([-far, far], [sign * -far + shift, sign * far + shift], color=_INK, lw=0.8)
        axes.axhline(sign, color=_INK, lw=0.9, ls=(0, (5, 3)), label=r"escape lines $\gamma = \pm 1$" if sign > 0 else None)
    axes.axvline(0, color=_INK, lw=0.4)
    axes.axhline(0, color=_INK, lw=0.4)
    text: dict[str, Any] = {"ha": "center", "va": "center", "fontsize": 11, "color": _INK, "bbox": {"fc": "white", "ec": "none", "alpha": 0.6, "pad": 1},
                            "zorder": 1.9}  # below the orbit
    for s, index in ((1, "+"), (-1, "-")):
        axes.text(0.45 * s, 0.22, rf"$\mathrm{{I}}_{index}$", **{**text, "fontsize": max(6.0, min(11.0, 30 / reach))})
        if reach > 2.3:
            axes.text(s * 0.8 * reach, 0.45, rf"$\mathrm{{IV}}_{index}$", **text)
            for side in (1, -1):
                axes.text(s * 0.93 * reach, (1 + 0.075 * reach) * side, rf"$\mathrm{{III}}_{index}$", **text)
                axes.text(-s * 0.12 * reach, 0.85 * reach * side, rf"$\mathrm{{II}}_{index}$", **text)  # the index is the sign of kappa
    place = 0.68 * reach
    for side in (1, -1):
        axes.text(place * side, place * side, "corridor", fontsize=8, color=_INK, ha="center", va="center", rotation=45)
        axes.text(place * side, -place * side, "corridor", fontsize=8, color=_INK, ha="center", va="center", rotation=-45)


def _hyperbola(axes: Axes, filter: Filter, reach: float) -> None:
    """The invariant curve 1 + alpha^2 - gamma^2 = (2/kappa) alpha through the start; 2/kappa is rounded once, so that its being zero is not lost."""
    start, g = filter.a[0] + filter.g[0], filter.g[0]
    if start == 0:
        axes.plot([0, 0], [-reach, reach], color="#2166ac", lw=1.4, label=r"$\alpha = 0$, $\kappa = 0$")
        return
    exact = (1 + start * start - g * g) / start  # 2 / kappa
    turned = _float(exact)
    far, u = 2 * reach, np.linspace(-1, 1, 2001)
    if turned**2 > 4:  # branches to the left and to the right, each through its vertex
        low, high = (turned - np.sqrt(turned**2 - 4)) / 2, (turned + np.sqrt(turned**2 - 4)) / 2
        parts = [(x, np.sign(u)) for x in (low - max(low + far, 0) * u**2, high + max(far - high, 0) * u**2)]
    else:
        parts = [(far * u, np.full_like(u, side)) for side in (1.0, -1.0)]
    x = np.concatenate([np.append(x, np.nan) for x, _ in parts])
    y = np.concatenate([np.append(side * np.sqrt(np.maximum(1 + x**2 - turned * x, 0)), np.nan) for x, side in parts])
    label = r"$\kappa = \infty$" if turned == 0 else rf"$\kappa = {_shown(2 / exact)}$"
    axes.plot(x, y, color="#2166ac", lw=1.4, label=f"invariant hyperbola, {label}")


def draw_gamma(filter: Filter, steps: int = 60) -> Figure:
    r"""The Schur parameters :math:`\gamma_t` against t."""
    states, escape = _states(filter, steps)
    gamma = np.array([_float(g[0]) for _, g in states])
    _drawable(gamma[0])
    figure, axes = _figure(6.8, 3.6)
    from matplotlib.ticker import MaxNLocator

    time = np.arange(len(gamma))
    inside = np.max(np.abs(gamma)) <= 4
    for level in (1, -1):
        axes.axhline(level, color=_INK, lw=0.9, ls=(0, (5, 3)))
    axes.axhline(0, color=_INK, lw=0.4)
    axes.plot(time, gamma, "-", color=_ORBIT, lw=0.6, alpha=0.6)
    axes.plot(time, gamma, ".", color=_ORBIT, ms=4)
    if escape is not None:
        axes.plot([escape], gamma[-1:], "X", color=_ORBIT, ms=10)
    if not inside:
        axes.set_yscale("symlog", linthresh=2, linscale=max(1.0, np.log10(np.max(np.abs(gamma[np.isfinite(gamma)]))) / 12))  # room for the lines
    scale = "" if inside else "; linear up to 2, logarithmic beyond"
    end = "" if escape is None else f"; escape at $t = {escape}$"
    axes.set(xlabel="$t$", ylabel=r"$\gamma_t$", title=rf"order {filter.order}, lines at $\gamma = \pm 1${scale}{end}")
    axes.set_xlim(-0.5, max(len(gamma) - 0.5, 1))
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    return figure


def draw_alpha_plane(filter: Filter, reach: float = 4.0) -> Figure:
    r"""The plane of :math:`(\alpha_1, \alpha_2)` for the filter's own :math:`\gamma_0, \gamma_1`.

    Raises
    ------
    BadInput
        If the order is not two, or the coordinates do not exist.
    """
    if filter.order != 2:
        raise BadInput(f"argument filter has order {filter.order}; the alpha plane is drawn for order two")
    found = filter.parameters()
    if found is None:
        raise BadInput("argument filter has no coordinates (alpha, gamma): a Schur parameter of the start is 1 or -1")
    (x0, y0), (g0, g1) = ([_float(v) for v in part] for part in found)
    _drawable(x0, y0, g0, g1)
    reach = float(max(reach, 1.2 * abs(x0), 1.2 * abs(y0)))
    x, y = np.meshgrid(np.linspace(-reach, reach, 801), np.linspace(-reach, reach, 801))
    low, high, stable = _definiteness_order_two(x, y, g0, g1)
    figure, axes = _figure(6.4, 6.0)
    kind = np.where(low >= 0, np.where(stable & (abs(g0) < 1) & (abs(g1) < 1), 3.0, 2.0), np.where(high <= 0, 1.0, 0.0))
    from matplotlib.colors import ListedColormap
    from matplotlib.patches import Patch

    colours = ListedColormap(["white", _NEGATIVE, _DEFINITE, _POSITIVE])
    axes.imshow(kind, origin="lower", extent=(-reach, reach, -reach, reach), cmap=colours, vmin=-0.5, vmax=3.5, interpolation="nearest")
    axes.contour(x, y, np.minimum(np.maximum(low, -1), 1), levels=[0], colors=_INK, linewidths=0.8)
    if (high <= 0).any():
        axes.contour(x, y, np.minimum(np.maximum(high, -1), 1), levels=[0], colors=_INK, linewidths=0.8)
    axes.plot([x0], [y0], "o", mfc="white", mec=_ORBIT, ms=8)
    axes.axhline(0, color=_INK, lw=0.4)
    axes.axvline(0, color=_INK, lw=0.4)
    patches = {3: (_POSITIVE, "positive real"), 2: (_DEFINITE, r"$D \geq 0$ on the circle"), 1: (_NEGATIVE, r"$D \leq 0$ on the circle"),
               0: ("white", "$D$ changes sign")}
    handles = [Patch(fc=colour, ec=_INK, label=label) for k, (colour, label) in patches.items() if (kind == k).any()]
    figure.legend(handles=handles, loc="outside lower center", ncols=2, frameon=False, fontsize=9)  # outside: it would hide a region
    shown = [_shown(x) for x in found[1]]
    axes.set(xlabel=r"$\alpha_1$", ylabel=r"$\alpha_2$", title=rf"order two, $\gamma_0 = {shown[0]}$, $\gamma_1 = {shown[1]}$; the circle is the start")
    return figure


def _definiteness_order_two(x: Any, y: Any, g0: float, g1: float) -> tuple[Any, Any, Any]:
    """Least and largest value of D on the circle, and whether a(z) is a Schur polynomial, for arrays of alpha."""
    # a = phi_2 + x phi_1 + y, b the same with the second kind polynomials
    a1, a2 = x - g0 + g0 * g1, -g1 - g0 * x + y
    b1, b2 = x + g0 + g0 * g1, g1 + g0 * x + y
    d0 = 1 + a1 * b1 + a2 * b2
    d1 = (a1 + b1 + a1 * b2 + a2 * b1) / 2
    d2 = (a2 + b2) / 2

    def at(c: Any) -> Any:  # at cos(theta) = c
        return d0 + 2 * d1 * c + 2 * d2 * (2 * c * c - 1)

    with np.errstate(divide="ignore", invalid="ignore"):
        vertex = np.where(d2 != 0, np.clip(-d1 / (4 * d2), -1, 1), 1.0)
    values = np.stack([at(1.0), at(-1.0), at(vertex)])
    stable = (np.abs(a2) < 1) & (np.abs(a1) < 1 + a2)
    return values.min(axis=0), values.max(axis=0), stable


def draw_spectrum(filter: Filter) -> Figure:
    """The zeros of z^n D(z, 1/z), which are the eigenvalues of S, and the unit circle."""
    d = pseudo_polynomial(filter.a, filter.b)
    largest = max(abs(v) for v in d)
    if largest == 0:
        raise Unsupported("D is zero")
    coefficients = [_float(v / largest) for v in (*reversed(d[1:]), *d)]
    roots = np.roots(coefficients)
    figure, axes = _figure(5.6, 5.6)
    angle = np.linspace(0, 2 * np.pi, 721)
    axes.plot(np.cos(angle), np.sin(angle), color=_INK, lw=1)
    axes.axhline(0, color=_INK, lw=0.4)
    axes.axvline(0, color=_INK, lw=0.4)
    axes.plot(roots.real, roots.imag, "o", color=_ORBIT, ms=6)
    reach = float(min(max(1.3, 1.15 * np.max(np.abs(roots), initial=1.0)), 8))
    outside = int(np.sum(np.abs(roots) > reach))
    title = r"spectrum of $S$, the zeros of $z^n D(z, 1/z)$, and the unit circle"
    if d[-1] == 0:
        title = r"zeros of $z^n D(z, 1/z)$; there is no $S$, as $\alpha_n = 0$"
    axes.set(xlim=(-reach, reach), ylim=(-reach, reach), xlabel=r"$\mathrm{Re}\,z$", ylabel=r"$\mathrm{Im}\,z$",
             title=title + (f"\n{outside} outside the picture" if outside else ""))
    axes.set_aspect("equal")
    return figure
