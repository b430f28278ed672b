"""Both laws over the zenith angle: how fast the ball moves, and how well the wheels move it."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from sympy import ImmutableMatrix, Rational, lambdify, sqrt

from omniproof.kinematics.omni import twist_matrix
from omniproof.papers.ballbot.laws import BALL_RADIUS, ISOTROPIC, at_rest, gram, rolling
from omniproof.papers.ballbot.symbols import PHI, RUNNING_RADIUS
from omniproof.report.figure import Drawing, Floats, long_form, points, rows
from omniproof.report.sketch import label, shown
from omniproof.report.svg import ACCENT, INK, SMALL_SIZE, TYPE_COLORS, TYPE_DASHES, WIDTH, styled

STEP_DEG = 0.5
ANGLES_DEG = np.union1d(np.arange(STEP_DEG, 180, STEP_DEG), np.degrees(float(ISOTROPIC)))
LABELLED_DEG = (30, 45, 60)
THIN, THICK = Rational(1), Rational(9, 10)
"""Ratios L / rho: no wall, and a wall of a tenth of the radius."""

SERIES: Mapping[str, tuple[str, Callable[[], ImmutableMatrix], Rational]] = {
    "printed": ("Eq. (10)", at_rest, THIN),
    "rolling": (r"rolling ball, $L = \rho$", rolling, THIN),
    "rolling in a wall": (r"rolling ball, $L = 0.9\,\rho$", rolling, THICK),
}
LOOKS = {
    "printed": {"color": INK, "ls": TYPE_DASHES["Y"]},
    "rolling": {"color": ACCENT, "ls": TYPE_DASHES["X"]},
    "rolling in a wall": {"color": TYPE_COLORS["Z"], "ls": TYPE_DASHES["Z"]},
}


def laws_data() -> pd.DataFrame:
    """Speed predicted by (10) over the actual one, and isotropy of each law (x in degrees)."""
    parts = []
    for name, (_, law, ratio) in SERIES.items():
        share = twist_matrix(at_rest()) * law()
        parts.append(rows("speed", name, _curve(share[0, 0], ratio)))
        diagonal = gram(law(), BALL_RADIUS)
        parts.append(rows("isotropy", name, _isotropy(diagonal, ratio)))
    return long_form(*parts)


def _curve(expression: object, ratio: Rational) -> Floats:
    """Values of an expression in phi, L and rho = 1 over the angles: M x 2."""
    value = lambdify((PHI, RUNNING_RADIUS, BALL_RADIUS), expression, "numpy")
    values = value(np.radians(ANGLES_DEG), float(ratio), 1.0)
    return np.column_stack([ANGLES_DEG, np.broadcast_to(values, ANGLES_DEG.shape)])


def _isotropy(matrix: ImmutableMatrix, ratio: Rational) -> Floats:
    """Least over greatest singular value of a law whose A^T A is diagonal: M x 2."""
    columns = np.array([_curve(sqrt(matrix[k, k]), ratio)[:, 1] for k in range(3)])
    return np.column_stack([ANGLES_DEG, columns.min(axis=0) / columns.max(axis=0)])


@styled
def draw_laws(frame: pd.DataFrame) -> Figure:
    """Draw both panels over the zenith angle."""
    figure = Figure(figsize=(WIDTH, 6.2))
    speed, isotropy = figure.subplots(2, 1, sharex=True)
    for ax, panel in ((speed, "speed"), (isotropy, "isotropy")):
        for name, (title, _, _) in SERIES.items():
            ax.plot(*points(frame, panel, name).T, label=title, **LOOKS[name])
        ax.grid(visible=True)
        ax.axvline(90, color=INK, linewidth=0.8, linestyle=":")
    speed.set(xlim=(0, 180), xticks=range(0, 181, 30), ylim=(-1.1, 1.1), yticks=[-1, 0, 1])
    speed.set_title("(a) speed by Eq. (10) / speed of the ball")
    _shares(speed, frame)
    isotropy.set(ylim=(0, 1.09), yticks=[0, 0.5, 1], xlabel=r"zenith angle $\phi$ [degrees]")
    isotropy.set_title("(b) isotropy: 1 best, 0 singular")
    _peaks(isotropy, frame)
    isotropy.legend(loc="upper center", bbox_to_anchor=(0.5, -0.22), ncols=1)
    figure.subplots_adjust(left=0.12, right=0.96, bottom=0.24, top=0.95, hspace=0.2)
    return figure


def _shares(ax: Axes, frame: pd.DataFrame) -> None:
    """Mark the thin ball at a few angles."""
    curve = points(frame, "speed", "rolling")
    for angle, share in curve[np.isin(curve[:, 0], LABELLED_DEG)]:
        ax.plot(angle, share, "o", color=ACCENT, ms=6)
        label(ax, [angle + 5, share + 0.03], f"{share:.2f}", size=SMALL_SIZE, ha="left")
    for x, text in ((45, "lower half"), (135, "upper half")):
        label(ax, [x, -0.9 if x < 90 else 0.4], text, size=SMALL_SIZE)


def _peaks(ax: Axes, frame: pd.DataFrame) -> None:
    """Name the angles at which the laws are isotropic, for wheels below."""
    for name, side, gap in (("rolling", "right", -3), ("printed", "left", 3)):
        at, value = best(points(frame, "isotropy", name))
        ax.plot(at, value, "o", color=LOOKS[name]["color"], ms=6)
        label(ax, [at + gap, 1.02], f"{at:.4g}°", size=SMALL_SIZE, ha=side)


def best(curve: Floats) -> Floats:
    """The point of greatest value with an angle below 90 degrees."""
    below = curve[curve[:, 0] < 90]
    return np.asarray(below[np.argmax(below[:, 1])])


def describe_laws(frame: pd.DataFrame) -> str:
    """Say the shares at a few angles and where each law is best."""
    curve = points(frame, "speed", "rolling")
    shares = [f"{shown(curve[curve[:, 0] == angle][0, 1])} at {angle}" for angle in LABELLED_DEG]
    right, printed = (best(points(frame, "isotropy", name))[0] for name in ("rolling", "printed"))
    return (
        "Above, the speed that Eq. (10) gives over that of the ball, a cosine of the zenith angle:"
        f" {', '.join(shares)} degrees, nothing at 90, reversed beyond. Below, the isotropy of both"
        f" laws: for a rolling ball best at {right:.2f} degrees and zero at 90, where Eq. (10),"
        f" best at {printed:.0f}, sees nothing amiss."
    )


LAWS = (
    Drawing(
        "laws",
        "Two laws over the zenith angle",
        "(a) Eq. (10) fed with the wheel speeds of a rolling ball. (b) Least over greatest singular"
        r" value on $(v_x, v_y, \rho\,\omega)$; the wall makes no difference to it. Beyond 90° the"
        " wheels stand on the upper half of the surface. The paper has no such figure.",
        laws_data,
        draw_laws,
        describe_laws,
    ),
)
