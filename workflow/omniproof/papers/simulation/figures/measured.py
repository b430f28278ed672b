"""What was measured on the models: the law of the ball, and what the robot's errors depend on."""

from __future__ import annotations

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from omniproof.papers.ballbot.simulated import ANGLES_DEG, SIDES
from omniproof.papers.omni_trajectory.simulated import MEASURES, STARTS, VARIATIONS
from omniproof.report.figure import Drawing, Floats, long_form, points, rows
from omniproof.report.sketch import label, line, shown
from omniproof.report.svg import ACCENT, INK, SMALL_SIZE, TYPE_COLORS, WIDTH, styled

DECADES = (1e-4, 1e-3, 1e-2, 1e-1, 1.0)
NOT_IN_PAPERS = "The papers have no such figure."

# The law of the ball ------------------------------------------------------------------------------

SPREAD_DEG = np.linspace(0, 75, 76)
ASIDE_DEG = {"inside": -0.8, "on-top": 0.8}
"""Points of both sides stand beside each other."""

LAW_COLORS = {"rolling": ACCENT, "printed": INK}
MARKS = {"inside": "o", "on-top": "s"}


def law_data(summary: pd.DataFrame) -> pd.DataFrame:
    """Simulated shares and errors (panels `share`, `error`) over the zenith angle in degrees."""
    numbers = summary.pivot(index="case", columns="quantity", values="value")
    moving = numbers[numbers["share"].notna()]
    parts = [rows("share", "rolling", np.column_stack([SPREAD_DEG, np.cos(_rad(SPREAD_DEG))]))]
    for side in SIDES:
        for angle in ANGLES_DEG:
            found = moving[moving.index.str.startswith(f"{side}-{angle}-")]
            x = np.full(len(found), angle + ASIDE_DEG[side])
            parts.append(rows("share", side, np.column_stack([x, found["share"]])))
            for law in LAW_COLORS:
                errors = np.column_stack([x, found[f"{law}_error"]])
                parts.append(rows("error", f"{law}, {side}", errors))
    return long_form(*parts)


def _rad(degrees: Floats) -> Floats:
    return np.asarray(np.radians(degrees))


@styled
def draw_law(frame: pd.DataFrame) -> Figure:
    """Draw (a) the shares beside both laws, (b) the errors of both laws."""
    figure = Figure(figsize=(WIDTH, 6.4))
    share, error = figure.subplots(2, 1, sharex=True)
    line(share, points(frame, "share", "rolling"), color=ACCENT, lw=1.8)
    line(share, [[0, 1], [75, 1]], color=INK, lw=1.4, ls="--")
    for side, mark in MARKS.items():
        _mark(share, points(frame, "share", side), mark, INK)
        for law, color in LAW_COLORS.items():
            _mark(error, points(frame, "error", f"{law}, {side}"), mark, color)
    share.set(xlim=(0, 75), ylim=(0, 1.15), yticks=[0, 0.5, 1])
    share.set_title("(a) speed by Eq. (10) / speed of the ball")
    label(share, [3, 1.07], "Eq. (10)", size=SMALL_SIZE, ha="left")
    label(share, [8, 0.76], r"rolling ball: $\cos\phi$", size=SMALL_SIZE, ha="left", color=ACCENT)
    error.set(
        yscale="log",
        ylim=(1e-4, 1),
        yticks=DECADES,
        xlabel=r"zenith angle $\phi$ [degrees]",
        xticks=[0, *ANGLES_DEG],
    )
    error.set_title("(b) error of either law, relative to the speed")
    low, high = points(frame, "error", "rolling, inside"), points(frame, "error", "printed, inside")
    for found, name, color in ((high, "Eq. (10)", INK), (low, "rolling ball", ACCENT)):
        label(error, [3, float(found[0, 1])], name, size=SMALL_SIZE, ha="left", color=color)
    for ax in (share, error):
        ax.grid(visible=True)
    words = (Line2D([], [], color=INK, marker=mark, mfc="none", lw=0, ms=6, label=SIDES[side])
             for side, mark in MARKS.items())  # fmt: skip
    share.legend(handles=list(words), loc="lower left", handletextpad=0.2)
    figure.subplots_adjust(left=0.16, right=0.96, bottom=0.1, top=0.95, hspace=0.2)
    return figure


def _mark(ax: Axes, places: Floats, marker: str, color: str) -> None:
    line(ax, places, marker=marker, ms=6, mew=1.2, mfc="none", lw=0, color=color, zorder=5)


