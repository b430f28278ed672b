"""A good folder, and a table of bad ones: every fault with its place, its words and its cure."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from omniproof.transcription.faults import BadInput
from omniproof.transcription.loader import load_paper
from omniproof.transcription.messages import label
from omniproof.transcription.model import Claim, Form
from omniproof.transcription.tree import Chain, Degrees, Name, Number, walk

GOOD = r"""key: some-paper
edition:
  title: On wheels
  authors: [A. Writer]
  year: 2023
  venue: Journal 1(1)
  source: some-paper.txt
  sha256: 0000000000000000000000000000000000000000000000000000000000000000
symbols:
  - {latex: '\alpha_1', name: alpha_1, means: an angle}
  - {latex: 'L', name: L, positive: true, means: a radius}
  - {latex: 'D_V', name: D_V, role: quantity, means: a volume}
tables:
  - id: tab:2
    file: table-2.csv
    line: 20
    says: two volumes
    units: {D_V: m^3}
claims:
  - id: eq:1
    kind: identity
    line: 3
    says: a product
    latex: 'D_V(\alpha_1) = L \sin\alpha_1'
  - id: sec:2/smallest
    kind: relation
    line: 30
    says: the least one
    asserts: {form: minimum, at: '(30^\circ, 1)'}
  - id: sec:2/same
    kind: consistency
    line: 31
    says: the same letter
    printed: D_V
    agrees_with: eq:1
  - id: xref:sec-2-cites-eq-1
    kind: reference
    line: 32
    says: the right equation
    target: eq:1
