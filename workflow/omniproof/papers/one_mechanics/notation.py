r"""One quantity, five notations: what each paper writes for it, as the paper writes it.

Symbols are LaTeX as in the papers' transcriptions, where a test looks them up; several are parted
by ` ; `. An empty cell: the paper has no symbol for it, or does not need it. Words in a cell say
that the paper fixes the quantity.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from omniproof.papers.one_mechanics.statements import (
    ARRANGEMENT,
    BALLBOT,
    THREE,
    TRAJECTORY,
    TWO,
)

PAPERS = (ARRANGEMENT, TRAJECTORY, BALLBOT, TWO, THREE)
HEADS = ("Arrangement", "Trajectory", "Ballbot", "Two rollers", "Three rollers")
PART = " ; "
NONE = "–"


@dataclass(frozen=True)
class Symbols:
    """A quantity, or a letter, and what it is in each of `PAPERS`; texts have `$math$`."""

    head: str
    cells: tuple[str, str, str, str, str]


QUANTITIES: Sequence[Symbols] = (
    Symbols(
        "contact",
        (r"$\mathbf{q}_k$", "$P_i$", r"$\bar{\mathbf{p}}$", r"$\mathbf{P}_i$", r"$P_i$"),
    ),
    Symbols(
        "place of the contact",
        (
            r"$\alpha_k$",
            r"$\alpha_1$",
            r"120° apart ; $\phi$",
            r"$\theta_{1,i}$ ; $\theta_{2,i}$",
            r"$\theta_{1,i}$ ; $\theta_{2,i}$",
        ),
    ),
    Symbols(
        "driven direction",
        (r"$\mathbf{n}_k$", "tangent", r"$\bar{\mathbf{o}}$", r"$\mathbf{e}_i$", r"$\mathbf{e}_i$"),
    ),
    Symbols(
        "axis of the wheel or roller",
        ("radial", "radial", r"$\bar{\mathbf{n}}$", r"$\boldsymbol{\eta}_i$", r"$\eta_i$"),
    ),
    Symbols("angle of the axis", (NONE, NONE, NONE, r"$\alpha_i$", r"$\psi_i$")),
    Symbols(
        "along the axis, the contact",
        ("slides freely", "slides freely", "slides freely", "is held", "is held"),
    ),
    Symbols("speed of the rim", ("$v_k$", r"$v_1$ ; $\nu_1$", "$v_y^{C_1}$", r"$\nu_i$", "$v_i$")),
    Symbols("distance of the contact", ("$L$", "$L$ ; $R$", "$L$", "$r$", "$r$")),
    Symbols("radius of the wheel", ("$R$", "$r$ ; $R$", NONE, NONE, NONE)),
    Symbols(
        "velocity of the body",
        (
            r"$\mathbf{V}$",
            r"$\dot{X}_m$ ; $\dot{Y}_m$",
            "$v_x^B$ ; $v_y^B$",
            r"$\mathbf{V}$",
            "centre at rest",
        ),
    ),
    Symbols(
        "rotation of the body",
        (
            r"$\dot{\phi}$",
            r"$\dot{\phi}$",
            r"$\omega_z^B$",
            r"$\boldsymbol{\omega}$",
            r"$\omega$",
        ),
    ),
    Symbols("slip", ("none", "none", "none", r"$\boldsymbol{\psi}_i$", r"$\zeta_{1,1}$")),
)
"""Quantities of the common theory; the first one in `PAPERS`' order, and so on."""

LETTERS: Sequence[Symbols] = (
    Symbols(
        r"$\phi$ or $\varphi$",
        ("heading", "heading; target direction", "zenith angle", "direction of travel", "phase"),
    ),
    Symbols(r"$\psi$", (NONE, "first direction", NONE, "slip velocity", "angle of the axis")),
    Symbols(r"$\alpha$", ("place of a wheel", "place of a wheel", NONE, "angle of the axis", NONE)),
    Symbols(
        r"$\omega$",
        (NONE, "turning of a wheel", "yaw rate", "spin of the sphere", "spin of the sphere"),
    ),
    Symbols(
        "$L$",
        (
            "radius of the body",
            "radius of the body",
            "radius of the ball",
            NONE,
            "sum of squared distances",
        ),
    ),
    Symbols(
        "$r$", (NONE, "radius of a wheel", NONE, "radius of the sphere", "radius of the sphere")
    ),
    Symbols(
        "$R$",
        ("radius of a wheel", "of body, wheel", NONE, "marks the roller", "centre of a roller"),
    ),
    Symbols(
        r"$\mathbf{e}$, $e$", (NONE, "error", NONE, "normal, driven direction", "driven direction")
    ),
)
"""Letters that change their meaning from paper to paper."""


def table(symbols: Sequence[Symbols]) -> list[list[str]]:
    """Rows for a page: the head and the five cells, parts joined by commas."""
    return [[row.head, *(cell.replace(PART, ", ") for cell in row.cells)] for row in symbols]
