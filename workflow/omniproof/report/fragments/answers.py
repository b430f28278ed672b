"""What to use: each equation as a whole, as printed and as it should read, with text to paste.

Faulty equations come first, the gravest before the others; each block bears the address of its
equation, and what to paste stands in tabs that need no script.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from html import escape

from omniproof.audit.ledger import Row
from omniproof.audit.places import where
from omniproof.corrected.answer import Answer
from omniproof.report.anchors import anchor, rows_anchor
from omniproof.report.answers import Equations, Shown
from omniproof.report.findings import GRAVITY
from omniproof.report.fragments.base import Href, badge, link, worst
from omniproof.report.fragments.claims import witness_html
from omniproof.report.latexfmt import cell, inline, is_latex, math


def answers_html(equations: Equations, href: Href) -> str:
    """Return the blocks of all equations: those with a fault, then a line for every other one."""
    blocks = {
        place: (answer, [equations.shown(place, line) for line in answer.lines])
        for place, answer in equations.answers.items()
    }
    faulty = [place for place, (_, lines) in blocks.items() if any(s.is_faulty for s in lines)]
    faulty.sort(key=lambda place: GRAVITY.index(_verdict_of(blocks[place][1])))
    sound = [place for place in blocks if place not in faulty]
    html = [_faulty(place, *blocks[place], href) for place in faulty]
    if sound:
        others = "".join(_sound(place, *blocks[place]) for place in sound)
        title = f"The other {len(sound)} equations, each to unfold"
        html.append(f'<details class="others"><summary>{title}</summary>{others}</details>')
    return f'<div class="answers">{"".join(html)}</div>'


def _verdict_of(lines: list[Shown]) -> str:
    return worst(row for shown in lines for row in shown.rows)


def _faulty(place: str, answer: Answer, lines: list[Shown], href: Href) -> str:
    numbered = sorted(enumerate(lines, 1), key=lambda found: not found[1].is_faulty)
    body = "".join(_line(place, number, shown, href) for number, shown in numbered)
    why = f'<p class="why">{inline(answer.why)}</p>' if answer.why else ""
    return (
        f'<section class="answer v-{_verdict_of(lines)}"{_address(place)}>'
        f'<div class="answer-head">{_head(place, answer, lines)}</div>{why}{body}'
        f'<p class="quiet"><a href="#{_rows(place)}">Row by row</a></p></section>'
    )


def _sound(place: str, answer: Answer, lines: list[Shown]) -> str:
    body = "".join(
        f'<div class="answer-line">{_formula(shown.printed) if number > 1 else ""}'
        f"{_tabs(place, number, shown.pastes)}</div>"
        for number, shown in enumerate(lines, 1)
    )
    return (
        f'<details class="answer v-{_verdict_of(lines)}"{_address(place)}>'
        f"<summary>{_head(place, answer, lines)} {_formula(lines[0].printed)}</summary>"
        f'{body}<p class="quiet"><a href="#{_rows(place)}">Row by row</a></p></details>'
    )


def _head(place: str, answer: Answer, lines: list[Shown]) -> str:
    title = f'<span class="quiet">{inline(answer.title)}</span>' if answer.title else ""
    return f"{badge(worst(r for s in lines for r in s.rows))} <b>{escape(where(place))}</b> {title}"


def _address(place: str) -> str:
    """Return the address that a block bears: an equation's; other places have it in their rows."""
    address = f' id="{anchor(place)}"' if place.startswith("eq:") else ""
    return f'{address} data-place="{escape(place)}"'


def _rows(place: str) -> str:
    return rows_anchor(place) if place.startswith("eq:") else anchor(place)


def _line(place: str, number: int, shown: Shown, href: Href) -> str:
    """Return a formula of a faulty equation: print, what it should be, why, and to paste."""
    tabs = _tabs(place, number, shown.pastes)
    if not shown.is_faulty:
        pasted = f"<details><summary>To paste</summary>{tabs}</details>"
        return f"{_formula(shown.printed)}{pasted}"
    faults = [row for row in shown.rows if row.verdict.is_fault]
    facts = "".join(
        f"<div><dt>{term}</dt><dd>{html}</dd></div>" for term, html in _facts(faults, href) if html
    )
    right = shown.corrected if shown.corrected != shown.printed else ""
    corrected = f"<div><dt>should read</dt><dd>{_formula(right)}</dd></div>" if right else ""
    known = f'<dl class="facts">{facts}</dl>' if facts else ""
    return (
        f'<div class="answer-line"><dl class="pair"><div><dt>printed</dt>'
        f"<dd>{_formula(shown.printed)}</dd></div>{corrected}</dl>"
        f"{known}{tabs}</div>"
    )


def _facts(faults: list[Row], href: Href) -> Iterator[tuple[str, str]]:
    first = faults[0]
    yield "true when", cell(first.assumption)
    yield "counterexample", witness_html(first.witness)
    yield "follows from", link(first.follows, href) if first.follows else ""


def _formula(latex: str) -> str:
    return math(latex, display=True) if is_latex(latex) else cell(latex)


def _tabs(place: str, number: int, pastes: Mapping[str, str]) -> str:
    """Return tabs with text to paste; a radio button opens each."""
    if not pastes:
        return ""
    name = f"paste-{anchor(place)}-{number}"
    choices = "".join(
        f'<label><input type="radio" name="{name}" value="{kind}"{" checked" * (k == 0)}>'
        f"{'Use from omniproof' if kind == 'omniproof' else kind}</label>"
        for k, kind in enumerate(pastes)
    )
    panels = "".join(
        f'<div class="panel" data-kind="{kind}"><button type="button" class="copy">Copy'
        f'<span class="sr-only"> {kind} of {escape(where(place))}</span></button>'
        f"<pre><code>{escape(text)}</code></pre></div>"
        for kind, text in pastes.items()
    )
    return (
        f'<fieldset class="pastes"><legend class="sr-only">{escape(where(place))}, to paste as'
        f'</legend><div class="choices">{choices}</div>{panels}</fieldset>'
    )