"""
TABLE = "type,D_V,D_A\nX,3.08,4.00\nY,9.24,6.\n"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    folder = tmp_path / "paper_data" / "some-paper"
    folder.mkdir(parents=True)
    (folder / "paper.yaml").write_text(GOOD, encoding="utf-8")
    (folder / "table-2.csv").write_text(TABLE, encoding="utf-8")
    return folder


def faults_of(folder: Path) -> list[str]:
    with pytest.raises(BadInput) as bad:
        load_paper(folder)
    return str(bad.value).split("\n")


def test_a_good_folder(folder: Path) -> None:
    loaded = load_paper(folder)
    assert [claim.id for claim in loaded.claims] == [
        "eq:1",
        *(f"tab:2[{cell}]" for cell in ("X,D_V", "X,D_A", "Y,D_V", "Y,D_A")),
        "sec:2/smallest",
        "sec:2/same",
        "xref:sec-2-cites-eq-1",
    ]
    cell = loaded.claims[3]
    assert (cell.printed, cell.unit, cell.line, cell.says) == ("9.24", "m^3", 21, "two volumes")
    assert loaded.claims[4].printed == "6.", "cells are text"
    assert loaded.claims[4].unit is None
    place = loaded.positions["tab:2[Y,D_A]"]
    assert (place.file, place.line, place.column) == ("paper_data/some-paper/table-2.csv", 3, 8)
    assert loaded.positions["sec:2/same"].line == 30
    assert isinstance(loaded.trees["eq:1"], Chain)
    assert loaded.sources["eq:1"] == r"D_V(\alpha_1) = L \sin\alpha_1"
    assert len(loaded.points["sec:2/smallest"]) == 1
    assert loaded.symbols["\\alpha_1"].name == "alpha_1"


def test_assumptions_and_ranges_are_read(folder: Path) -> None:
    text = GOOD.replace(FORMULA, ASSUMED + r"['0 < L < 2', '\alpha_1 \neq L']")
    text = text.replace("name: alpha_1,", r"name: alpha_1, range: '(0, 90^\circ)',")
    (folder / "paper.yaml").write_text(text, encoding="utf-8")
    loaded = load_paper(folder)
    assert [len(list(walk(node))) for node in loaded.assumptions["eq:1"]] == [7, 3]
    assert loaded.ranges == {"\\alpha_1": (Number("0"), Degrees("90"))}


def test_fragments_are_joined(folder: Path) -> None:
    text = GOOD.replace(r"'D_V(\alpha_1) = L \sin\alpha_1'", r"['L =', 'L']")
    (folder / "paper.yaml").write_text(text, encoding="utf-8")
    loaded = load_paper(folder)
    assert loaded.sources["eq:1"] == "L = L"
    assert loaded.trees["eq:1"] == Chain((Name("L"), Name("L")))


FORMULA = r"'D_V(\alpha_1) = L \sin\alpha_1'"
FILE = "paper_data/some-paper/paper.yaml"
ASSUMED = FORMULA + "\n    assumes: "
KINDS = "identity, value, relation, consistency, reference, editorial"
ONE = [f"1 fault in {FILE}"]
TWO = [f"2 faults in {FILE}"]
BAD = [
    pytest.param(FORMULA, ASSUMED + r"'L = 2'", [
        f"{FILE}:25:14: claims[eq:1].assumes[1]: expected an inequality, found 'L = 2'",
        r"    write `0 < \theta < 90^\circ`, or `a \neq b`", *ONE], id="an equation is assumed"),
    pytest.param(FORMULA, ASSUMED + r"['L > 0', 'L < M']", [
        f"{FILE}:25:24: claims[eq:1].assumes[2]: unknown symbol `M`",
        "    L < M", "        ^", "    declare it under `symbols`", *ONE],
        id="an unknown symbol is assumed"),
    pytest.param("agrees_with: eq:1", "agrees_with: eq:1\n    assumes: 'L > 0'", [
        f"{FILE}:36:14: claims[sec:2/same].assumes: "
        "`assumes` belongs to the kinds identity and relation", *ONE],
        id="a letter assumes nothing"),
    pytest.param("name: alpha_1,", "name: alpha_1, range: '(0, L)',", [
        f"{FILE}:10:47: symbols[alpha_1].range: expected an open interval, found '(0, L)'",
        r"    write its ends: `(0, 90^\circ)`", *ONE], id="a range without numbers"),
    pytest.param("claims:", "claims: [", [
        f"{FILE}:20:3: expected YAML, found a fault: did not find expected node content",
        "    check the indentation, and put LaTeX between single quotes", *ONE],
        id="broken YAML"),
    pytest.param("year: 2023", "year:\t2023\n\tmonth: 1", [
        f"{FILE}:6:1: expected YAML, found a fault: "
        "found a tab character that violates indentation",
        "    check the indentation, and put LaTeX between single quotes", *ONE],
        id="tabulator"),
    pytest.param("On wheels", "On\x00wheels", [
        f"{FILE}:3:12: expected YAML, found a fault: control characters are not allowed",
        "    check the indentation, and put LaTeX between single quotes", *ONE],
        id="control character"),
    pytest.param("says: a product", "says: a product\n    says: another", [
        f"{FILE}:24:5: claims[1]: expected each key once, found `says` again",
        "    the first one is on line 23", *ONE],
        id="duplicate key"),
    pytest.param("key: some-paper", "key: &k some-paper", [
        f"{FILE}:1:6: key: expected a value, found the anchor `&k`",
        "    leave it out", *ONE],
        id="anchor"),
    pytest.param("key: some-paper", "key: *k", [
        f"{FILE}:1:6: key: expected a value, found the alias `*k`",
        "    write the value out", *ONE],
        id="alias"),
    pytest.param("key: some-paper", "key: !!python/object/apply:os.system ['true']", [
        f"{FILE}:1:6: key: expected plain text, found the tag "
        "`tag:yaml.org,2002:python/object/apply:os.system`",
        "    leave the tag out", *ONE],
        id="tag that would run code"),
    pytest.param("key: some-paper", "key: " + "[" * 100_000, [
        f"{FILE}:1:17: key{'[1]' * 11}: expected at most 12 levels, found more",
        "    write less deep", *ONE],
        id="deep"),
    pytest.param("kind: identity", "kind: identitty", [
        f"{FILE}:21:11: claims[eq:1].kind: expected one of {KINDS}, found 'identitty'",
        "    did you mean `identity`?", *ONE],
        id="unknown kind"),
    pytest.param("says: a product", "sais: a product", [
        f"{FILE}:20:5: claims[eq:1]: expected the key `says`, found none",
        "    add `says: …`",
        f"{FILE}:23:5: claims[eq:1]: expected one of {', '.join(sorted(Claim.model_fields))}, "
        "found 'sais'",
        "    did you mean `says`?", *TWO],
        id="unknown key, and the one it should be"),
    pytest.param("id: sec:2/same", "id: eq:1", [
        f"{FILE}:30:9: claims[eq:1].id: expected each id once, found `eq:1` again",
        f"    the first one is at {FILE}:20",
        f"{FILE}:35:18: claims[eq:1].agrees_with[1]: "
        "expected another claim, found the claim itself", *TWO],
        id="duplicate id"),
    pytest.param("id: sec:2/same", "id: 'tab:2[X,D_V]'", [
        f"{FILE}:30:9: claims[tab:2[X,D_V]].id: expected each id once, found `tab:2[X,D_V]` again",
        "    the first one is at paper_data/some-paper/table-2.csv:2", *ONE],
        id="id of a table's cell"),
    pytest.param("id: sec:2/same", "id: Section 2", [
        f"{FILE}:30:9: claims[Section 2].id: expected an id such as eq:6, eq:10/a3 or "
        "tab:2[Z,D_A], found 'Section 2'", *ONE],
        id="no id"),
    pytest.param("line: 3\n", "line: three\n", [
        f"{FILE}:22:11: claims[eq:1].line: expected a whole number, found 'three'", *ONE],
        id="no number"),
    pytest.param("line: 3\n", "line: 0\n", [
        f"{FILE}:22:11: claims[eq:1].line: expected a number from 1, found '0'", *ONE],
        id="line 0"),
    pytest.param("says: a product", "says:", [
        f"{FILE}:23:10: claims[eq:1].says: expected text, found nothing", *ONE],
        id="empty text"),
    pytest.param("says: a product", "says: [a, product]", [
        f"{FILE}:23:11: claims[eq:1].says: expected text, found a list", *ONE],
        id="list for text"),
    pytest.param("form: minimum", "form: minimun", [
        f"{FILE}:29:21: claims[sec:2/smallest].asserts.form: expected one of {', '.join(Form)}, "
        "found 'minimun'",
        "    did you mean `minimum`?", *ONE],
        id="unknown form"),
    pytest.param("form: minimum, ", "form: largest, ", [
        f"{FILE}:29:14: claims[sec:2/smallest].asserts: `member` belongs to the forms largest and "
        "smallest, and only there", *ONE],
        id="form without its member"),
    pytest.param("role: quantity", "role: quantities", [
        f"{FILE}:12:37: symbols[D_V].role: expected one of variable, quantity, undefined, "
        "found 'quantities'",
        "    did you mean `quantity`?", *ONE],
        id="unknown role"),
    pytest.param("positive: true", "positive: maybe", [
        f"{FILE}:11:37: symbols[L].positive: expected true or false, found 'maybe'", *ONE],
        id="no truth value"),
    pytest.param(FORMULA, "__import__('os').system('touch hacked')", [
        f"{FILE}:24:12: claims[eq:1].latex: expected a number, a symbol or a bracket, found `_`",
        "    __import__('os').system('touch hacked')",
        "    ^",
        "    write LaTeX as the paper prints it, in symbols that are declared", *ONE],
        id="code in a formula"),
    pytest.param(FORMULA, r"'L + \sin'", [
        rf"{FILE}:24:12: claims[eq:1].latex: expected the argument of `\sin`, found the end of the "
        "formula",
        r"    L + \sin",
        "            ^",
        r"    write `\sin(…)`", *ONE],
        id="unreadable formula"),
    pytest.param(FORMULA, "'1/3L'", [
        f"{FILE}:24:12: claims[eq:1].latex: it is not clear what the slash divides by",
        "    1/3L",
        "    ~~~^",
        r"    write `\frac{…}{…}`, or settle it with `slash: first` or `slash: all` "
        "in the notation",
        *ONE],
        id="ambiguous formula"),
    pytest.param(FORMULA, r"['D_V =', 'L \alpha_2']", [
        rf"{FILE}:24:22: claims[eq:1].latex[2]: unknown symbol `\alpha_2`",
        r"    D_V = L \alpha_2",
        "            ~~~~~~~^",
        r"    did you mean `\alpha_1`?", *ONE],
        id="unknown symbol in the second fragment"),
    pytest.param(r"'(30^\circ, 1)'", r"'(30^\circ, k)'", [
        f"{FILE}:29:34: claims[sec:2/smallest].asserts.at[1]: unknown symbol `k`",
        r"    (30^\circ, k)",
        "               ^",
        "    declare it under `symbols`", *ONE],
        id="unknown symbol in a point"),
    pytest.param(FORMULA, "'" + "(" * 1_000_000 + "'", [
        f"{FILE}:24:12: claims[eq:1].latex[1]: expected at most 10000 characters, found 1000000",
        "    shorten or split it", *ONE],
        id="a million characters"),
    pytest.param(FORMULA, "'" + "L+" * 4_000 + "L', '" + "+L" * 1_000 + "'", [
        f"{FILE}:24:8015: expected YAML, found a fault: did not find expected key",
        "    check the indentation, and put LaTeX between single quotes", *ONE],
        id="two texts for one value"),
    pytest.param("target: eq:1", "target: eq:10", [
        f"{FILE}:40:13: claims[xref:sec-2-cites-eq-1].target: expected an equation, figure or "
        "section with claims, found `eq:10`",
        "    did you mean `eq:1`?", *ONE],
        id="target without claims"),
    pytest.param("agrees_with: eq:1", "agrees_with: [eq:1, sec:2/sane]", [
        f"{FILE}:35:25: claims[sec:2/same].agrees_with[2]: expected the id of a claim, found "
        "`sec:2/sane`",
        "    did you mean `sec:2/same`?", *ONE],
        id="partner that is no claim"),
    pytest.param("kind: consistency", "kind: value", [
        f"{FILE}:34:14: claims[sec:2/same].printed: `printed` should be a decimal such as 4.00, "
        "found 'D_V'", *ONE],
        id="a decimal that is none"),
    pytest.param("kind: consistency", "kind: editorial\n    uncheckable: opinion", [
        f"{FILE}:32:18: claims[sec:2/same].uncheckable: `uncheckable` and `decided_by` "
        "(what would decide it) go together", *ONE],
        id="two keys of which one is missing"),
    pytest.param("form: minimum, at: '(30^\\circ, 1)'", "form: equal, at: [L]", [
        f"{FILE}:29:32: claims[sec:2/smallest].asserts.at: `at` belongs to the forms minimum and "
        "maximum, and only there", *ONE],
        id="points without a minimum"),
    pytest.param("    latex: " + FORMULA + "\n", "", [
        f"{FILE}:20:5: claims[eq:1]: a claim of kind identity needs `latex`", *ONE],
        id="identity without a formula"),
    pytest.param("target: eq:1", "asserts: {form: equal}", [
        f"{FILE}:40:14: claims[xref:sec-2-cites-eq-1].asserts: `asserts` belongs to kind relation",
        *ONE],
        id="a reference that asserts"),
    pytest.param("units: {D_V: m^3}", "units: {D_W: m^3}", [
        f"{FILE}:18:18: tables[tab:2].units.D_W: expected a column of table-2.csv (D_A, D_V), "
        "found 'D_W'",
        "    did you mean `D_V`?", *ONE],
        id="unit of no column"),
    pytest.param("file: table-2.csv", "file: ../../etc/passwd", [
        f"{FILE}:15:11: tables[tab:2].file: expected the name of a CSV file in this folder, such "
        "as table-2.csv, found '../../etc/passwd'", *ONE],
        id="file outside the folder"),
    pytest.param("file: table-2.csv", "file: table-3.csv", [
        "paper_data/some-paper/table-3.csv:1:1: expected a file, found none",
        "    write it",
        "1 fault in paper_data/some-paper/table-3.csv"],
        id="no such file"),
    pytest.param(r"latex: 'L'", r"latex: 'L + 1'", [
        f"{FILE}:11:13: symbols[L].latex: expected one symbol, found `+`",
        "    L + 1",
        "      ^",
        f"{FILE}:24:12: claims[eq:1].latex: unknown symbol `L`",
        r"    D_V(\alpha_1) = L \sin\alpha_1",
        "                    ^",
        "    declare it under `symbols`", *TWO],
        id="a symbol that is a formula"),
    pytest.param("tables:", r"  - {latex: '\mathbf{L}', name: L, means: bold}" + "\ntables:", [
        f"{FILE}:13:13: symbols[L].latex: expected each symbol once, found `L` again",
        "    fonts do not tell symbols apart", *ONE],
        id="a symbol in two fonts"),
    pytest.param("tables:", "  - {latex: M, name: L, means: another}\ntables:", [
        f"{FILE}:13:22: symbols[L].name: expected each name once, found `L` again",
        "    the first one is on line 11", *ONE],
        id="two symbols of one name"),
    pytest.param("role: quantity,", r"role: quantity, of: ['\alpha_1', '\alpha_2'],", [
        f"{FILE}:12:64: symbols[D_V].of[2]: expected a variable among the symbols, "
        r"found `\alpha_2`",
        r"    did you mean `\alpha_1`?", *ONE],
        id="a function of nothing that is declared"),
    pytest.param("name: L,", "name: L, of: D_V,", [
        f"{FILE}:11:31: symbols[L].of: `of` belongs to role quantity", *ONE],
        id="a variable that is a function"),
    pytest.param("symbols:", "notation: {functions: {c: kos, se: sec}, slash: last}\nsymbols:", [
        f"{FILE}:9:49: notation.slash: expected first or all, found 'last'", *ONE],
        id="notation of the wrong shape"),
    pytest.param("symbols:", "notation: {angles: grad}\nsymbols:", [
        f"{FILE}:9:20: notation.angles: expected degrees, found 'grad'", *ONE],
        id="a unit of angles that is not read"),
    pytest.param("symbols:", "notation: {functions: {c: kos, se: sec}}\nsymbols:", [
        f"{FILE}:9:27: notation.functions.c: expected one of arccos, arcsin, arctan, cos, cot, "
        "csc, sec, sin, tan, found `kos`",
        "    did you mean `cos`?",
        f"{FILE}:9:36: notation.functions.se: expected one letter for a function, found `se`",
        *TWO],
        id="notation"),
]  # fmt: skip


@pytest.mark.parametrize(("old", "new", "lines"), BAD)
def test_bad_document(folder: Path, old: str, new: str, lines: list[str]) -> None:
    assert GOOD.count(old) == 1
    (folder / "paper.yaml").write_text(GOOD.replace(old, new), encoding="utf-8")
    assert faults_of(folder) == lines
    assert not Path("hacked").exists()


WHOLE = [
    pytest.param(b"", [f"{FILE}:1:1: expected a paper, found an empty file", "    write it", *ONE],
                 id="empty file"),
    pytest.param(b"- a\n- b", [f"{FILE}:1:1: expected keys with values, found a list", *ONE],
                 id="list"),
    pytest.param(b"a: b\n---\na: b", [
        f"{FILE}:2:1: expected one document, found a second one",
        "    put each paper into its folder", *ONE], id="two documents"),
    pytest.param("key: caf\u00e9".encode("latin-1"), [
        f"{FILE}:1:9: expected UTF-8, found the byte 0xe9 at offset 8",
        "    save the file as UTF-8", *ONE], id="not UTF-8"),
    pytest.param(b"a" * 2_000_001, [
        f"{FILE}:1:1: expected at most 2000000 bytes, found 2000001",
        "    split the paper", *ONE], id="huge"),
    pytest.param(b"? [a]\n: b", [
        f"{FILE}:1:3: expected a word as the key", "    write text before the colon", *ONE],
        id="list as a key"),
]  # fmt: skip


@pytest.mark.parametrize(("content", "lines"), WHOLE)
def test_bad_file(folder: Path, content: bytes, lines: list[str]) -> None:
    (folder / "paper.yaml").write_bytes(content)
    assert faults_of(folder) == lines


def test_claims_that_are_no_list(folder: Path) -> None:
    text = GOOD.partition("claims:")[0] + "claims: none\n"
    (folder / "paper.yaml").write_text(text, encoding="utf-8")
    assert faults_of(folder) == [f"{FILE}:19:9: claims: expected a list, found 'none'", *ONE]


def test_a_folder_elsewhere(
    folder: Path, tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path_factory.mktemp("elsewhere"))
    loaded = load_paper(folder)
    assert loaded.positions["eq:1"].file == (folder / "paper.yaml").as_posix()


def test_no_folder(folder: Path) -> None:
    assert faults_of(folder / "nowhere")[0].endswith(
        "nowhere/paper.yaml:1:1: expected a file, found none"
    )


CSV = "paper_data/some-paper/table-2.csv"
TABLES = [
    pytest.param("", [
        f"{CSV}:1:1: expected a header and at least one row, found 0 lines"], id="empty"),
    pytest.param("type,D_V,D_A\nX,3.08\n", [
        f"{CSV}:2:1: tab:2: expected 3 cells as in the header, found 2",
        "    give every row the same number of cells"], id="short row"),
    pytest.param("type,D_V,D_A\nX,,about 4\n", [
        f"{CSV}:2:3: tab:2[X,D_V]: expected a decimal, found nothing",
        "    write the digits that the paper prints, zeros included",
        f"{CSV}:2:4: tab:2[X,D_A]: expected a decimal such as 4.00, found 'about 4'",
        "    write the digits that the paper prints, zeros included"], id="cells"),
    pytest.param("type,D_V,D_V\nX,1,2\nX,1,2\nType Y,1,2\n", [
        f"{CSV}:1:10: tab:2: expected each column name once, found `D_V` again",
        "    the first one is on line 1",
        f"{CSV}:3:1: tab:2: expected each row name once, found `X` again",
        "    the first one is on line 2",
        f"{CSV}:4:1: tab:2: expected a row name of letters, digits and `_`, found 'Type Y'",
        "    use the name that the ids of the cells shall have"], id="names"),
    pytest.param('type,D_V,D_A\nX,"3.08,4\n', [
        f"{CSV}:2:1: expected CSV, found a fault: unexpected end of data"], id="open quote"),
]  # fmt: skip


@pytest.mark.parametrize(("content", "lines"), TABLES)
def test_bad_table(folder: Path, content: str, lines: list[str]) -> None:
    (folder / "table-2.csv").write_text(content, encoding="utf-8")
    count = sum(not line.startswith("    ") for line in lines)
    word = "fault" if count == 1 else "faults"
    assert faults_of(folder) == [*lines, f"{count} {word} in {CSV}"]


def test_faults_of_all_files_are_reported_together(folder: Path) -> None:
    text = GOOD.replace("kind: identity", "kind: truth").replace(
        "eq:1\n    kind: c", "x\n    kind: c"
    )
    (folder / "paper.yaml").write_text(text.replace("(30^", "(30§^"), encoding="utf-8")
    (folder / "table-2.csv").write_text("type,D_V\nX,?\n", encoding="utf-8")
    lines = faults_of(folder)
    assert [line.split(": ")[0] for line in lines if line.startswith("paper_data")] == [
        f"{FILE}:21:11", f"{FILE}:29:34", f"{CSV}:2:3"]  # fmt: skip
    assert lines[-1] == f"3 faults in {FILE}, {CSV}"


def test_many_faults_are_counted(folder: Path) -> None:
    more = "".join(f"  - {{id: 'eq:{n}', kind: x, line: 1, says: y}}\n" for n in range(100, 180))
    (folder / "paper.yaml").write_text(GOOD + more, encoding="utf-8")
    lines = faults_of(folder)
    assert lines[-2:] == ["and 30 more", f"80 faults in {FILE}"]
    assert sum(line.startswith(FILE) for line in lines) == 50


def test_loading_needs_no_algebra_system() -> None:
    code = "import omniproof.transcription.loader, sys; sys.exit('sympy' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


PATHS = [
    pytest.param(("claims", 0, "kind"), "claims[eq:1].kind", id="named entry"),
    pytest.param(("claims", 1, "latex", 2), "claims[2].latex[3]", id="entry without a name"),
    pytest.param((), "", id="whole file"),
]


@pytest.mark.parametrize(("path", "text"), PATHS)
def test_paths_name_their_entries(path: tuple[str | int, ...], text: str) -> None:
    assert label(path, {"claims": [{"id": "eq:1", "kind": "x"}, {"latex": ["a"]}]}) == text


def test_where_a_table_decodes_the_source_each_piece_of_it_is_named(folder: Path) -> None:
    text = GOOD.replace("symbols:", "notation: {glyphs: {'\\alpha': [a]}}\nsymbols:", 1)
    decoded = text.replace("    says: a product\n", "    says: a product\n    reading: glyphs\n")
    (folder / "paper.yaml").write_text(decoded, encoding="utf-8")
    with pytest.raises(BadInput) as bad:
        load_paper(folder)
    assert str(bad.value).splitlines() == [
        f"{FILE}:25:14: claims[eq:1].reading: expected `glyphs`, the piece of the source that is "
        "decoded",
        "    copy it from the line of the claim",
        *ONE,
    ]


REFERENCE = "    target: eq:1\n"
HOSTILE = [
    pytest.param("'{'", "expected a symbol, found `{`", id="an open brace"),
    pytest.param("'}'", "expected a symbol, found `}`", id="a stray brace"),
    pytest.param("'L)'", "expected one symbol, found `)`", id="a stray bracket"),
    pytest.param("'L L'", "expected one symbol, found `L`", id="two symbols"),
    pytest.param("''", "expected text, found nothing", id="nothing"),
    pytest.param("[L]", "expected text, found a list", id="a list"),
    pytest.param(f"'{'{' * 500}'", "expected at most 32 brackets inside one another", id="deep"),
    pytest.param(
        f"'{'L' * 9_000}'", "expected at most 2000 characters, found 9000", id="long"),
    pytest.param(
        r'"L\x1b[31m"', "expected text that can be seen, found U+001B a control character",
        id="an escape sequence"),
    pytest.param(
        r'"\u202eL"', "expected text that can be seen, found U+202E RIGHT-TO-LEFT OVERRIDE",
        id="a mark of direction"),
    pytest.param(
        r'"L\U000e0041"',
        "expected text that can be seen, found U+E0041 TAG LATIN CAPITAL LETTER A", id="a tag"),
]  # fmt: skip


@pytest.mark.parametrize(("value", "message"), HOSTILE)
def test_what_a_reference_is_about(folder: Path, value: str, message: str) -> None:
    text = GOOD.replace(REFERENCE, f"{REFERENCE}    about: {value}\n")
    (folder / "paper.yaml").write_text(text, encoding="utf-8")
    where, _, said = faults_of(folder)[0].partition(".about: ")
    assert (where.startswith(f"{FILE}:41:12: claims["), said) == (True, message)


@pytest.mark.parametrize("field", ["title: On", "means: a radius", "says: a product", "year: 2023"])
@pytest.mark.parametrize("character", ["\\x9b", "\\u2066", "\\u2028", "\\x07"])
def test_nothing_hidden_in_any_field(folder: Path, field: str, character: str) -> None:
    key = field.split(":", maxsplit=1)[0]
    text = GOOD.replace(field, f'{key}: "{character}"', 1).replace('" wheels', '"')
    (folder / "paper.yaml").write_text(text, encoding="utf-8")
    assert f"{key}: expected text that can be seen, found U+" in faults_of(folder)[0]


@pytest.mark.parametrize(
    ("values", "message"),
    [
        pytest.param("".join(f"k{i}: v\n" for i in range(50_000)), "expected at most 40000 values",
                     id="too many"),
        pytest.param("".join(f"k{i}: v\n" for i in range(30_000)), "expected one of claims",
                     id="many, each wrong"),
    ],
)  # fmt: skip
def test_many_values_are_told_in_time(folder: Path, values: str, message: str) -> None:
    (folder / "paper.yaml").write_text(values + GOOD, encoding="utf-8")
    assert message in faults_of(folder)[0]
