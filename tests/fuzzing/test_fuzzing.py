"""Long fuzzing: the reader, the zero test and the repair against 60 digits, in `make test-slow`.

Every case has to end within `PATIENCE` (no hang), raise nothing but a `LatexError` (no crash), and
say nothing that the digits contradict (no wrong verdict). Cases that come to nothing, such as a
division by 0, are counted apart: each test says how many real ones there were at least.
"""

from __future__ import annotations

import signal
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from random import Random
from types import FrameType
from typing import Any

import pytest
from formulas import POSITIVE, SYMBOLS, Formula, agree, formulas, points, rewritten
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from mpmath import mp
from sympy import Symbol

from omniproof.audit.mutants import Spelled, mutants
from omniproof.decide import digits
from omniproof.decide.answer import Answer, OnBranch, Proved, Refuted, Undecided
from omniproof.decide.in_sympy.equality import confirmed_equal
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.evaluation import evaluate
from omniproof.formula.writers import latex
from omniproof.repair.in_sympy import at_points
from omniproof.repair.kinds import Repair
from omniproof.repair.mend import mend
from omniproof.repair.misprint import Misprint
from omniproof.repair.values import Values
from omniproof.transcription import tree
from omniproof.transcription.reader import read
from omniproof.transcription.symbols import symbol_name
from omniproof.transcription.tokens import LatexError

pytestmark = pytest.mark.slow
PATIENCE = 60
"""Seconds after which a case counts as hanging; the slowest takes a few."""
MEANINGS = {
    symbol_name(s): Symbol(
        symbol_name(s).strip("\\"), **{"positive" if s == POSITIVE else "real": True}
    )
    for s in SYMBOLS
}
SPELLED = [Spelled(s, symbol_name(s), True) for s in SYMBOLS]
PLACES = points()


def long(cases: int) -> settings:
    return settings(max_examples=cases, deadline=None, suppress_health_check=list(HealthCheck))


@contextmanager
def no_hang() -> Iterator[None]:
    """Raise where a case takes longer than anything sensible takes."""

    def give_up(number: int, frame: FrameType | None) -> None:
        raise TimeoutError(f"no end after {PATIENCE} s")

    before = signal.signal(signal.SIGALRM, give_up)
    signal.alarm(PATIENCE)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)


def value_of(text: str) -> Any:
    return evaluate(read(text), MEANINGS, text)


def read_value(node: tree.Node, point: dict[str, str]) -> Any:
    """Give the digits of what was read, `None` where there are none."""
    by_name = {symbol_name(name): text for name, text in point.items()}
    try:
        with mp.workdps(digits.DIGITS):
            return digits.value(node, lambda symbol, _: mp.mpf(by_name[symbol.name]))
    except digits.UndefinedError:
        return None


# Reader ------------------------------------------------------------------------------------------
WORDS = (
    *SYMBOLS, r"\sin", r"\cos", r"\tan^{-1}", r"\frac", r"\sqrt", r"\dot", r"\mathbf", r"\det",
    r"\left", r"\right", r"\begin{pmatrix}", r"\end{pmatrix}", r"\begin{cases}", r"\end{cases}",
    r"\\", "&", "{", "}", "(", ")", "[", "]", "|", r"\|", r"\langle", r"\rangle", r"\{", r"\}", "+",
    "-", "=", "<", r"\leq", r"\neq", r"\cdot", r"\times", "^", "_", "/", ",", ".", "'", "^T",
    "^{-1}", r"^\circ", r"\pi", r"\quad", r"\text{ or }", r"\Leftrightarrow", "0", "1", "2", "3.5",
    "12", "x", "y", "e", "d", "\N{MINUS SIGN}", "\N{DEGREE SIGN}", "$", "%", "~", "\u00e9", "\x00",
)  # fmt: skip


def test_any_text_is_read_or_refused() -> None:
    counted: Counter[str] = Counter()

    @long(5_000)
    @given(st.lists(st.sampled_from(WORDS), max_size=24).map(" ".join) | st.text(max_size=60))
    def case(text: str) -> None:
        with no_hang():
            try:
                counted[type(read(text, None, SYMBOLS)).__name__] += 1
            except LatexError as refused:
                counted["refused" if refused.message else "refused without a word"] += 1

    case()
    assert counted.total() >= 5_000
    assert counted["refused without a word"] == 0
    assert len(counted) > 10, "many kinds of formulas are read"


def test_a_formula_has_the_value_that_was_written() -> None:
    """What is read, and what is printed and read again, has the value of the formula."""
    compared: Counter[bool] = Counter()

    @long(3_000)
    @given(formulas(leaves=12))
    def case(formula: Formula) -> None:
        with no_hang():
            node = read(formula.latex)
            again = read(latex(node))
            for point in PLACES:
                wanted = formula.at(point)
                for found in (read_value(node, point), read_value(again, point)):
                    assert (found is None) == (wanted is None)
                    assert found is None or agree(found, wanted)
            compared[any(formula.at(point) is not None for point in PLACES)] += 1

    case()
    assert compared[True] >= 2_500


