"""The first page: one wrong sign in a picture, questions with the formula to copy, the papers.

Questions and sentences are our words. Each is tied to findings of the ledger, and stops the build
when one of them is no finding any more.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from html import escape

from omniproof.audit.ledger import Ledger, Row
from omniproof.corrected.answer import Line
from omniproof.report.anchors import anchor
from omniproof.report.answers import Equations, Shown
from omniproof.report.findings import quoted
from omniproof.report.fragments.base import badge, corrigendum_link, worst
from omniproof.report.fragments.counts import bar_html, legend_html
from omniproof.report.latexfmt import inline, math
from omniproof.report.prose import numbers_in
from omniproof.transcription.model import Edition

_MATH = re.compile(r"\$[^$]*\$")
_CLAIM = re.compile(r"\{([\w-]+:[^{}]+)\}")
COPIED = ("LaTeX", "NumPy")

Find = Callable[[str], Row]
"""Id of a claim -> its row; raises `ValueError` for what is no finding whose source is clear."""


def questions_html(asked: Mapping[str, str | tuple[str, Line]], ledgers: Iterable[Ledger]) -> str:
    """Return questions with the right formula to copy and a link to its block in the chapter.

    asked: by paper and place (`omni-arrangement eq:6`) the question, with a formula of its own
    where the chapter's first one is not meant. Raises `ValueError` for a place without a fault.
    """
    equations = {ledger.paper: Equations(ledger) for ledger in ledgers}
    items = "".join(_question(key, asked[key], equations) for key in asked)
    return f'<ol class="questions">{items}</ol>'


def _question(key: str, asked: str | tuple[str, Line], equations: Mapping[str, Equations]) -> str:
    paper, _, place = key.partition(" ")
    known = equations[paper]
    answer = known.answers[place]
    question, line = asked if isinstance(asked, tuple) else (asked, answer.lines[0])
    shown = known.shown(place, line)
    if not shown.is_faulty:
        raise ValueError(f"{key} is as it should be: no question to answer on the first page")
    check_words(key, question)
    verdict = worst(shown.rows)
    where = f"{paper}.html#{anchor(place)}"
    return (
        f'<li class="v-{verdict}"><p class="ask"><a href="{escape(where)}">{inline(question)}</a> '
        f"{badge(verdict)}</p>{math(shown.corrected, display=True)}"
        f'<p class="tools">{_buttons(shown, question)}</p></li>'
    )


def _buttons(shown: Shown, question: str) -> str:
    """Return a button for each language that the formula can be copied in."""
    return "".join(
        f'<button type="button" class="copies" data-text="{escape(shown.pastes[kind])}" '
        f'aria-label="Copy {kind}: {escape(question)}">Copy {kind}</button>'
        for kind in COPIED
        if kind in shown.pastes
    )


def paper_html(ledger: Ledger, edition: Edition, sentence: str = "") -> str:
    """Return one paper: title (a link to its chapter), what came of it, its verdicts to scale."""
    venue = ", ".join(str(part) for part in (edition.venue, edition.year) if part)
    about = f"{', '.join(edition.authors)}. {venue[:1].upper()}{venue[1:]}."
    numbers = f"{ledger.claims} claims, {len(ledger.rows)} rows."
    said = f"<p>{sentence}</p>" if sentence else ""
    return (
        f'<section class="paper"><h3><a href="{escape(ledger.paper)}.html">'
        f"{escape(edition.title)}</a></h3>{said}{bar_html(ledger)}{legend_html(ledger)}"
        f'<p class="quiet">{escape(about)} {numbers} {corrigendum_link(ledger.paper)}</p></section>'
    )


def told(key: str, words: str, find: Find) -> str:
    """Return our words as HTML: `{eq:8}` is a link to a finding, `{eq:8:correct}` what is right.

    Raises `ValueError` for a claim that is no finding, and for a number that is typed.
    """
    check_words(key, words)

    def written(found: re.Match[str]) -> str:
        claim, _, column = found[1].rpartition(":")
        if column not in {"printed", "correct"}:
            row = find(found[1])
            return f'<a href="{row.paper}.html#{anchor(row.id)}">{escape(row.where)}</a>'
        row = find(claim)
        return inline(quoted(row.printed if column == "printed" else row.correction))

    parts = _CLAIM.split(words)
    claims = iter(_CLAIM.finditer(words))
    return "".join(
        inline(part) if place % 2 == 0 else written(next(claims))
        for place, part in enumerate(parts)
    )


def check_words(key: str, words: str) -> None:
    """Raise `ValueError` for a number that is typed: it would not follow the ledger."""
    typed = [*numbers_in(_MATH.sub("", _CLAIM.sub("", words)))]
    if typed:
        raise ValueError(f"{key}: write what the ledger has for {', '.join(typed)}")
