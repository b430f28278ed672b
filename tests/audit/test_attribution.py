"""Which fault explains which row, and how far a fault reaches."""

from __future__ import annotations

from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import Any

import pytest

from omniproof.audit.attribution import attribute
from omniproof.audit.ledger import Row
from omniproof.registry import Registry


@dataclass
class FakeContext:
    """As much of a context as the rules look at."""

    registry: Registry
    claims: dict[str, Any] = field(default_factory=dict)


def made(name: str, verdict: str, kind: str = "identity", printed: str = "") -> Row:
    return Row(paper="p", id=name, where="", kind=kind, verdict=verdict, printed=printed or name)


def printed_claim(form: str) -> Any:
    asserts = SimpleNamespace(form=form)
    return SimpleNamespace(asserts=asserts, agrees_with=("eq:9",), target="eq:9", about="x")


def attributed(*rows: Row, form: str = "increasing", **rests_on: str) -> list[Row]:
    """Attribute rows; `eq_2="eq:1"` says that the derivation of eq:2 rests on eq:1."""
    registry = Registry("p")
    for claim, premise in rests_on.items():
        registry.derives(claim.replace("_", ":", 1), rests_on=[premise])(lambda: None)
    claims = {row.id: printed_claim(form) for row in rows}
    return attribute(rows, FakeContext(registry, claims))  # type: ignore[arg-type]


def follows(*rows: Row, **rests_on: str) -> list[str]:
    return [row.follows for row in attributed(*rows, **rests_on)]


def wrong_reference(name: str) -> Row:
    return made(name, "erratum", "reference")


FAULT = made("eq:1", "erratum", printed="wrong")
CONDITION = made("eq:1", "conditional")


@pytest.mark.parametrize(
    ("rows", "rests_on", "expected"),
    [
        pytest.param([FAULT, made("eq:2", "verified")], {"eq_2": "eq:1"}, ["", "eq:1"],
                     id="right once the premise is mended"),
        pytest.param([made("eq:1", "verified"), made("eq:2", "verified")], {"eq_2": "eq:1"},
                     ["", ""], id="a right premise explains nothing"),
        pytest.param([FAULT, made("eq:2", "erratum")], {"eq_2": "eq:1"}, ["", "eq:1"],
                     id="wrong in the same way"),
        pytest.param([made("eq:1", "erratum", "value", "1.5"),
                      made("eq:2", "erratum", "value", "1.5")], {"eq_2": "eq:1"}, ["", "eq:1"],
                     id="the wrong decimal again"),
        pytest.param([FAULT, made("eq:2", "erratum", "value", "1.5")], {"eq_2": "eq:1"}, ["", ""],
                     id="a decimal that is wrong though its premise is mended"),
        pytest.param([FAULT, made("eq:2", "conditional")], {"eq_2": "eq:1"}, ["", ""],
                     id="wrong in another way: a fault of its own"),
        pytest.param([CONDITION, made("eq:2", "conditional")], {"eq_2": "eq:1"}, ["", "eq:1"],
                     id="the condition of the premise again"),
        pytest.param([FAULT, made("eq:2", "verified")], {}, ["", ""], id="no premise"),
        pytest.param([FAULT, made("eq:2[1,2]", "verified")], {"eq_2": "eq:1"}, ["", "eq:1"],
                     id="an entry of a matrix rests on what the matrix rests on"),
        pytest.param([FAULT, made("eq:2", "uncheckable")], {"eq_2": "eq:1"}, ["", ""],
                     id="what nobody can check follows from nothing"),
        pytest.param([FAULT, made("eq:3", "erratum", printed="wrong")], {}, ["", "eq:1"],
                     id="a misprint that stands again"),
        pytest.param([FAULT, made("eq:3", "erratum", printed="wrong"),
                      made("eq:4", "erratum", printed="wrong")], {}, ["", "eq:1", "eq:1"],
                     id="and again: the first place explains both"),
        pytest.param([FAULT, made("eq:3", "verified", printed="wrong")], {}, ["", ""],
                     id="the same print may be right elsewhere"),
        pytest.param([made("tab:1[1]", "erratum", "value", "4.61"),
                      made("tab:1[2]", "erratum", "value", "4.61")], {}, ["", ""],
                     id="the same number in two cells is no recurring misprint"),
        pytest.param([wrong_reference("xref:a"), wrong_reference("xref:b")],
                     {}, ["", "xref:a"], id="a wrong reference to the same place, for the same"),
        pytest.param([made("xref:a", "verified", "reference"), wrong_reference("xref:b")],
                     {}, ["", ""], id="a right reference explains no wrong one"),
        pytest.param([made("sec:1/a", "inconsistent", "consistency", "q_i"),
                      made("sec:2/a", "inconsistent", "consistency", "q_i")],
                     {}, ["", "sec:1/a"], id="the same contradiction again"),
        pytest.param([made("sec:1/a", "inconsistent", "consistency", "q_i"),
                      made("sec:2/a", "inconsistent", "consistency", "q_k")],
                     {}, ["", ""], id="the other side of a contradiction is no recurrence"),
        pytest.param([made("eq:2", "verified"), FAULT], {"eq_2": "eq:1"}, ["eq:1", ""],
                     id="the premise may stand further down"),
    ],
)  # fmt: skip
def test_follows(rows: list[Row], rests_on: dict[str, str], expected: list[str]) -> None:
    assert follows(*rows, **rests_on) == expected


