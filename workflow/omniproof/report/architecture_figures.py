"""Draw the two graphs of the project: what makes what, and what imports what.

Data first, as for every figure: nodes by group and arrows by their ends, with places in rows.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise
from pathlib import Path

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import FancyBboxPatch

from omniproof.report.architecture import (
    Graph,
    ask_snakemake,
    import_graph,
    read_rule_files,
    rule_graph,
)
from omniproof.report.figure import Drawing, Row, long_form, rows
from omniproof.report.layers import PASSAGE, Arrow, laid_out
from omniproof.report.sketch import arrow, label, line
from omniproof.report.svg import ACCENT, SMALL_SIZE, TYPE_COLORS, WIDTH, stage, styled

WIDEST = 3
"""Nodes in a row: with three, names keep their size on a phone."""

DRAWN, IMPLIED = "arrows", "implied arrows"
TO = " \N{RIGHTWARDS ARROW} "
ROW_HEIGHT = 0.78
BOX = 0.42
COLORS = {"sources": TYPE_COLORS["Y"], "audit": TYPE_COLORS["Z"], "book": ACCENT}
"""Of groups that stand apart: what is written, where verdicts arise, the report; others blue."""


def drawings(project: Path) -> tuple[Drawing, ...]:
    """Return the pictures of a project: `rules`, for which Snakemake is asked, and `modules`."""
    files = read_rule_files(project / "workflow" / "rules")
    made = graph_data(rule_graph(ask_snakemake(project), files))
    imported = graph_data(import_graph(project / "workflow" / "omniproof"))
    implied = "An arrow is left out where a chain of others leads from its start to its end."
    return (
        Drawing(
            "rules",
            "From what papers print to the report",
            "What is written by hand (with a slash), the rules that make the rest, and what each "
            f"takes from another. Read from Snakemake's own graph of the rules. {implied}",
            lambda: made,
            draw_graph,
            lambda frame: f"Boxes in rows, arrows from above: {_read_out(frame)}.",
        ),
        Drawing(
            "modules",
            "Who knows whom",
            "Parts of the package; an arrow leads from a part to one that it imports. Read from "
            "the import statements; of two that import each other, the more frequent way is drawn. "
            f"{implied}",
            lambda: imported,
            draw_graph,
            lambda frame: f"Boxes in rows, arrows only downwards: {_read_out(frame)}.",
        ),
    )


def graph_data(graph: Graph) -> pd.DataFrame:
    """Return a graph in long form: nodes with their group as panel, arrows by their bends.

    x is measured in widths of a node, y in rows, upwards; z of an arrow is its weight. Arrows that
    others imply are data without bends.
    """
    layout = laid_out(graph.groups, one_way(graph.arrows), WIDEST)
    places = {node: (x, -row) for node, (x, row) in layout.places.items()}
    nodes = (rows(graph.groups[node], node, [place]) for node, place in sorted(places.items()))
    return long_form(
        *nodes,
        *(_arrow_rows(graph, path, at) for path, at in sorted(layout.paths.items())),
        *(
            rows(IMPLIED, TO.join(pair), [(*places[end], graph.arrows[pair]) for end in pair])
            for pair in sorted(set(graph.arrows) - set(layout.paths))
        ),
    )


def _arrow_rows(graph: Graph, pair: Arrow, path: tuple[tuple[float, int], ...]) -> Iterator[Row]:
    weight = graph.arrows[pair]
    yield from rows(DRAWN, TO.join(pair), [(x, -row, weight) for x, row in path])


def one_way(arrows: Mapping[Arrow, int]) -> list[Arrow]:
    """Return arrows without those that lead back: of two between the same nodes, the heavier."""
    return [(a, b) for (a, b), weight in arrows.items() if (weight, b) > (arrows.get((b, a), 0), a)]


@styled
def draw_graph(frame: pd.DataFrame) -> Figure:
    """Draw a graph from its data: boxes with names, arrows through the gaps between them."""
    nodes = frame[~frame["panel"].isin([DRAWN, IMPLIED])]
    shown = frame[frame["panel"] != IMPLIED]
    half = np.where(shown["panel"] == DRAWN, PASSAGE, 1.0) / 2
    left, right = float((shown["x"] - half).min()), float((shown["x"] + half).max())
    middle = (left + right) / 2
    scale = np.array([min(WIDTH / (right - left), 1.25), ROW_HEIGHT])
    deep = -float(nodes["y"].min())
    figure, ax = stage((deep + 1) * ROW_HEIGHT)
    shift = np.array([WIDTH / 2 - middle * scale[0], (deep + 0.5) * ROW_HEIGHT])
    for _, path in shown[shown["panel"] == DRAWN].groupby("series", sort=False):
        _draw_arrow(ax, path[["x", "y"]].to_numpy(dtype=float) * scale + shift)
    for group, name, x, y in nodes[["panel", "series", "x", "y"]].itertuples(index=False):
        _draw_node(ax, str(name), np.array([x, y]) * scale + shift, scale[0], str(group))
    return figure


def _draw_arrow(ax: Axes, path: np.ndarray) -> None:
    """Draw one arrow: from the foot of a box, straight down through rows, to the head of a box."""
    half = np.array([0.0, BOX / 2])
    bends = [path[0] - half]
    for place in path[1:-1]:
        bends += [place + half, place - half]
    bends.append(path[-1] + half)
    line(ax, bends[:-1], lw=0.9)
    for start, end in [*pairwise(bends)][-1:]:
        arrow(ax, start, end, lw=0.9)


def _draw_node(ax: Axes, name: str, place: np.ndarray, unit: float, group: str) -> None:
    """Draw one box; how many rules it stands for is written on a second line."""
    color = COLORS.get(group, TYPE_COLORS["X"])
    breadth = unit - 0.06
    box = FancyBboxPatch(
        (place[0] - breadth / 2 + 0.06, place[1] - BOX / 2 + 0.06), breadth - 0.12, BOX - 0.12,
        boxstyle="round,pad=0.06", facecolor=(color, 0.14), edgecolor=color, lw=1.2, zorder=3,
        linestyle="--" if group == "sources" else "-",
    )  # fmt: skip
    ax.add_patch(box)
    label(ax, place, name.replace(" \N{MULTIPLICATION SIGN}", "\n\N{MULTIPLICATION SIGN}"),
          size=SMALL_SIZE, linespacing=1.0)  # fmt: skip


def _read_out(frame: pd.DataFrame) -> str:
    """Say in words which arrows there are: `a leads to b and c; …`."""
    ends: dict[str, list[str]] = {}
    for pair in dict.fromkeys(frame[frame["panel"] == DRAWN]["series"]):
        start, end = str(pair).split(TO)
        ends.setdefault(start, []).append(end)
    return "; ".join(f"{start} leads to {_listed(names)}" for start, names in ends.items())


def _listed(names: list[str]) -> str:
    *others, last = names
    return f"{', '.join(others)} and {last}" if others else last
