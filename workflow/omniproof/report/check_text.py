"""One checked statement, for a terminal and for programs: results in, text out."""

from __future__ import annotations

import json

from omniproof.audit.check import CheckResult, Finding
from omniproof.decide.answer import Witness
from omniproof.report.layout import detail, head

COLOURS = {
    Finding.VERIFIED: 32,
    Finding.ERRATUM: 31,
    Finding.CONDITIONAL: 33,
    Finding.DEFINITION: 36,
    Finding.UNDECIDED: 35,
    Finding.INVALID: 31,
}
"""Colours of the verdicts, as terminals number them."""


def check_text(result: CheckResult, width: int) -> str:
    """Write a result for a terminal of `width` columns; its first word is the verdict."""
    lines = head(result.verdict.upper(), result.printed, width)
    details = {
        "holds for": result.condition,
        "witness": _witness(result.witness),
        "repair": result.repairs[0].text if result.repairs else "",
        "engines": ", ".join(result.engines),
        "note": result.message,
    }
    for name, text in details.items():
        lines += detail(name, text, width)
    return "\n".join(lines)


def check_json(result: CheckResult) -> str:
    """Write a result as one JSON object of strings, empty where there is nothing to say.

    In `witness`, `printed` is the value of the left side and `derived` that of the right one;
    `repair` is the likeliest single edit that makes the statement true.
    """
    record = {
        "verdict": result.verdict,
        "printed": result.printed,
        "witness": str(result.witness or ""),
        "condition": result.condition,
        "repair": result.repairs[0].text if result.repairs else "",
        "engines": "+".join(result.engines),
        "message": result.message,
    }
    return json.dumps(record, indent=1)


def _witness(witness: Witness | None) -> str:
    if witness is None:
        return ""
    values = dict(witness.point) | {"left": witness.printed, "right": witness.derived}
    return "; ".join(f"{name} = {value}" for name, value in values.items())
