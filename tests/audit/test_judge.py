"""Every kind of claim with every verdict, on a paper of one page."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import tiny_paper

from omniproof.audit import run
from omniproof.audit.evidence import Counterexample, Interval
from omniproof.audit.ledger import Ledger, Row, cells
from omniproof.transcription.faults import BadInput
from omniproof.transcription.model import Uncheckable

FILLED_ALWAYS = {"paper", "id", "where", "kind", "origin", "source", "note", "engines"}


def row(name: str, verdict: str, why: str, **fields: str) -> Any:
    return pytest.param(name, {"verdict": verdict, **fields}, id=f"{name} {verdict}: {why}")


OURS = {"printed": r"\cos x + \sin y", "derived": r"- \sin {y} + \cos {x}"}
MENDED = {"correction": r"\cos x - \sin y", "repair": "explained", "consequence": "motion"}
AT = "x=20/9; y=-26/9; printed=-0.8563; derived=-0.3563"
ROWS = [
    row("eq:1", "verified", "sin 2x", printed=r"\sin 2x = 2 \sin x \cos x", derived=r"\sin {2 x}"),
    row("eq:6[1,1]", "verified", "one", printed="1", derived="1"),
    row("eq:6[1,3]", "verified", "the entry alone is shown", printed="L", derived="L"),
    row("eq:6[2,1]", "verified", "second row", printed=r"\cos x", derived=r"\cos {x}"),
    row("eq:6[2,3]", "erratum", "one sign is wrong", witness=AT, **OURS, **MENDED),
    row("eq:7", "erratum", "the misprint stands again", witness=AT, follows="eq:6[2,3]",
        **OURS, **MENDED),
    row("eq:8", "conditional", "a distance has no sign", printed="x", derived=r"\left|{x}\right|",
        assumption=r"x \geq 0", witness="x=-26/9; printed=-2.889; derived=2.889",
        consequence="motion"),
    row("eq:9", "erratum", "no edit of 3x makes it sin x cos y", printed="3 x",
        derived=r"\sin {x} \cos {y}", correction=r"\sin {x} \cos {y}", repair="manual",
        witness="x=20/9; y=-26/9; printed=6.667; derived=-0.7700", consequence="motion"),
    row("eq:10", "undecided", "the gamma function is beyond the engines", printed="x",
        derived=r"\Gamma\left(x\right)"),
    row("eq:11", "verified", "it rests on a row with a fault", printed="y", derived="y",
        follows="eq:6[2,3]"),
    row("eq:16[1]", "model-gap", "right by the premise, wrong by mechanics", printed="x",
        derived=r"x \cos {y}", correction=r"x \cos {y}", repair="manual", consequence="motion",
        assumption="it rests", witness="x=20/9; y=-26/9; printed=2.222; derived=-2.152"),
    row("eq:16[2]", "verified", "premise and mechanics agree", printed="y", derived="y"),
    row("eq:16[3]", "erratum", "wrong by the premise too", printed="2 x",
        derived=r"x \cos {y}", correction=r"x \cos {y}", repair="manual", consequence="motion",
        witness="x=20/9; y=-26/9; printed=4.444; derived=-2.152"),
    row("eq:17", "verified", "print leaves open what the cosine is taken of",
        printed=r"\cos x\,L", derived=r"L \cos {x}"),
    row("eq:13", "verified", "f(2y) is sin 2y", printed="f(2y)", derived=r"\sin {2 y}"),
    row("eq:14", "erratum", "f(y) is not f(x)", printed="f(y)", derived=r"\sin {x}",
        correction="f(x)", repair="explained", consequence="motion",
        witness="x=20/9; y=-26/9; printed=-0.2500; derived=0.7952"),
    row("sec:1/grows", "verified", "1 < 2 < 3", printed="it grows"),
    row("sec:1/shrinks", "erratum", "1 < 2, and the correction is proved", printed="it shrinks",
        correction="it grows", repair="manual", consequence="motion",
        witness="first=1; second=2; printed=1.00000; derived=2.00000"),
    row("sec:1/same", "conditional", "x is not y, but a condition is proved",
        printed="they agree", assumption="x = y", consequence="motion",
        witness="x=20/9; y=-26/9; printed=2.222; derived=-2.889"),
    row("sec:1/unproved", "undecided", "the correction x = 2y is not proved",
        printed="they agree", witness="x=20/9; y=-26/9; printed=2.222; derived=-2.889"),
    row("sec:1/modelled", "model-gap", "the premise makes them agree", printed="they agree",
        correction="no", repair="manual", consequence="motion",
        witness="x=20/9; y=-26/9; printed=2.222; derived=-2.889"),
    row("sec:1/neither", "erratum", "the premise does not help", printed="they agree",
        correction="no", repair="manual", consequence="motion",
        witness="x=20/9; y=-26/9; printed=2.222; derived=-2.889"),
    row("eq:12", "verified", "xy > 0 iff the signs agree", printed="x y > 0"),
    row("eq:15", "verified", "xy > 0 iff x > 0, where y > 0", printed="x y > 0"),
    row("sec:1/acute", "erratum", "x = 210 degrees is not acute", correction="x = 210",
        printed=r"\{210^\circ, 270^\circ, 330^\circ\}", repair="manual", consequence="motion",
        witness="angle_1=210°; angle_2=270°; angle_3=330°; printed=allowed; "
        "derived=x = 210° or 330°"),
    row("sec:1/angles", "verified", "t = 210 degrees",
        printed=r"\{210^\circ, 270^\circ, 330^\circ\}"),
    row("sec:1/best", "verified", "2 > 1", printed="it is largest at 90 degrees"),
    row("sec:2/frame", "inconsistent", "Sigma here, Omega there", printed=r"\Sigma",
        consequence="text"),
    row("sec:4/frame", "verified", "Omega in both places", printed=r"\Omega"),
    row("sec:2/symbol", "verified", "x stands in the formula", printed="x"),
    row("sec:2/other", "inconsistent", "y does not", printed="y", consequence="text"),
    row("app:A/lever", "inconsistent", "three formulas need the lever L",
        printed="its lever", consequence="text"),
    row("sec:2/lever", "inconsistent", "the place that states the lever", printed="lever",
        consequence="text"),
    row("eq:A.1", "verified", "right with the lever L", printed="L x", derived="L x",
        follows="app:A/lever"),
    row("eq:A.3", "verified", "right with the stated lever", printed="x y", derived="x y"),
    row("eq:A.4", "erratum", "right with neither; most formulas need L", printed="L x",
        derived="L y", correction="L y", repair="explained", consequence="motion",
        witness="L=47/9; x=-26/9; y=10/7; printed=-15.09; derived=7.460"),
    row("eq:A.5", "inconsistent", "right with L, while Eq. (18) has none", printed="M = L x^2",
        derived="x^{2}", correction="M = x^2", repair="explained", follows="app:A/lever",
        consequence="motion", witness="L=47/9; x=-26/9; printed=43.58; derived=8.346"),
    row("eq:A.6", "verified", "right with any lever", printed="y + y", derived="2 y"),
    row("tab:2[exact,value]", "verified", "4", printed="4.00", derived="4",
        interval="4.00000; [3.995, 4.005]"),
    row("tab:2[rounded,value]", "verified", "pi", printed="3.14", derived=r"\pi",
        interval="3.14159; [3.135, 3.145]"),
    row("tab:2[tie,value]", "verified", "1/8 is half-way", printed="0.13",
        derived=r"\frac{1}{8}", interval="0.125000; [0.125, 0.135]"),
    row("tab:2[truncated,value]", "misrounded", "2.718 rounds to 2.72", printed="2.71",
        derived=r"\frac{1359}{500}", correction="2.72", repair="manual",
        interval="2.71800; [2.705, 2.715]", consequence="number",
        witness="printed=2.71; derived=2.71800"),
    row("tab:2[neighbour,value]", "misrounded", "pi rounds to 3.14", printed="3.13",
        derived=r"\pi", correction="3.14", repair="manual", interval="3.14159; [3.125, 3.135]",
        consequence="number", witness="printed=3.13; derived=3.14159"),
    row("tab:2[wrong,value]", "erratum", "pi is not 5", printed="5.00", derived=r"\pi",
        correction="3.14", repair="manual", interval="3.14159; [4.995, 5.005]",
        consequence="number", witness="printed=5.00; derived=3.14159"),
    row("tab:2[count,value]", "erratum", "a count is not rounded", printed="4", derived="3",
        correction="3", repair="manual", interval="3.00000; [3.5, 4.5]",
        consequence="number", witness="printed=4; derived=3.00000"),
    row("xref:sec-2-cites-eq-1", "verified", "Eq. (1) has x", printed="x"),
    row("xref:sec-3-cites-eq-1", "erratum", "Eq. (1) has no y, Eq. (11) is y", printed="y",
        correction="eq:11", repair="manual", consequence="text"),
    row("xref:sec-2-cites-eq-7", "erratum", "no equation is L", printed="L", repair="manual",
        consequence="text"),
    row("xref:sec-3-cites-eq-8", "verified", "there is an Eq. (8)", printed="a distance"),
    row("xref:sec-3-cites-2", "verified", "read by hand", origin="read", printed="a book"),
    row("sec:3/noble", "editorial", "read by hand", origin="read", printed="noble",
        correction="novel", consequence="text"),
    row("fig:1/shape", "uncheckable", "nobody saw the figure", printed="a hexagon",
        source="doubtful"),
]  # fmt: skip


@pytest.fixture(scope="module")
def rows(tiny_ledger: Ledger) -> dict[str, Row]:
    return {row.id: row for row in tiny_ledger.rows}


@pytest.mark.parametrize(("name", "fields"), ROWS)
def test_rows(name: str, fields: dict[str, str], rows: dict[str, Row]) -> None:
    found = cells(rows[name])
    shown = {key for key, value in found.items() if value and key not in FILLED_ALWAYS}
    assert {key: found[key] for key in shown | set(fields)} == fields


@pytest.mark.parametrize(
    ("name", "field", "record"),
    [
        pytest.param("eq:8", "witness", Counterexample(point={"x": "-26/9"}, printed="-2.889",
            derived="2.889"), id="coordinates by name"),
        pytest.param("tab:2[wrong,value]", "witness",
            Counterexample(printed="5.00", derived="3.14159"), id="no symbol is free"),
        pytest.param("tab:2[wrong,value]", "interval",
            Interval(value="3.14159", lower="4.995", upper="5.005"), id="exact value and ends"),
        pytest.param("sec:2/frame", "against", ("sec:3/frame",), id="the other place"),
        pytest.param("app:A/lever", "against", ("sec:2/lever",), id="where the lever is stated"),
        pytest.param("sec:2/lever", "against", ("app:A/lever",), id="where another one is used"),
        pytest.param("fig:1/shape", "uncheckable", Uncheckable.FIGURE_NOT_SEEN, id="class"),
        pytest.param("eq:A.1", "convention", "the lever is L", id="the reading that saves it"),
        pytest.param("eq:A.3", "convention", "the lever is 1", id="the stated reading"),
        pytest.param("eq:A.4", "convention", "the lever is L", id="what most formulas need"),
        pytest.param("eq:A.5", "convention", "the lever is 1", id="mended as stated"),
        pytest.param("eq:A.6", "convention", "the lever is 1", id="it does not matter"),
        pytest.param("eq:1", "convention", "", id="none"),
    ],
)  # fmt: skip
def test_records(name: str, field: str, record: object, rows: dict[str, Row]) -> None:
    assert getattr(rows[name], field) == record


@pytest.mark.parametrize(
    ("name", "engines", "note"),
    [
        ("eq:6[2,3]", "flint+modular+z3", "a matrix."),
        ("eq:10", "", "beyond us. gamma is not among the functions that can be enclosed."),
        ("eq:17", "flint+modular+z3", r"a side. true if one reads $\cos x\,L$ as $\cos(x)\,L$."),
        ("eq:12", "signs", "signs agree."),
        ("sec:1/angles", "exact", "an isosceles triangle."),
        ("sec:2/frame", "text", "name of the frame. differs from sec:3/frame."),
        ("sec:3/frame", "text", "name of the frame. differs from sec:2/frame."),
        ("sec:4/frame", "text", "name of the frame."),
        ("app:A/lever", "flint", "the appendix takes the lever as stated. stated at sec:2/lever: "
         "the lever is 1; used from app:A/lever on: the lever is L. two cures: keep the first, and "
         "change Eq. (A.1), Eq. (A.2), Eq. (A.4), Eq. (A.5); or give the second a name of its own, "
         "and change Eq. (A.3)."),
        ("eq:A.1", "flint+modular+z3", "first. right where the lever is L."),
        ("eq:A.3", "flint+modular+z3", "third. right where the lever is 1."),
        ("eq:A.5", "flint+modular+z3", "fifth. right where the lever is L, against Eq. (18)."),
        ("eq:A.6", "flint+modular+z3", "sixth."),
        ("tab:2[truncated,value]", "flint+mpmath", "numbers. truncated, relative error -0.0029."),
        ("tab:2[neighbour,value]", "flint+mpmath", "numbers. off by one, relative error -0.0037."),
        ("xref:sec-3-cites-eq-1", "text", "eq:1 does not contain $y$."),
        ("xref:sec-3-cites-2", "", "the title says so."),
        ("sec:3/noble", "", "misspelt."),
        ("fig:1/shape", "", "figure-not-seen. Would decide it: Figure 1."),
    ],
)  # fmt: skip
def test_engines_and_notes(name: str, engines: str, note: str, rows: dict[str, Row]) -> None:
    assert (rows[name].engines, rows[name].note) == (engines, note)


def test_rows_stand_in_order_of_place_and_claims_are_counted_without_entries(
    tiny_ledger: Ledger,
) -> None:
    assert (tiny_ledger.paper, tiny_ledger.claims) == ("tiny-paper", 50)
    assert [row.id for row in tiny_ledger.rows[:9]] == [
        "eq:1", "eq:6[1,1]", "eq:6[1,2]", "eq:6[1,3]", "eq:6[2,1]", "eq:6[2,2]", "eq:6[2,3]",
        "eq:7", "eq:8"]  # fmt: skip
    assert len(tiny_ledger.rows) == 50 + 5 + 2


def test_the_same_paper_gives_the_same_bytes(tiny_folder: Path, tiny_ledger: Ledger) -> None:
    assert run.audit_paper(tiny_folder).model_dump_json() == tiny_ledger.model_dump_json()


FAULTS = [
    pytest.param("'eq:8', kind: identity", "'eq:88', kind: identity", [
        "1:1: expected a claim for the derivation `eq:8`, found none",
        "{line}:10: claims[eq:88]: expected a derivation for this identity, found none",
        "{target}:88: claims[xref:sec-3-cites-eq-8].target: expected an equation, figure or "
        "section with claims, found `eq:8`"], id="a renamed claim"),
    pytest.param("'sec:3/noble'", "'sec:3/novel'", [
        "1:1: expected a claim for the reading `sec:3/noble`, found none",
        "{line}:10: claims[sec:3/novel]: expected a reading of this editorial, found none"],
        id="a claim that nobody read"),
    pytest.param("latex: '3 x'", "latex: '3 z'", [
        "{line}:66: claims[eq:9].latex: unknown symbol `z`"], id="an unknown symbol"),
    pytest.param("latex: '3 x'", r"latex: '\begin{pmatrix} x \end{pmatrix}'", [
        "{line}:10: claims[eq:9].latex: expected a single expression, found a matrix of 1 x 1"],
        id="a matrix for a number"),
    pytest.param(r"identity, line: 1, says: double angle, latex: '\sin 2x = 2 \sin x \cos x'",
        r"identity, line: 1, says: double angle, latex: '\sin 2x = (x, y)^T'", [
        "{line}:10: claims[eq:1].latex: expected a single expression, found a matrix of 2 x 1"],
        id="a vector on one side"),
]  # fmt: skip


@pytest.mark.parametrize(("old", "new", "told"), FAULTS)
def test_faults_of_a_paper(
    tiny_folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    old: str, new: str, told: list[str],
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    text = tiny_paper.PAPER.lstrip()
    assert text.count(old) == 1
    folder = tiny_paper.write(Path("paper"))
    text = text.replace(old, new)
    (folder / "paper.yaml").write_text(text, encoding="utf-8")
    line, target = (text.partition(at)[0].count("\n") + 1 for at in (new, "target: 'eq:8'"))
    with pytest.raises(BadInput) as bad:
        run.audit_paper(folder)
    lines = str(bad.value).splitlines()
    assert [one for one in lines if one.startswith("paper/")] == [
        "paper/paper.yaml:" + one.format(line=line, target=target) for one in told
    ]
