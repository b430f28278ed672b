"""Theorems: results that no paper prints, with their proofs step by step."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import cache
from html import escape
from pathlib import Path
from typing import Any

from markdown_it import MarkdownIt
from mdit_py_plugins.dollarmath import dollarmath_plugin
from pydantic import BaseModel, ConfigDict

from omniproof.report.anchors import anchor
from omniproof.report.fragments.claims import engine_names
from omniproof.report.latexfmt import math


class Step(BaseModel):
    """One step of a proof: Markdown with `$math$`, and the engines that checked it."""

    model_config = ConfigDict(frozen=True, extra="ignore")

    step: str
    engines: str = ""


class Theorem(BaseModel):
    """One theorem of `results/theorems.json`."""

    model_config = ConfigDict(frozen=True, extra="ignore")

    id: str
    title: str
    statement: str
    papers: tuple[str, ...] = ()
    engines: str = ""
    proof: tuple[Step, ...] = ()


def read_theorems(path: Path) -> tuple[Theorem, ...]:
    """Read `results/theorems.json`; an absent file holds no theorems."""
    if not path.is_file():
        return ()
    return tuple(Theorem.model_validate(item) for item in json.loads(path.read_bytes()))


def theorem_html(theorem: Theorem) -> str:
    """Return statement and proof; the proof unfolds."""
    steps = "".join(
        f"<li>{markdown(step.step)}{_engines(step.engines)}</li>" for step in theorem.proof
    )
    proof = f"<details><summary>Proof</summary><ol>{steps}</ol></details>" if steps else ""
    return (
        f'<section class="theorem" id="{anchor(theorem.id)}">'
        f'<p class="theorem-head"><b>Theorem</b> ({markdown_line(theorem.title)})'
        f' <a class="address" href="#{anchor(theorem.id)}">{escape(theorem.id)}</a></p>'
        f"{markdown(theorem.statement)}{_engines(theorem.engines)}{proof}</section>"
    )


def _engines(engines: str) -> str:
    return f'<p class="engines">checked by {engine_names(engines)}</p>' if engines else ""


def markdown(text: str) -> str:
    """Return HTML of Markdown with `$math$`; raw HTML in it is escaped, not passed on."""
    return str(_parser().render(text))


def markdown_line(text: str) -> str:
    """Return HTML of one line of Markdown, without a paragraph around it."""
    return str(_parser().renderInline(text))


@cache
def _parser() -> MarkdownIt:
    def render(content: str, options: Mapping[str, Any]) -> str:
        return math(content, display=bool(options["display_mode"]))

    parser = MarkdownIt("commonmark", {"html": False})
    return parser.use(dollarmath_plugin, renderer=render, allow_labels=False, double_inline=True)