def describe_law(frame: pd.DataFrame) -> str:
    """Say the shares by angle, and both ranges of errors."""
    found = np.vstack([points(frame, "share", side) - [ASIDE_DEG[side], 0] for side in SIDES])
    shares = ", ".join(
        f"{shown(float(found[np.isclose(found[:, 0], angle), 1].mean()))} at {angle}"
        for angle in ANGLES_DEG
    )
    off = float(np.abs(found[:, 1] - np.cos(_rad(found[:, 0]))).max())
    errors = frame[frame["panel"] == "error"]
    rolling = float(errors[errors["series"].str.startswith("rolling")]["y"].max())
    printed = float(errors[errors["series"].str.startswith("printed")]["y"].min())
    return (
        "Above, the speed that Eq. (10) gives over the speed of the simulated ball, for wheels"
        f" inside and on top: {shares} degrees. The cosine that the law of rolling asks for is at"
        f" most {shown(off, 4)} off; a dashed line at one is where Eq. (10) would be right. Below,"
        f" errors on a logarithmic axis: of the law of rolling at most {shown(rolling, 4)}, of"
        f" Eq. (10) at least {shown(printed)}."
    )


# The errors of the robot --------------------------------------------------------------------------

START_COLORS = dict(zip(STARTS, (TYPE_COLORS["X"], TYPE_COLORS["Y"]), strict=True))
ERROR_LOOKS = {
    error: (mark, words) for mark, (error, words) in zip("os", MEASURES.items(), strict=True)
}
VARIED = "circle-clockwise"
LEAST = 1e-4


def sensitivity_data(summary: pd.DataFrame) -> pd.DataFrame:
    """Errors (x) of the clockwise circle with one thing changed at a time (y: which, from 0)."""
    numbers = summary.pivot(index="case", columns="quantity", values="value")
    return long_form(
        *(
            rows(error, f"{words}, {start}", [numbers[error][f"{VARIED}-{start}{name}"], place])
            for place, (name, words) in enumerate(VARIATIONS.items())
            for start in STARTS
            for error in MEASURES
        )
    )


@styled
def draw_sensitivity(frame: pd.DataFrame) -> Figure:
    """Draw a line for each change, with the errors of both starts by both measures."""
    count = len(VARIATIONS)
    figure = Figure(figsize=(WIDTH, 1.1 + 0.52 * count))
    ax = figure.add_axes(
        (0.05, 0.55 / figure.get_figheight(), 0.9, 0.52 * count / (1.3 + 0.52 * count))
    )
    for words in VARIATIONS.values():
        for start, color in START_COLORS.items():
            for error, (marker, _) in ERROR_LOOKS.items():
                found = points(frame, error, f"{words}, {start}")
                _mark(ax, found, marker, color)
        place = float(found[0, 1])
        ax.axhline(place, color=INK, lw=0.5, alpha=0.3)
        label(ax, [1.1 * LEAST, place - 0.3], words, size=SMALL_SIZE, ha="left")
    ax.set(xscale="log", xlim=(LEAST, 0.3), xticks=DECADES[:-1], ylim=(count - 0.5, -0.7))
    ax.set(yticks=[], xlabel="error")
    ax.spines["left"].set_visible(False)
    ax.grid(visible=True, axis="x")
    entries = [
        Line2D([], [], color=color, marker=marker, mfc="none", lw=0, label=f"{start}, {words}")
        for start, color in START_COLORS.items()
        for marker, words in ERROR_LOOKS.values()
    ]
    figure.legend(handles=entries, loc="upper center", ncols=2, handletextpad=0.2)
    return figure


def describe_sensitivity(frame: pd.DataFrame) -> str:
    """Say the range of each error from each start, and which change gives the greatest."""
    said = []
    for start in STARTS:
        for error, (_, words) in ERROR_LOOKS.items():
            chosen = frame[(frame["panel"] == error) & frame["series"].str.endswith(f", {start}")]
            least, most = (
                shown(float(value), 4) for value in (chosen["x"].min(), chosen["x"].max())
            )
            worst = str(chosen["series"].iloc[int(np.argmax(chosen["x"]))]).removesuffix(
                f", {start}"
            )
            said.append(f"{start}, {words}: {least} to {most} ({worst})")
    return (
        "Marks on a logarithmic axis, one line for each thing that was changed. Errors from least"
        f" to greatest, and for which change: {'; '.join(said)}."
    )


MEASURED = (
    Drawing(
        "ball-law",
        "Which law the ball obeys",
        "(a) Eq. (10) fed with the wheel speeds that the simulated robot has. Marks: all inputs"
        " that move the ball, each side moved a little aside; those of one set-up nearly cover"
        f" each other. (b) The same runs. {NOT_IN_PAPERS}",
        law_data,
        draw_law,
        describe_law,
        ("simulation/ballbot/summary.csv",),
    ),
    Drawing(
        "sensitivity",
        "What the errors depend on",
        "The clockwise circle of Table 3, with one thing changed at a time: the length's error"
        f" $|1 - L^e/L^m|$ and Eq. (17), from both starts. {NOT_IN_PAPERS}",
        sensitivity_data,
        draw_sensitivity,
        describe_sensitivity,
        ("simulation/omni-robot/summary.csv",),
    ),
)
