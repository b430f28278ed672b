"""One visual language for all figures, and how a figure becomes a file.

A style is data: `STYLE` is a dictionary of settings, applied for the time of one drawing (`styled`)
and nowhere else. A figure has the width of a phone and stacks its panels, so that its letters stay
legible there. One file serves light and dark pages: ink is drawn in a colour that nothing else has
and written as `currentColor`, so it takes the colour of the text around it; hues keep a contrast of
3 on both. On its own the file follows the reader's colour scheme, by rules that hold only where
the drawing is the whole document (`svg:root`), so several can be written into one page. Letters are
outlines: they look the same without any installed font.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from functools import wraps
from html import escape
from io import StringIO
from pathlib import Path
from tempfile import NamedTemporaryFile
from types import MappingProxyType
from typing import Any, ParamSpec

import matplotlib as mpl
from matplotlib.axes import Axes
from matplotlib.figure import Figure

Arguments = ParamSpec("Arguments")

INK = "#010203"
"""Stands for the colour of the text around the figure; written as `currentColor`."""

TYPE_COLORS: Mapping[str, str] = MappingProxyType({"X": "#2382c4", "Y": "#d9651a", "Z": "#0c9a72"})
"""Hues after Okabe and Ito (2008); shapes and dashes say the same without colour."""

TYPE_DASHES: Mapping[str, str] = MappingProxyType({"X": "-", "Y": "--", "Z": "-."})
TYPE_MARKERS: Mapping[str, str] = MappingProxyType({"X": "o", "Y": "s", "Z": "^"})
ACCENT = "#b85f9c"
"""For the one thing in a figure to look at that belongs to no type."""

WIDTH = 4.8
"""Inches: 461 CSS pixels, so that 360 pixels show the letters at 78 percent."""

FONT_SIZE = 12.0
SMALL_SIZE = 10.5

STYLE: Mapping[str, Any] = MappingProxyType(
    {
        "font.family": "sans-serif",
        "font.sans-serif": ["DejaVu Sans"],
        "font.size": FONT_SIZE,
        "mathtext.fontset": "cm",
        "text.color": INK,
        "axes.edgecolor": INK,
        "axes.labelcolor": INK,
        "axes.facecolor": "none",
        "axes.labelsize": FONT_SIZE,
        "axes.linewidth": 0.8,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.titlesize": FONT_SIZE,
        "axes.titlelocation": "left",
        "axes.unicode_minus": True,
        "xtick.color": INK,
        "ytick.color": INK,
        "xtick.labelsize": SMALL_SIZE,
        "ytick.labelsize": SMALL_SIZE,
        "xtick.direction": "out",
        "ytick.direction": "out",
        "grid.color": INK,
        "grid.alpha": 0.15,
        "grid.linewidth": 0.6,
        "lines.linewidth": 1.6,
        "lines.color": INK,
        "patch.edgecolor": INK,
        "hatch.color": INK,
        "legend.frameon": False,
        "legend.fontsize": SMALL_SIZE,
        "figure.facecolor": "none",
        "savefig.facecolor": "none",
        "savefig.edgecolor": "none",
        "svg.fonttype": "path",
        "svg.hashsalt": "omniproof",
        "path.simplify": True,
    }
)

_OWN_COLORS = (
    "<style>svg:root{color:#1b1f24}"
    "@media (prefers-color-scheme:dark){svg:root{color:#e4e7ea;background:#14181e}}</style>"
)


def styled(draw: Callable[Arguments, Figure]) -> Callable[Arguments, Figure]:
    """Let a drawing function run in `STYLE`, and leave the settings of others as they were."""

    @wraps(draw)
    def drawn(*args: Arguments.args, **kwargs: Arguments.kwargs) -> Figure:
        with mpl.rc_context(dict(STYLE)):
            return draw(*args, **kwargs)

    return drawn


def stage(height: float) -> tuple[Figure, Axes]:
    """Return an empty figure of `WIDTH` x `height` whose axes measure inches, for sketches."""
    figure = Figure(figsize=(WIDTH, height))
    ax = figure.add_axes((0, 0, 1, 1))
    ax.set(xlim=(0, WIDTH), ylim=(0, height))
    ax.set_axis_off()
    return figure, ax


def svg_text(figure: Figure, *, title: str, alt: str, prefix: str) -> str:
    """Return a figure as SVG: the same text for the same figure.

    `title` and `alt` become its name and description for readers who do not see it; all ids start
    with `prefix`. Raises `ValueError` for an empty `title` or `alt`, and for a prefix that cannot
    start an id.
    """
    if not title.strip() or not alt.strip():
        raise ValueError("expected a title and an alt text, got an empty one")
    if not re.fullmatch(r"[A-Za-z][\w-]*", prefix):
        raise ValueError(f"expected a prefix that can start an id, got {prefix!r}")
    buffer = StringIO()
    with mpl.rc_context(dict(STYLE)):
        figure.savefig(buffer, format="svg", metadata={"Date": None})
    return _labelled(_cleaned(buffer.getvalue(), prefix), title, alt, prefix)


def save_figure(figure: Figure, path: Path, *, title: str, alt: str, prefix: str) -> None:
    """Write a figure as SVG, whole or not at all. Errors as in `svg_text`; makes the folder."""
    text = svg_text(figure, title=title, alt=alt, prefix=prefix)
    path.parent.mkdir(parents=True, exist_ok=True)
    with NamedTemporaryFile(
        "w", dir=path.parent, prefix=path.name, delete=False, encoding="utf-8", newline="\n"
    ) as file:
        file.write(text)
    Path(file.name).chmod(0o644)
    Path(file.name).replace(path)


def _cleaned(svg: str, prefix: str) -> str:
    """Drop what leaks into a page (Matplotlib's style rule for `*`), mend ink and ids."""
    svg = svg[svg.index("<svg") :]
    svg = re.sub(r"\s*<metadata>.*?</metadata>", "", svg, flags=re.DOTALL)
    svg = re.sub(r"\s*<style\b.*?</style>", "", svg, flags=re.DOTALL)
    svg = svg.replace(INK, "currentColor")
    svg = re.sub(r'(?<=\sid=")', f"{prefix}-", svg)
    return re.sub(r'(url\(#|href="#)', rf"\g<1>{prefix}-", svg)


def _labelled(svg: str, title: str, alt: str, prefix: str) -> str:
    """Name and describe the drawing, and give the standalone file its colours."""
    end = svg.index(">")
    names = f"{prefix}-title", f"{prefix}-desc"
    root = (
        f' role="img" aria-labelledby="{" ".join(names)}"'
        ' stroke-linejoin="round" stroke-linecap="butt">'
    )
    about = (
        f'\n <title id="{names[0]}">{escape(title)}</title>'
        f'\n <desc id="{names[1]}">{escape(alt)}</desc>\n {_OWN_COLORS}'
    )
    return '<?xml version="1.0" encoding="utf-8"?>\n' + svg[:end] + root + about + svg[end + 1 :]