# Zero test ---------------------------------------------------------------------------------------
def judge(left: Formula, right: Formula) -> Answer | None:
    """Decide as the audit does; `None` for what SymPy cannot build, such as a division by 0."""
    try:
        return confirmed_equal(value_of(left.latex), value_of(right.latex))
    except LatexError:
        return None


def holds(answer: OnBranch, point: dict[str, str]) -> bool:
    """Whether the condition of an answer is true at a point."""
    at = {MEANINGS[symbol_name(name)]: text for name, text in point.items()}
    sides = [(r.gts - r.lts).evalf(40, subs=at) for r in answer.relations]
    return all(side > 0 for side in sides)


def hold_against_digits(answer: Answer, left: Formula, right: Formula) -> None:
    """Compare an answer with the values at points, and at its own witness."""
    for point in PLACES:
        one, other = left.at(point), right.at(point)
        if one is None or other is None:
            continue
        if isinstance(answer, Proved) or (isinstance(answer, OnBranch) and holds(answer, point)):
            assert agree(one, other)
    if isinstance(answer, Refuted | OnBranch):
        there = at_witness(answer)
        one, other = left.at(there), right.at(there)
        if one is None or other is None:
            # SymPy makes x of the square of the root of x, which has a value everywhere.
            says_so = "undefined" in (answer.witness.printed, answer.witness.derived)
            assert says_so or left.has_root or right.has_root
        else:
            assert not agree(one, other)


def at_witness(answer: Refuted | OnBranch) -> dict[str, str]:
    """Return the point of a witness; symbols that do not matter to it are 1."""
    point = answer.witness.point
    return {name: point.get(MEANINGS[symbol_name(name)].name, "1") for name in SYMBOLS}


def test_a_formula_written_in_another_way_is_not_refuted() -> None:
    counted: Counter[str] = Counter()

    @long(2_500)
    @given(formulas(), st.randoms(use_true_random=False))
    def case(formula: Formula, chance: Random) -> None:
        other = rewritten(formula, chance)
        with no_hang():
            answer = judge(formula, other)
            counted[type(answer).__name__] += 1
            if answer is not None:
                assert isinstance(answer, Proved | Undecided)
                hold_against_digits(answer, formula, other)

    case()
    assert counted["Proved"] >= 1_500
    assert counted["Undecided"] <= 0.03 * counted["Proved"]


def test_any_two_formulas_are_judged_rightly() -> None:
    counted: Counter[str] = Counter()

    @long(2_500)
    @given(formulas(leaves=4), formulas(leaves=4))
    def case(left: Formula, right: Formula) -> None:
        with no_hang():
            answer = judge(left, right)
            counted[type(answer).__name__] += 1
            if answer is not None:
                hold_against_digits(answer, left, right)

    case()
    assert counted["Refuted"] >= 1_200
    assert counted["Undecided"] <= 0.03 * counted["Refuted"]


# Repair ------------------------------------------------------------------------------------------
def mended(printed: str, target: Any) -> tuple[Repair, ...]:
    """Repair as the audit does: by one edit, or else by two."""

    def proved(edited: str) -> tuple[str, ...]:
        try:
            answer = confirmed_equal(value_of(edited), target)
        except (LatexError, TypeError):
            return ()
        return answer.engines if isinstance(answer, Proved) else ()

    def meaning(symbol: tree.Symbolic) -> Values:
        return at_points(MEANINGS[symbol.name])

    try:
        values = at_points(target)
    except UnsupportedError:
        return ()
    found = mend(Misprint(printed, read, read, proved, meaning, values, words=tuple(SYMBOLS)))
    return found.repairs if found else ()


def planted(text: str, chance: Random, count: int) -> str:
    """Plant misprints; raises `LatexError` where one makes no formula."""
    for _ in range(count):
        text = chance.choice(mutants(text, read(text), SPELLED)).text
    value_of(text)
    return text


def test_a_repair_is_an_equal_of_the_original() -> None:
    """Plant one misprint, or two: what is offered is the original in some spelling."""
    counted: Counter[str] = Counter()

    @long(1_000)
    @given(formulas(leaves=5, roots=False), st.randoms(use_true_random=False), st.integers(1, 5))
    def case(formula: Formula, chance: Random, number: int) -> None:
        count = 2 if number > 3 else 1  # a search for pairs of edits takes a second or two
        with no_hang():
            try:
                target = value_of(formula.latex)
                found = mended(planted(formula.latex, chance, count), target)
            except LatexError:
                counted["no formula"] += 1
                return
            counted[f"{count}, {'repaired' if found else 'left'}"] += 1
            for edit in found:
                for point in PLACES:
                    wanted, own = formula.at(point), read_value(read(edit.text), point)
                    assert wanted is None or own is None or agree(wanted, own)

    case()
    assert counted["1, repaired"] >= 500
    assert counted["1, left"] <= 0.03 * counted["1, repaired"]
    assert counted["2, repaired"] >= 80
