"""Figures, written into the page so that they follow its mode, with their data one click away."""

from __future__ import annotations

import re
from html import escape
from pathlib import Path

from pydantic import BaseModel, ConfigDict, TypeAdapter

from omniproof.report.code_pages import code_link
from omniproof.report.latexfmt import inline

_DECIMALS = re.compile(r"-?\d+\.\d{3,}")
_NOT_DRAWING = re.compile(r"^.*?(?=<svg\b)|<metadata>.*?</metadata>", re.DOTALL)


class About(BaseModel):
    """What the book says of one figure: a record of `figures.json`."""

    model_config = ConfigDict(frozen=True, extra="ignore")

    number: int | str
    title: str
    alt: str
    caption: str
    source: str = ""


_LIST = TypeAdapter(tuple[About, ...])


def read_about(folder: Path, number: int | str) -> About:
    """Read what is to be said of figure N from the folder of a paper's figures.

    Raises `ValueError` when nothing is said of this figure.
    """
    for about in _LIST.validate_json((folder / "figures.json").read_bytes()):
        if about.number == number:
            return about
    raise ValueError(f"figures.json: no figure {number}")


def figure_html(svg: str, about: About, address: str, data: str) -> str:
    """Return the figure with its caption, alt text and links.

    svg: text of the file; address: id of the element; data: path on the site of SVG and CSV,
    without suffix.
    """
    numbered = isinstance(about.number, int)
    heading = f"Figure {about.number}. " if numbered else ""
    name = f"Figure {about.number}" if numbered else escape(about.title)
    links = "".join(
        f' <a href="{escape(data)}.{suffix}" title="{name}">{word}</a>'
        for suffix, word in (("svg", "SVG"), ("csv", "CSV"))
    )
    if about.source:
        links += f' <a href="{escape(code_link(about.source))}" title="{name}">script</a>'
    own = data.removeprefix("figures/").replace("/", "-")
    bare = _compact(_NOT_DRAWING.sub("", svg).strip(), f"{own}-")
    drawing = _labelled(_prefixed(bare, f"{address}-"), about)
    return (
        f'<figure class="drawn" id="{address}"><div class="drawing">{drawing}</div>'
        f"<figcaption><b>{heading}{inline(about.title)}.</b> "
        f'{inline(about.caption)}<span class="downloads">{links}</span></figcaption></figure>'
    )


def drawn_html(results: Path, paper: str, number: int | str, address: str) -> str:
    """Return figure N of a paper or topic as it lies in the folder of results.

    Raises `ValueError` when nothing is said of this figure.
    """
    data = f"figures/{paper}/figure-{number}"
    drawing = results / f"{data}.svg"
    about = read_about(drawing.parent, number)
    return figure_html(drawing.read_text(encoding="utf-8"), about, address, data)


def _labelled(svg: str, about: About) -> str:
    """Give the drawing its alt text, in place of any label that it brings along."""
    tag, rest = re.match(r"<svg\b[^>]*>", svg), svg
    if tag is None:
        raise ValueError(f"figure {about.number}: expected an <svg> element")
    bare = re.sub(r'\s(?:role|aria-\w+)="[^"]*"', "", tag[0])
    label = f'<svg role="img" aria-label="{escape(about.alt)}"'
    return bare.replace("<svg", label, 1) + rest[tag.end() :]


def _compact(svg: str, own: str) -> str:
    """Return a drawing without what only its file needs: half of its bytes.

    Ids lose their prefix `own`, or go where nothing refers to them; strokes keep two decimals, a
    hundredth of a pixel.
    """
    svg = re.sub(rf'(?<=[#"]){re.escape(own)}', "", svg)
    used = set(re.findall(r'(?:url\(#|href="#)([^")]+)', svg))
    svg = re.sub(r'\sid="([^"]*)"', lambda found: found[0] if found[1] in used else "", svg)
    svg = re.sub(r'(?<=\sd=")[^"]*', lambda found: _DECIMALS.sub(_rounded, found[0]), svg)
    return re.sub(r"\s*\n\s*", " ", svg).replace("> <", "><")


def _rounded(number: re.Match[str]) -> str:
    return f"{float(number[0]):.2f}".rstrip("0").rstrip(".")


def _prefixed(svg: str, prefix: str) -> str:
    """Make the ids of one drawing unique on the page: Matplotlib repeats them between drawings."""
    svg = re.sub(r'(?<=\sid=")', prefix, svg)
    svg = re.sub(r"(?<=url\(#)", prefix, svg)
    return re.sub(r'(?<=href="#)', prefix, svg)
