"""The command line: ledgers to stdout, talk to stderr, and every kind of bad input told at once."""

from __future__ import annotations

import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

from omniproof import cli
from omniproof.audit.ledger import Ledger

PAPER = "paper/paper.yaml"
TABLE = "paper/table-2.csv"
ONE = f"1 fault in {PAPER}\n"


def audit(*arguments: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "omniproof.cli", "audit", *arguments],
        cwd=cwd,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )


# The real paper


@pytest.fixture(scope="module")
def as_json(root: Path) -> subprocess.CompletedProcess[str]:
    return audit("paper_data/omni-arrangement", "--json", cwd=root)


def test_json_is_the_ledger_and_nothing_else(as_json: subprocess.CompletedProcess[str]) -> None:
    assert (as_json.returncode, as_json.stderr) == (0, "")
    ledger = Ledger.model_validate_json(as_json.stdout)
    assert ledger.paper == "omni-arrangement"
    assert as_json.stdout == ledger.model_dump_json(indent=1) + "\n"


def test_text_shows_what_a_reader_has_to_know(
    as_json: subprocess.CompletedProcess[str],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    ledger = Ledger.model_validate_json(as_json.stdout)
    monkeypatch.setattr("omniproof.audit.run.audit_paper", lambda folder: ledger)
    assert cli.main(["audit", "anywhere"]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    heads = [line for line in out.splitlines() if line and not line.startswith(" ")]
    faults = [row for row in ledger.rows if row.verdict.is_fault]
    assert heads[:-1] == [f"{r.verdict.upper()}  {r.id}  ({r.where})" for r in faults]
    assert heads[-1].startswith(
        f"omni-arrangement: {ledger.claims} claims, {len(ledger.rows)} rows: "
    )


def test_an_internal_error_is_told_in_one_line(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def fail(folder: Path) -> Ledger:
        raise AssertionError("engines disagree")

    monkeypatch.setattr("omniproof.audit.run.audit_paper", fail)
    assert cli.main(["audit", "anywhere"]) == 4
    assert capsys.readouterr() == (
        "",
        "internal error, please report it: AssertionError: engines disagree\n",
    )


@pytest.mark.parametrize("arguments", [[], ["audit"], ["audti", "x"], ["audit", "x", "--jsn"]])
def test_a_wrong_command_is_bad_input(
    arguments: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as stop:
        cli.main(arguments)
    assert stop.value.code == 2
    out, err = capsys.readouterr()
    assert (out, err.startswith("usage: omniproof")) == ("", True)


# Bad input


@dataclass(frozen=True)
class Edit:
    """Put `new` for the one `old` in a file; the fault is reported where `at` then stands."""

    old: str
    new: str
    at: str
    file: str = PAPER

    def make(self, folder: Path) -> None:
        file = folder / self.file
        text = file.read_text(encoding="utf-8")
        assert text.count(self.old) == 1, f"{self.old!r} stands {text.count(self.old)} times"
        file.write_text(text.replace(self.old, self.new), encoding="utf-8")

    def place(self, folder: Path) -> str:
        before, found, _ = (folder / self.file).read_text(encoding="utf-8").partition(self.at)
        assert found
        line, column = before.count("\n") + 1, len(before) - before.rfind("\n")
        return f"{self.file}:{line}:{column}"


EQ_2 = "  - id: eq:2\n    kind: identity\n"
VOLUME = r"latex: '8 / \det \mathbf{A}'"
TWIST = (
    "    says: 'the vector on which the matrix of Eq. (5) acts'\n"
    r"    latex: '\begin{pmatrix} V_x \\ V_y \\ L\dot{\phi} \end{pmatrix}'"
)
SHORT_TWIST = TWIST.replace(r" \\ L\dot{\phi}", "")
NEW = "  - id: eq:99\n    kind: identity\n    line: 103\n    says: new\n    latex: 'L'\n"
KEYS = (
    "about, agrees_with, argument, asserts, assumes, decided_by, glyphs, id, kind, latex, line, "
    "lost, printed, quote, reading, says, source, target, uncheckable, unit"
)
DERIVATIONS = "papers/omni_arrangement/derivations.py"
CODE = "__import__(''os'').system(''touch marker'')"
BAD = [
    pytest.param(
        Edit("\nclaims:\n", "\nclaims: [\n", "- id: sec:"),
        "{at}: expected YAML, found a fault: did not find expected node content\n"
        "    check the indentation, and put LaTeX between single quotes\n" + ONE,
        id="broken YAML",
    ),
    pytest.param(
        Edit(EQ_2, f"{EQ_2}    lime: 103\n", "lime"),
        f"{{at}}: claims[eq:2]: expected one of {KEYS}, found 'lime'\n"
        "    did you mean `line`?\n" + ONE,
        id="unknown key",
    ),
    pytest.param(
        Edit(EQ_2, EQ_2.replace("identity", "identiy"), "identiy"),
        "{at}: claims[eq:2].kind: expected one of identity, value, relation, consistency, "
        "reference, editorial, found 'identiy'\n"
        "    did you mean `identity`?\n" + ONE,
        id="unknown kind",
    ),
    pytest.param(
        Edit("  - id: eq:7\n", "  - id: eq:6\n", "eq:6\n    kind: identity\n    line: 127"),
        f"{PAPER}:1:1: expected a claim for the derivation `eq:7`, found none\n"
        "    did you mean `eq:9`?\n"
        "{at}: claims[eq:6].id: expected each id once, found `eq:6` again\n"
        "    the first one is at {first}\n" f"2 faults in {PAPER}\n",
        id="duplicate id",
    ),
    pytest.param(
        Edit(VOLUME, r"latex: '8 / (\det \mathbf{A}'", r"'8 / (\det"),
        "{at}: claims[eq:11].latex: expected `)` to close `(`, found the end of the formula\n"
        "    8 / (\\det \\mathbf{{A}}\n"
        "        ~~~~~~~~~~~~~~~~^\n"
        "    balance the brackets\n" + ONE,
        id="unreadable LaTeX",
    ),
    pytest.param(
        Edit(VOLUME, "latex: '8 / 2 L'", "'8 / 2 L'"),
        "{at}: claims[eq:11].latex: it is not clear what the slash divides by\n"
        "    8 / 2 L\n"
        "    ~~~~~~^\n"
        "    write `\\frac{{…}}{{…}}`, or settle it with `slash: first` or `slash: all` in the "
        "notation\n" + ONE,
        id="ambiguous LaTeX",
    ),
    pytest.param(
        Edit(VOLUME, r"latex: '8 / \alpha_4'", r"'8 / \alpha_4'"),
        "{at}: claims[eq:11].latex: unknown symbol `\\alpha_4`\n"
        "    8 / \\alpha_4\n"
        "        ~~~~~~~^\n"
        "    did you mean `\\alpha_k`?\n" + ONE,
        id="unknown symbol",
    ),
    pytest.param(
        Edit(EQ_2, NEW + EQ_2, "eq:99"),
        "{at}: claims[eq:99]: expected a derivation for this identity, found none\n"
        f'    add a function with `@REGISTRY.derives("eq:99")` to {DERIVATIONS}, or say why it is '
        "`uncheckable`\n" + ONE,
        id="claim without derivation",
    ),
    pytest.param(
        Edit("- id: eq:7\n    kind: identity", "- id: sec:2.2/new\n    kind: editorial", "key"),
        f"{PAPER}:1:1: expected a claim for the derivation `eq:7`, found none\n"
        "    did you mean `eq:9`?\n"
        "{new}: claims[sec:2.2/new]: expected a reading of this editorial, found none\n"
        "    add `sec:2.2/new` with its reason to papers/omni_arrangement/readings.yaml\n"
        f"2 faults in {PAPER}\n",
        id="derivation without claim",
    ),
    pytest.param(
        Edit(TWIST, SHORT_TWIST, "eq:5/twist"),
        "{at}: claims[eq:5/twist].latex: expected a matrix of 3 x 1, found a matrix of 2 x 1\n"
        "    write every row with as many entries as the paper prints\n" + ONE,
        id="wrong shape of a matrix",
    ),
    pytest.param(
        Edit("Y,4.00,6.00", "Y,4.O0,6.00", "4.O0", TABLE),
        "{at}: tab:2[Y,D_V]: expected a decimal such as 4.00, found '4.O0'\n"
        "    write the digits that the paper prints, zeros included\n"
        f"1 fault in {TABLE}\n",
        id="a decimal that is none",
    ),
    pytest.param(
        Edit(VOLUME, f"latex: '{' + '.join(['L'] * 250_001)}'", "'L + L + L"),
        "{at}: claims[eq:11].latex[1]: expected at most 10000 characters, found 1000001\n"
        "    shorten or split it\n" + ONE,
        id="a formula of a million characters",
    ),
    pytest.param(
        Edit(VOLUME, f"latex: '{CODE}'", f"'{CODE}'"),
        "{at}: claims[eq:11].latex: expected a number, a symbol or a bracket, found `_`\n"
        "    __import__('os').system('touch marker')\n"
        "    ^\n"
        "    write LaTeX as the paper prints it, in symbols that are declared\n" + ONE,
        id="code in a formula",
    ),
    pytest.param(
        Edit(VOLUME, "latex: !!python/object/apply:os.system ['touch marker']", "!!python"),
        "{at}: claims[{index}].latex: expected plain text, found the tag "
        "`tag:yaml.org,2002:python/object/apply:os.system`\n"
        "    leave the tag out\n" + ONE,
        id="code in a tag",
    ),
    pytest.param(
        Edit("Y,4.00,6.00", f"Y,{CODE},6.00", "__import__", TABLE),
        "{at}: tab:2[Y,D_V]: expected a decimal such as 4.00, found "
        "\"__import__(''os'').system(''touch marker'')\"\n"
        "    write the digits that the paper prints, zeros included\n"
        f"1 fault in {TABLE}\n",
        id="code in a cell",
    ),
]  # fmt: skip


@pytest.fixture
def folder(root: Path, tmp_path: Path) -> Path:
    shutil.copytree(root / "paper_data" / "omni-arrangement", tmp_path / "paper")
    return tmp_path


def line_of(folder: Path, text: str) -> int:
    return (folder / PAPER).read_text(encoding="utf-8").partition(text)[0].count("\n") + 1


@pytest.mark.parametrize(("edit", "message"), BAD)
def test_bad_input(
    folder: Path,
    edit: Edit,
    message: str,
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> None:
    """In this process, for speed; the tests below go through a process of their own."""
    edit.make(folder)
    text = (folder / PAPER).read_text(encoding="utf-8")
    expected = message.format(
        at=edit.place(folder),
        first=f"{PAPER}:{line_of(folder, '- id: eq:6' + chr(10))}",
        new=f"{PAPER}:{line_of(folder, 'sec:2.2/new')}:9",
        index=text.partition(edit.at)[0].partition("\nclaims:")[2].count("\n  - id: "),
    )
    monkeypatch.chdir(folder)
    assert (cli.main(["audit", "paper"]), *capfd.readouterr()) == (2, "", expected)
    assert not (folder / "marker").exists()


def test_a_file_that_is_not_utf_8(folder: Path) -> None:
    before, _, after = (folder / PAPER).read_bytes().partition(b"determinant of A")
    (folder / PAPER).write_bytes(before + b"determinant of \xc4" + after)
    line, offset = before.count(b"\n") + 1, len(before) + len(b"determinant of ")
    column = offset - before.rfind(b"\n")
    run = audit("paper", cwd=folder)
    assert (run.returncode, run.stdout) == (2, "")
    assert run.stderr == (
        f"{PAPER}:{line}:{column}: expected UTF-8, found the byte 0xc4 at offset {offset}\n"
        "    save the file as UTF-8\n" + ONE
    )


def test_no_folder(tmp_path: Path) -> None:
    run = audit("nowhere", cwd=tmp_path)
    assert (run.returncode, run.stdout) == (2, "")
    assert run.stderr == (
        "nowhere/paper.yaml:1:1: expected a file, found none\n"
        "    write it\n"
        "1 fault in nowhere/paper.yaml\n"
    )


def test_faults_of_all_stages_are_told_in_one_run(folder: Path) -> None:
    edits = {
        "no derivation": Edit(EQ_2, NEW + EQ_2, "eq:99"),
        "shape": Edit(TWIST, SHORT_TWIST, "eq:5/twist"),
        "kind": Edit("eq:6/factor\n    kind: identity", "eq:6/factor\n    kind: idea", "idea"),
        "twice": Edit("- id: eq:7\n", "- id: eq:6\n", "eq:6\n    kind: identity\n    line: 127"),
        "LaTeX": Edit(VOLUME, r"latex: '8 / (\det \mathbf{A}'", r"'8 / (\det"),
        "decimal": Edit("Y,4.00,6.00", "Y,4.O0,6.00", "4.O0", TABLE),
    }
    for edit in edits.values():
        edit.make(folder)
    run = audit("paper", cwd=folder)
    at = {name: edit.place(folder) for name, edit in edits.items()}
    assert (run.returncode, run.stdout) == (2, "")
    told = [line for line in run.stderr.splitlines() if line.startswith("paper/")]
    assert told == [
        f"{PAPER}:1:1: expected a claim for the derivation `eq:7`, found none",
        f"{at['no derivation']}: claims[eq:99]: expected a derivation for this identity, "
        "found none",
        f"{at['shape']}: claims[eq:5/twist].latex: expected a matrix of 3 x 1, "
        "found a matrix of 2 x 1",
        f"{at['kind']}: claims[eq:6/factor].kind: expected one of identity, value, relation, "
        "consistency, reference, editorial, found 'idea'",
        f"{at['twice']}: claims[eq:6].id: expected each id once, found `eq:6` again",
        f"{at['LaTeX']}: claims[eq:11].latex: expected `)` to close `(`, found the end of the "
        "formula",
        f"{at['decimal']}: tab:2[Y,D_V]: expected a decimal such as 4.00, found '4.O0'",
    ]
    assert run.stderr.endswith(f"\n7 faults in {PAPER}, {TABLE}\n")


def test_a_paper_that_nobody_derived_yet(folder: Path) -> None:
    Edit("key: omni-arrangement\n", "key: another-paper\n", "another-paper").make(folder)
    run = audit("paper", cwd=folder)
    assert (run.returncode, run.stdout) == (2, "")
    missing = "expected a derivation for this relation, found none\n"
    assert f"claims[sec:abstract/omnidirectional]: {missing}" in run.stderr
