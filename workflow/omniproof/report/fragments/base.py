"""The unit of output, and the small pieces that every fragment is made of."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import Any

from omniproof.audit.ledger import Row, Verdict
from omniproof.audit.places import where
from omniproof.report.findings import GRAVITY
from omniproof.report.latexfmt import inline
from omniproof.report.theme import MARKS
from omniproof.transcription.model import ID

_SENTENCE = re.compile(r"(?:^|(?<=\. ))(?:a(?= )|[a-z](?=[a-z]+(?:[ ,.;]|$)))")

Href = Callable[[str], str | None]
"""Claim id -> link to it from this page, or None when the claim has no address."""


@dataclass(frozen=True)
class Fragment:
    """Finished HTML; a notebook stores it as `text/html` with a short name as `text/plain`."""

    html: str
    name: str = "fragment"

    def _repr_html_(self) -> str:
        return self.html

    def _repr_mimebundle_(self, **_: Any) -> dict[str, str]:
        return {"text/html": self.html, "text/plain": self.name}


@dataclass(frozen=True)
class Written:
    """MyST Markdown for Sphinx to read: what it numbers and other pages refer to."""

    markdown: str
    name: str

    def _repr_mimebundle_(self, **_: Any) -> dict[str, str]:
        return {"text/markdown": self.markdown, "text/plain": self.name}


def results_folder(start: Path | None = None) -> Path:
    """Return the folder of results: `OMNIPROOF_RESULTS`, else `results` here or in a parent folder.

    Raises `FileNotFoundError` when there is none: nothing has been built yet.
    """
    named = os.environ.get("OMNIPROOF_RESULTS")
    if named:
        return Path(named)
    here = (start or Path.cwd()).resolve()
    for folder in (here, *here.parents):
        if (folder / "results" / "ledger").is_dir():
            return folder / "results"
    raise FileNotFoundError("no folder results/ledger here or above: run `make` first")


def corrigendum_link(paper: str) -> str:
    """Return the link to what can be sent to the authors of a paper."""
    return f'<a href="corrigenda/{escape(paper)}.pdf">Corrigendum for the authors (PDF)</a>'


def badge(verdict: Verdict, count: str = "") -> str:
    """Return the sign of a verdict: shape, word and colour (and a count such as `1 of 9`)."""
    mark = MARKS[verdict]
    number = f"{escape(count)} " if count else ""
    return (
        f'<span class="badge-verdict v-{verdict}"><span aria-hidden="true">{mark.shape}</span> '
        f"{number}{mark.word}</span>"
    )


def worst(rows: Iterable[Row]) -> Verdict:
    """Return the verdict to show for several rows: the first that occurs in order of gravity."""
    found = {row.verdict for row in rows}
    return next((verdict for verdict in GRAVITY if verdict in found), Verdict.VERIFIED)


def link(claim_id: str, href: Href) -> str:
    """Return the place of a claim in words, as a link when it has an address."""
    target = href(claim_id)
    words = escape(where(claim_id) if ID.fullmatch(claim_id) else claim_id)
    return f'<a href="{escape(target)}">{words}</a>' if target else words


def note_html(note: str, href: Href) -> str:
    """Return a note as a sentence; claims that it names become links."""
    return inline(sentences(note), lambda claim: link(claim, href))


def sentences(note: str) -> str:
    """Return a note with a capital at the start of each sentence that starts with a word."""
    return _SENTENCE.sub(lambda found: found[0].upper(), note)


def interval_html(row: Row) -> str:
    """Return the exact value, and what the printed decimal stands for."""
    if row.interval is None:
        return ""
    if row.interval.setup:
        return inline(str(row.interval))
    lies = {
        Verdict.VERIFIED: "is in",
        Verdict.MISROUNDED: "is not in",
        Verdict.ERRATUM: "is not in",
    }
    lie = lies.get(row.verdict, "beside")
    return escape(f"{row.interval.value} {lie} {row.interval.bounds}")


def table(head: Sequence[str], rows: Iterable[str], kind: str = "") -> str:
    """Return a table in a box of its own that scrolls; head cells and rows are HTML already."""
    columns = "".join(f'<th scope="col">{cell}</th>' for cell in head)
    return (
        f'<div class="wide">'
        f'<table class="audit {kind}"><thead><tr>{columns}</tr></thead>'
        f"<tbody>{''.join(rows)}</tbody></table></div>"
    )
