"""A slip of ours in a symbol stops the audit: it never becomes an erratum of theirs."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import tiny_paper
from sympy import Dummy, Symbol, pi, sin

from omniproof.audit import run
from omniproof.registry import Registry, Symbols
from omniproof.transcription.faults import BadInput

FILE = "tiny-paper/paper.yaml"
X = "- {latex: 'x', name: x,"
Y = "- {latex: 'y', name: y,"
LEVER = "- {latex: 'L', name: L, positive: true,"
F = "- {latex: 'f', name: f, role: quantity, of: 'x',"
XY = f"{X} means: a number}}\n  {Y}"
YX = "- {latex: 'x', name: y, means: a number}\n  - {latex: 'y', name: x,"
UNUSED = "symbols:\n  - {latex: 'h', name: h, means: a height}\n"
SHAPE = "uncheckable: figure-not-seen"
SAME = "    take what is declared, or another name"
HERE = "tiny_paper.py:LINE"
THERE = "test_agreement.py:LINE"


def faults(folder: Path, text: str, registry: Registry) -> list[str]:
    """Load the tiny paper with another text, or other derivations; return what is told."""
    with pytest.MonkeyPatch.context() as patch:
        home = tiny_paper.write(folder / "tiny-paper")
        (home / "paper.yaml").write_text(text, encoding="utf-8")
        patch.chdir(folder)
        patch.setattr(run, "load_registry", lambda paper: registry)
        patch.setattr(run, "load_readings", lambda paper: tiny_paper.READINGS)
        with pytest.raises(BadInput) as bad:
            run.prepare(Path("tiny-paper"))
    return str(bad.value).splitlines()[:-1]


SLIPS = [
    pytest.param(LEVER, "- {latex: 'L', name: L,", [
        f"{FILE}:12:24: symbols[L].name: expected a real number, found a positive number in {HERE}",
        SAME], id="positive dropped"),
    pytest.param(X, f"{X} positive: true,", [
        f"{FILE}:10:24: symbols[x].name: expected a positive number, found a real number in {HERE}",
        SAME], id="positive added"),
    pytest.param(X, X.replace("name: x", "name: xx"), [
        f"{FILE}:10:24: symbols[xx].name: expected a symbol of the derivations, found `xx`",
        "    did you mean `x`?"], id="name misspelt"),
    pytest.param(LEVER, LEVER.replace("name: L", "name: lever"), [
        f"{FILE}:12:24: symbols[lever].name: expected a symbol of the derivations, found `lever`",
        "    the derivations know `L`, `t`"], id="another name"),
    pytest.param(Y, Y.replace("name: y", "name: t"), [
        f"{FILE}:23:9: claims[eq:6]: expected a derivation in what the paper prints, found `y` "
        f"(a real number) in {HERE}"], id="the name of what one derivation uses for itself"),
    pytest.param(XY, YX, [
        f"{FILE}:10:24: symbols[y].name: expected `x`, as `x` is printed, found `y`",
        "    line 11 has that name",
        f"{FILE}:11:24: symbols[x].name: expected `y`, as `y` is printed, found `x`",
        "    line 10 has that name",
        f"{FILE}:13:47: symbols[f].of: expected variables of its value, found `x`",
        "    did you mean `y`?"], id="two names swapped"),
    pytest.param(X, f"{X} role: undefined,", [
        f"{FILE}:10:24: symbols[x].name: expected no symbol of a derivation, found a real number "
        f"in {HERE}", SAME],
        id="undefined, and derived"),
    pytest.param(X, f"{X} role: quantity,", [
        f"{FILE}:10:24: symbols[x].name: expected a meaning of the quantity `x`, found none",
        '    add a function with `@REGISTRY.quantity("x")` to papers/tiny_paper/derivations.py',
        f"{FILE}:13:47: symbols[f].of[1]: expected a variable among the symbols, found `x`"],
        id="a variable as quantity"),
    pytest.param(F, F.replace("name: f", "name: ff"), [
        f"{FILE}:13:24: symbols[ff].name: expected a meaning of the quantity `ff`, found none",
        "    did you mean `f`?"], id="quantity misspelt"),
    pytest.param(F, F.replace("of: 'x'", "of: 'y'"), [
        f"{FILE}:13:47: symbols[f].of: expected variables of its value, found `y`",
        "    did you mean `x`?"], id="a function of something else"),
    pytest.param(F, F.replace("of: 'x'", "of: 'x', positive: true"), [
        f"{FILE}:13:62: symbols[f].positive: `positive` belongs to role variable"],
        id="a positive function"),
    pytest.param("asserts: {form: increasing}", "asserts: {form: equivalent}", [
        f"{FILE}:40:5: claims[sec:1/grows]: a relation of form equivalent needs `latex`"],
        id="the form of a condition, and none printed"),
    pytest.param("target: 'eq:1', about: x}", "target: 'eq:1', about: xx}", [
        f"{FILE}:117:10: claims[xref:sec-2-cites-eq-1]: expected `about` to be a declared symbol, "
        "found 'xx'", "    did you mean `x`?"], id="a reference to no symbol"),
]  # fmt: skip


@pytest.mark.parametrize(("old", "new", "said"), SLIPS)
def test_a_slip_in_the_paper_file(tmp_path: Path, old: str, new: str, said: list[str]) -> None:
    assert old in tiny_paper.PAPER
    text = tiny_paper.PAPER.lstrip().replace(old, new)
    assert without_lines(faults(tmp_path, text, tiny_paper.registry()))[: len(said)] == said


def without_lines(told: list[str]) -> list[str]:
    """Leave out the folder and the line of test code."""
    home = re.escape(str(Path(__file__).parent))
    return [re.sub(rf"{home}/(\w+\.py):\d+", r"\1:LINE", line) for line in told]


def derived(claim: str, value: Any) -> Callable[[Registry], None]:
    def change(registry: Registry) -> None:
        del registry.derivations[claim]
        registry.derives(claim)(lambda: value)

    return change


def stated(**fields: Any) -> Callable[[Registry], None]:
    def change(registry: Registry) -> None:
        for name, value in fields.items():
            setattr(registry, name, value)

    return change


WRITTEN = [
    pytest.param(derived("eq:11", Symbol("yy", real=True)), [
        f"{FILE}:32:10: claims[eq:11]: expected a derivation in what the paper prints, found `yy` "
        f"(a real number) in {THERE}", "    did you mean `y`?"], id="misspelt"),
    pytest.param(derived("eq:1", sin(2 * Symbol("x", positive=True))), [
        f"{FILE}:10:24: symbols[x].name: expected a real number, found a positive number in "
        f"{THERE}", SAME], id="another sign"),
    pytest.param(derived("sec:1/same", (Symbol("x"), Symbol("x"))), [
        f"{FILE}:10:24: symbols[x].name: expected a real number, found a complex number in "
        f"{THERE}", SAME], id="any complex number"),
    pytest.param(derived("eq:1", sin(2 * Dummy("x", real=True))), [
        f"{FILE}:22:10: claims[eq:1]: expected a derivation in what the paper prints, found `_x` "
        f"(a real number) in {THERE}", "    did you mean `x`?"], id="a symbol of its own"),
    pytest.param(stated(arguments={"f": (tiny_paper.y,)}), [
        f"{FILE}:13:47: symbols[f].of: expected variables of its value, found `x`",
        "    did you mean `y`?"], id="a function of something else"),
    pytest.param(stated(arguments={"f": ()}), [
        f"{FILE}:13:47: symbols[f].of: expected variables of its value, found `x`",
        "    the derivations know none"], id="no function"),
]  # fmt: skip


@pytest.mark.parametrize(("change", "said"), WRITTEN)
def test_a_slip_in_the_derivations(
    tmp_path: Path, change: Callable[[Registry], None], said: list[str]
) -> None:
    registry = tiny_paper.registry()
    change(registry)
    assert without_lines(faults(tmp_path, tiny_paper.PAPER.lstrip(), registry)) == said


KNOWN = Symbols((tiny_paper.x, tiny_paper.y, tiny_paper.L), {tiny_paper.x: (0, pi)})
FACTS = r" (role: quantity|positive: true|of: 'x'),"
BARE = re.sub(FACTS, "", tiny_paper.PAPER.lstrip())
"""The tiny paper, which says of its symbols only how they are printed."""
BY_CODE = "expected `{}` in papers/tiny_paper/symbols.py only, found it here as well"


def by_code(symbols: Symbols = KNOWN) -> Registry:
    registry = tiny_paper.registry()
    registry.symbols, registry.arguments["f"] = symbols, (tiny_paper.x,)
    return registry


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        pytest.param(X, f"{X} positive: true,", [
            f"{FILE}:10:37: symbols[x].positive: {BY_CODE.format('positive')}",
            "    leave it out: code says it"], id="a sign"),
        pytest.param(X, f"{X} range: '(0, 1)', role: variable,", [
            f"{FILE}:10:34: symbols[x].range: {BY_CODE.format('range')}",
            "    leave it out: code says it",
            f"{FILE}:10:50: symbols[x].role: {BY_CODE.format('role')}",
            "    leave it out: code says it"], id="a range and a role"),
        pytest.param("name: f,", "name: f, of: 'x',", [
            f"{FILE}:13:31: symbols[f].of: {BY_CODE.format('of')}",
            "    leave it out: code says it"], id="what a function is of"),
        pytest.param("name: y,", "name: yy,", [
            f"{FILE}:11:24: symbols[yy].name: expected a symbol that papers/tiny_paper/symbols.py "
            "has, found `yy`", "    did you mean `y`?"], id="a name misspelt"),
        pytest.param("  - {latex: 'L', name: L, means: a length}\n", "", [
            f"{FILE}:10:3: symbols: expected an entry for the symbol `L` of "
            "papers/tiny_paper/symbols.py, found none",
            "    add how the paper prints it, or remove it there"], id="an entry is missing"),
    ],
)  # fmt: skip
def test_what_code_says_the_file_does_not(
    tmp_path: Path, old: str, new: str, said: list[str]
) -> None:
    assert old in BARE
    assert faults(tmp_path, BARE.replace(old, new), by_code())[: len(said)] == said


def test_code_says_what_symbols_are(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    home = tiny_paper.write(tmp_path / "tiny-paper")
    (home / "paper.yaml").write_text(BARE, encoding="utf-8")
    monkeypatch.setattr(run, "load_registry", lambda paper: by_code())
    monkeypatch.setattr(run, "load_readings", lambda paper: tiny_paper.READINGS)
    context = run.prepare(home)
    symbols = context.loaded.symbols
    assert (symbols["f"].role, symbols["f"].of, symbols["x"].role) == (
        "quantity",
        ("x",),
        "variable",
    )
    assert context.meaning("L") == tiny_paper.L
    assert context.domain("eq:1").intervals == {"x": (0, pi)}


def test_symbols_may_stand_where_nothing_is_derived(
    tiny_folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = (tiny_folder / "paper.yaml").read_text(encoding="utf-8")
    text = text.replace("symbols:\n", UNUSED).replace(SHAPE, f"{SHAPE}\n    latex: 'h > 0'")
    monkeypatch.setattr("omniproof.transcription.paperfile.read_text", lambda path: text)
    assert "h" in run.prepare(tiny_folder).loaded.symbols


def test_nobody_derived_anything_yet(tmp_path: Path) -> None:
    told = faults(tmp_path, tiny_paper.PAPER.lstrip(), Registry("tiny-paper"))
    assert not [line for line in told if "symbols[" in line and "of the quantity" not in line]
