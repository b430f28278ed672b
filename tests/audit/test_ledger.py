"""The ledger's interface: columns, JSON Schema, CSV and JSON, the same bytes every time."""

from __future__ import annotations

import csv
import io
import json
from importlib.resources import files
from pathlib import Path

import pytest
from pydantic import ValidationError

from omniproof.audit.ledger import (
    COLUMNS,
    Ledger,
    Row,
    Verdict,
    read_json,
    schema,
    to_csv,
    write_csv,
    write_json,
)

CONTRACT = (
    "paper", "id", "where", "kind", "verdict", "origin", "source", "reading", "printed", "derived",
    "correction", "repair", "assumption", "witness", "interval", "follows", "consequence",
    "engines", "note",
)  # fmt: skip
RIGHT = Row(
    paper="a-paper",
    id="eq:6[2,3]",
    where="Eq. (6), row 2, column 3",
    kind="identity",
    verdict="verified",
    printed=r"\sin \alpha_1, \cos \alpha_2",
    engines="flint",
)
WRONG = Row(
    paper="a-paper",
    id="tab:2[X,D_A]",
    where="Table 2, X, D_A",
    kind="value",
    verdict="misrounded",
    source="doubtful",
    printed="4.610",
    correction="4.619",
    repair="manual",
    witness={"point": {"x": "2/7"}, "printed": "4.610", "derived": "4.61880"},
    interval={"value": "4.61880", "lower": "4.6095", "upper": "4.6105"},
    consequence="number",
    engines="flint",
    note='He said "4.610", and\nnothing else.',
)
LEDGER = Ledger(paper="a-paper", claims=2, rows=(RIGHT, WRONG))


def ledger(row: Row) -> Ledger:
    return Ledger(paper=row.paper, claims=1, rows=(row,))


OTHER = Ledger(paper="b-paper", claims=1, rows=(RIGHT.model_copy(update={"paper": "b-paper"}),))


def test_columns_are_those_of_the_contract_in_its_order() -> None:
    assert COLUMNS == CONTRACT


def test_the_schema_in_the_repository_is_that_of_the_model() -> None:
    stored = files("omniproof.audit").joinpath("ledger.schema.json").read_text(encoding="utf-8")
    assert stored == schema(), "the row has changed: write `schema()` to ledger.schema.json"


def test_the_schema_lists_the_vocabulary_of_the_contract() -> None:
    defined = json.loads(schema())["$defs"]
    names = ("Verdict", "Origin", "Consequence", "Repair")
    assert {name: defined[name]["enum"] for name in names} == {
        "Verdict": ["verified", "conditional", "erratum", "misrounded", "inconsistent",
                    "model-gap", "editorial", "uncheckable", "undecided"],
        "Origin": ["computed", "read"],
        "Consequence": ["", "motion", "number", "text"],
        "Repair": ["", "explained", "possible", "manual"],
    }  # fmt: skip


def test_csv_is_one_header_and_the_rows_of_all_papers_in_order() -> None:
    assert to_csv([LEDGER, OTHER]) == (
        ",".join(CONTRACT) + "\n"
        'a-paper,"eq:6[2,3]","Eq. (6), row 2, column 3",identity,verified,computed,clear,,'
        '"\\sin \\alpha_1, \\cos \\alpha_2",,,,,,,,,flint,\n'
        'a-paper,"tab:2[X,D_A]","Table 2, X, D_A",value,misrounded,computed,doubtful,,4.610,,'
        '4.619,manual,,x=2/7; printed=4.610; derived=4.61880,"4.61880; [4.6095, 4.6105]",,number,'
        'flint,"He said ""4.610"", and\nnothing else."\n'
        'b-paper,"eq:6[2,3]","Eq. (6), row 2, column 3",identity,verified,computed,clear,,'
        '"\\sin \\alpha_1, \\cos \\alpha_2",,,,,,,,,flint,\n'
    )


WHOLE = {"lower": "4.50", "upper": "5.00", "upper_closed": False, "value": "4.61880"}
SETUP = {"unknown": "V", "ranges": ({"lower": "1", "upper": "2", "lower_closed": False},)}
NONE = {"unknown": "V", "ranges": (), "contradicting": ("tab:1[a]", "tab:1[b]")}


@pytest.mark.parametrize(
    ("fields", "column", "text"),
    [
        pytest.param({"interval": WHOLE}, "interval", "4.61880; [4.50, 5.00)", id="an open end"),
        pytest.param({"interval": WHOLE | {"setup": SETUP}}, "interval",
            "4.50 ≤ x < 5.00 by its digits; 1 < V ≤ 2 with all cells", id="a fitted set-up"),
        pytest.param({"interval": WHOLE | {"setup": NONE, "included": False}}, "interval",
            "4.50 ≤ x < 5.00 by its digits; none: tab:1[a], tab:1[b] contradict each other "
            "by the cells", id="no set-up"),
        pytest.param({"rivals": ({"correction": "a"}, {"correction": "b"})}, "note",
            "right. as small an edit: $a$, or $b$.", id="rivals are shown"),
        pytest.param({"rivals": ({"correction": "a"},) * 3}, "note",
            "right. 3 other edits of the same size would make it true, too.",
            id="many rivals are counted"),
    ],
)  # fmt: skip
def test_records_are_plain_text_in_the_csv_only(
    fields: dict[str, object], column: str, text: str
) -> None:
    row = Row.model_validate(RIGHT.model_dump() | {"note": "right."} | fields)
    assert next(csv.DictReader(io.StringIO(to_csv([ledger(row)]))))[column] == text
    assert text not in ledger(row).model_dump_json()
    assert Ledger.model_validate_json(ledger(row).model_dump_json()) == ledger(row)


def test_rows_are_members_of_sets() -> None:
    assert len({RIGHT, WRONG, WRONG.model_copy()}) == 2


def test_files_read_back_and_have_the_same_bytes_every_time(tmp_path: Path) -> None:
    for name in ("first", "second"):
        write_json(LEDGER, tmp_path / f"{name}.json")
        write_csv([LEDGER], tmp_path / f"{name}.csv")
    assert read_json(tmp_path / "first.json") == LEDGER
    for kind in ("json", "csv"):
        assert (tmp_path / f"first.{kind}").read_bytes() == (
            tmp_path / f"second.{kind}"
        ).read_bytes()
    assert b"\r" not in (tmp_path / "first.csv").read_bytes()


@pytest.mark.parametrize(
    "change",
    [
        pytest.param({"verdict": "true"}, id="unknown verdict"),
        pytest.param({"kind": "idea"}, id="unknown kind"),
        pytest.param({"time": "now"}, id="unknown column"),
        pytest.param({"printed": 4.61}, id="a number that would lose its zeros"),
        pytest.param({"witness": "x=1; printed=2; derived=3"}, id="text in place of a record"),
        pytest.param({"interval": "3.14; [3.1, 3.2]"}, id="text in place of an interval"),
    ],
)
def test_what_is_no_row_is_refused(change: dict[str, object]) -> None:
    with pytest.raises(ValidationError):
        Row.model_validate(RIGHT.model_dump() | change)


@pytest.mark.parametrize(
    ("verdict", "is_fault"),
    [
        ("verified", False), ("conditional", True), ("erratum", True), ("misrounded", True),
        ("inconsistent", True), ("model-gap", True), ("editorial", True), ("uncheckable", False),
        ("undecided", False),
    ],
)  # fmt: skip
def test_which_verdicts_a_reader_has_to_know_of(verdict: str, is_fault: bool) -> None:
    assert Verdict(verdict).is_fault is is_fault
