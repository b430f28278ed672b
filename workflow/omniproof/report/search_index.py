"""What the search of the report looks through: every claim, in a script that works from disk.

A text is kept once, as a reader would type it (`α₁`, not LaTeX); how it is cut into words and
ranked is the business of `book/_search`. Sections, theorems
and figures come from the pages themselves (`book/_ext/search.py`).
"""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from pydantic import TypeAdapter

from omniproof.audit.ledger import Ledger, Row, Verdict
from omniproof.audit.places import where
from omniproof.corrected import ANSWERS
from omniproof.report.findings import GRAVITY
from omniproof.report.latexfmt import plain
from omniproof.report.theme import MARKS
from omniproof.transcription.ids import whole
from omniproof.transcription.model import Symbol
from omniproof.transcription.paperfile import load_document

COLUMNS = ("id", "place", "verdict", "reach", "follows", "printed", "correct", "note", "symbols")
"""What is known of a claim, in this order; a verdict is its place among all. Empty ends are cut."""

_SYMBOLS = TypeAdapter(tuple[Symbol, ...])
_ENVIRONMENT = re.compile(r"\\(begin|end)\s*\{[A-Za-z]+\*?\}(?:\{[lcr|]+\})?")
_NEEDLESS = re.compile(r"(?<= )\{(\\?[A-Za-z]+(?:_\w)?)\}")
_ROUGH = re.compile(r"[\s{}]|\\(?:left|right|mathbf|boldsymbol|mathrm)(?![A-Za-z])")


def claims_script(ledgers: Sequence[Ledger], papers: Path) -> str:
    """Return the claims of all papers as a script; `papers`: folder of what the papers print."""
    data = {
        "columns": COLUMNS,
        "verdicts": [(verdict, MARKS[verdict].shape, MARKS[verdict].word) for verdict in GRAVITY],
        "papers": [_paper(ledger, papers / ledger.paper) for ledger in ledgers],
    }
    return f"window.CLAIMS = {_json(data)};\n"


def places_script(places: Iterable[tuple[str, str, str, str]]) -> str:
    """Return other places of the report as a script: kind, address, title and text of each."""
    return f"window.PLACES = {_json([*places])};\n"


def text_of(latex: str) -> str:
    """Return a cell of the ledger as a reader would type it, matrices row by row."""
    bare = _NEEDLESS.sub(r"\1", latex)
    opened = _ENVIRONMENT.sub(lambda found: "[" if found[1] == "begin" else "]", bare)
    rows = re.sub(r"\\\\(?:\[[^]]*\])?", "; ", opened)
    return plain(re.sub(r"(?<!\\)&", ", ", rows) if rows != bare else bare)


def _json(data: object) -> str:
    """Return data for a script: no markup can end the script early."""
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"))
    return text.replace("<", "\\u003c")


def _paper(ledger: Ledger, folder: Path) -> dict[str, object]:
    document = load_document(folder / "paper.yaml").values
    known = _SYMBOLS.validate_python(document["symbols"] if isinstance(document, dict) else ())
    symbols = [_rough(symbol.latex) for symbol in known]
    notes = Counter(plain(row.note) for row in ledger.rows)
    shared = [note for note, count in notes.items() if note and count > 1]
    return {
        "key": ledger.paper,
        "symbols": [symbol.means for symbol in known],
        "notes": shared,
        "wholes": [*_wholes(ledger)],
        "rows": [_row(row, symbols, shared) for row in ledger.rows],
    }


def _wholes(ledger: Ledger) -> Iterator[tuple[str, str, Verdict, str, str, str]]:
    """Yield equations and tables: id, place, gravest verdict, rows by verdict, title and reason."""
    answers = ANSWERS.get(ledger.paper, {})
    members: dict[str, list[Row]] = {}
    for row in ledger.rows:
        if row.id.startswith("eq:") or re.match(r"tab:[^/]*\[", row.id):
            members.setdefault(whole(row.id), []).append(row)
    for claim, rows in members.items():
        counts = Counter(row.verdict for row in rows)
        gravest = min(counts, key=GRAVITY.index)
        words = [f"{counts[v]} {MARKS[v].word}" for v in GRAVITY if counts[v]]
        answer = answers.get(claim)
        about = (answer.title, plain(answer.why)) if answer else ("", "")
        yield claim, where(claim), gravest, f"{len(rows)} rows: {', '.join(words)}", *about


def _row(row: Row, symbols: Sequence[str], shared: Sequence[str]) -> list[object]:
    """Return the columns of a row; a note that several rows have is a place in `shared`."""
    printed = _rough(row.printed)
    used = [place for place, latex in enumerate(symbols) if _occurs(latex, printed)]
    right = row.correction or row.assumption
    note = plain(row.note)
    values: list[object] = [
        row.id, row.where, GRAVITY.index(row.verdict), row.consequence, row.follows,
        text_of(row.printed), text_of(right), shared.index(note) if note in shared else note, used,
    ]  # fmt: skip
    while values[-1] in ("", []):
        values.pop()
    return values


def _rough(latex: str) -> str:
    """Return LaTeX without what print does not show, to look for symbols in it."""
    return _ROUGH.sub("", latex)


def _occurs(symbol: str, latex: str) -> bool:
    """Whether a symbol stands in a formula, and not as the beginning of a longer name."""
    before = "" if symbol.startswith("\\") else r"(?<![A-Za-z\\])"
    return re.search(rf"{before}{re.escape(symbol)}(?![A-Za-z_])", latex) is not None