@pytest.mark.parametrize(
    ("row", "form", "expected"),
    [
        pytest.param(made("eq:1", "erratum"), "", "motion", id="a wrong formula"),
        pytest.param(made("eq:1", "conditional"), "", "motion", id="a formula with a condition"),
        pytest.param(made("tab:1[1]", "misrounded", "value"), "", "number", id="a number"),
        pytest.param(made("sec:1/a", "erratum", "relation"), "largest", "motion",
                     id="a choice between designs"),
        pytest.param(made("sec:1/a", "erratum", "relation"), "minimum", "motion", id="an optimum"),
        pytest.param(made("sec:1/a", "erratum", "relation"), "positive", "text",
                     id="a step of an argument"),
        pytest.param(made("app:C/a", "erratum", "relation"), "maximum", "text",
                     id="a step of a proof in an appendix"),
        pytest.param(made("sec:1/a", "inconsistent", "consistency"), "", "text", id="a name"),
        pytest.param(made("xref:a", "erratum", "reference"), "", "text", id="a reference"),
        pytest.param(made("sec:1/a", "editorial", "editorial"), "", "text", id="a word"),
        pytest.param(made("eq:1", "verified"), "", "", id="a right formula has none"),
        pytest.param(made("eq:1", "uncheckable"), "", "", id="nor has what nobody can check"),
        pytest.param(made("eq:1", "undecided"), "", "", id="nor has what we failed to decide"),
    ],
)  # fmt: skip
def test_consequence(row: Row, form: str, expected: str) -> None:
    (found,) = attributed(row, form=form)
    assert found.consequence == expected


@pytest.mark.parametrize("name", ["eq:1", "eq:1[2,3]"])
def test_a_formula_that_nothing_rests_on_reaches_the_text_only(name: str) -> None:
    registry = Registry("p")
    registry.derives("eq:1", idle=True)(lambda: None)
    row = made(name, "erratum")
    context = FakeContext(registry, {name: printed_claim("equal")})
    (found,) = attribute([row], context)  # type: ignore[arg-type]
    assert found.consequence == "text"


def test_nothing_else_of_a_row_changes() -> None:
    (first, second) = attributed(FAULT, made("eq:2", "verified"), eq_2="eq:1")
    assert first == FAULT.model_copy(update={"consequence": first.consequence})
    assert second.model_copy(update={"follows": ""}) == made("eq:2", "verified")
