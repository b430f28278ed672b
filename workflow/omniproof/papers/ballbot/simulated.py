"""What the simulated ball says about both laws, as tables; the runs are in `simulation.ballbot`.

The numbers come as the long table of all simulations (model, case, quantity, value, unit), since
chapters show what was recorded and simulate nothing.
"""

from __future__ import annotations

from math import cos, radians

import numpy as np
import pandas as pd

SIDES = {"inside": "inside the ball", "on-top": "on top of it"}
ANGLES_DEG = (30, 45, 60)
TURNS = {
    "inside-45-turning": "inside, point of contact",
    "on-top-45-turning": "on top, point of contact",
    "on-top-45-turning-floor-torsion": "on top, floor that holds the ball",
}
"""Cases in which all wheels have one speed, in words."""

TURN_RATES = ["yaw_rate", "spin", "law_yaw_rate"]

LAWS = (
    "platform",
    r"zenith angle $\phi$",
    "speed by (10) / of ball",
    r"$\cos\phi$",
    "error of rolling, at most",
    "error of (10), at least",
    "ratio of errors, at least",
)
"""Heads of `laws_in_simulation`."""

TURNING = (
    "platform",
    "yaw rate of platform, rad/s",
    "spin of ball, rad/s",
    "difference, rad/s",
    "difference by both laws, rad/s",
)
"""Heads of `turns_in_simulation`."""


def laws_in_simulation(summary: pd.DataFrame) -> list[list[str]]:
    """Which law the ball obeys, by set-up and zenith angle, over all inputs that move it.

    Each row has what `LAWS` names; errors are shares of the ball's speed, and that speed's own
    share is shown from the least to the greatest.
    """
    numbers = _by_case(summary)
    rows = []
    for side, words in SIDES.items():
        for angle in ANGLES_DEG:
            # Cases that only turn have no velocity and no margin; minima skip them.
            found = numbers[numbers.index.str.startswith(f"{side}-{angle}-")]
            least, most = found.min(), found.max()
            share = _span(least["share"], most["share"])
            errors = [f"{most['rolling_error']:.2%}", f"{least['printed_error']:.1%}"]
            right = f"{cos(radians(angle)):.3f}"
            rows.append([words, f"{angle}°", share, right, *errors, f"{least['margin']:.0f}"])
    return rows


def turns_in_simulation(summary: pd.DataFrame) -> list[list[str]]:
    """Which body turns when all wheels have one speed; columns as in `TURNING`."""
    rates = _by_case(summary).loc[list(TURNS), TURN_RATES].to_numpy(dtype=np.float64)
    rows = []
    for words, (yaw_rate, spin, law) in zip(TURNS.values(), rates, strict=True):
        rows.append([words, *map(_signed, (yaw_rate, spin, yaw_rate - spin, law))])
    return rows


def least_margin(summary: pd.DataFrame) -> str:
    """How many times as far off as the law of rolling Eq. (10) is, in the case that favours it."""
    return f"{_by_case(summary)['margin'].min():.0f}"


def worst_share(summary: pd.DataFrame) -> str:
    """How far the share of Eq. (10) is from the cosine of the zenith angle at most, in any case."""
    shares = _by_case(summary)["share"].dropna()
    return (
        f"{max(abs(share - cos(radians(_angle_deg(name)))) for name, share in shares.items()):.4f}"
    )


def fastest_turning(summary: pd.DataFrame) -> str:
    """How fast the ball moves at most while all wheels have one speed, in mm/s."""
    turning = _by_case(summary).filter(like="turning", axis="index")
    speeds = np.hypot(turning["v_x"].to_numpy(dtype=float), turning["v_y"].to_numpy(dtype=float))
    return f"{1000 * float(speeds.max()):.2f} mm/s"


def _angle_deg(case: object) -> int:
    """Zenith angle in the name of a case: `on-top-45-mixed`."""
    return next(int(part) for part in str(case).split("-") if part.isdigit())


def deepest(summary: pd.DataFrame) -> str:
    """How much deeper the platform sits than on a hard, smooth ball, in the worst case."""
    return f"{1000 * _by_case(summary)['sinking'].max():.2f} mm"


def _by_case(summary: pd.DataFrame) -> pd.DataFrame:
    """One row a case of this paper, one column a quantity; raises `KeyError` without any."""
    own = summary[summary["model"] == "ballbot"]
    if own.empty:
        raise KeyError("no simulation of the ballbot among the numbers")
    return own.pivot(index="case", columns="quantity", values="value")


def _span(least: float, most: float) -> str:
    ends = list(dict.fromkeys(f"{end:.3f}" for end in (least, most)))
    return " to ".join(ends)


def _signed(value: float) -> str:
    """Write a rate; what rounds to zero has no sign."""
    return f"{round(value, 3) + 0.0:.3f}".replace("-", "\N{MINUS SIGN}")
