"""Theorems: results that no paper prints, with their proofs step by step.

They are the one fragment that is not HTML: Sphinx numbers them through the whole book, so that any
page can refer to "Theorem 12", and it can number only what it has read itself.
"""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from pathlib import Path
from textwrap import indent

from pydantic import BaseModel, ConfigDict

from omniproof.report.anchors import anchor
from omniproof.report.fragments.claims import engine_names

_MATH = re.compile(r"(\$\$.+?\$\$|\$.+?\$)", re.DOTALL)
_LINK = re.compile(r"\[[^\]]*\]\([\w-]+\.html#(thm-[\w-]+)\)")


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


def theorem_markdown(theorem: Theorem) -> str:
    """Return statement and proof as directives of sphinx-proof; the label is the anchor."""
    label = anchor(theorem.id)
    return (
        f"`````{{prf:theorem}} {_text(theorem.title)}\n:label: {label}\n\n"
        f"{_text(theorem.statement)}\n\n{_engines(theorem.engines)} "
        f'<a class="address" href="#{label}">{theorem.id}</a>\n{_proof(theorem.proof)}`````\n'
    )


def _proof(steps: Sequence[Step]) -> str:
    if not steps:
        return ""
    # The directive puts its own word in front of the first line, so that it must not be the list.
    count = f"{len(steps)} steps, each" if len(steps) > 1 else "one step"
    lines = "".join(f"1. {_step(step)}\n" for step in steps)
    return f"\n````{{prf:proof}}\nIn {count} checked by the engines named.\n\n{lines}````\n"


def _step(step: Step) -> str:
    return indent(f"{_text(step.step)} {_engines(step.engines)}", "   ").lstrip()


def _engines(engines: str) -> str:
    return f"[checked by {engine_names(engines)}]{{.engines}}" if engines else ""


def _text(markdown: str) -> str:
    """Return Markdown with `$math$` without HTML; links to theorems say their numbers."""
    parts = _MATH.split(markdown)
    parts[::2] = [_LINK.sub(r"{prf:ref}`\1`", part).replace("<", "&lt;") for part in parts[::2]]
    return "".join(parts)
