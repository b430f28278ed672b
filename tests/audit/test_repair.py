"""Repair of misprints: the right edit is found, first, at the right place."""

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from omniproof.audit.answer import Proved
from omniproof.audit.repair import repair
from omniproof.audit.zero_test import decide_equal
from omniproof.transcription.expression import evaluate
from omniproof.transcription.model import Notation
from omniproof.transcription.reader import read
from omniproof.transcription.symbols import symbol_name
from omniproof.transcription.tokens import LatexError

VOCABULARY = (r"\alpha_1", r"\alpha_2", r"\alpha_3", r"\theta", "L", "R")
EXTRA = (r"\theta_1",)
MEANINGS = {
    symbol_name(word): sp.Symbol(word.strip("\\"), real=True) for word in (*VOCABULARY, *EXTRA)
}


def value(text: str) -> sp.Expr:
    return evaluate(read(text, Notation(), VOCABULARY + EXTRA), MEANINGS, text)


def mended(printed: str, right: str):
    target = value(right)

    def is_true(text: str) -> bool:
        try:
            return isinstance(decide_equal(value(text), target), Proved)
        except (LatexError, TypeError):
            return False

    return repair(printed, is_true, VOCABULARY)


TABLE = [
    pytest.param(
        r"\sin \alpha_1 + \sin \alpha_2",
        r"\sin \alpha_1 - \sin \alpha_2",
        "+ -> -",
        id="sign between terms",
    ),
    pytest.param(
        r"-L \sin \alpha_1 + L \sin \alpha_1",
        r"-L \sin \alpha_1 + L \sin \alpha_3",
        r"\alpha_1 -> \alpha_3",
        id="index, terms cancel as printed",
    ),
    pytest.param(
        r"L \cos \alpha_1 - L \cos \theta_1",
        r"L \cos \alpha_1 - L \cos \alpha_2",
        r"\theta_1 -> \alpha_2",
        id="another letter and index",
    ),
    pytest.param(
        r"\cos \alpha_1 - \cos \theta",
        r"\cos \alpha_1 - \cos \alpha_2",
        r"\theta -> \alpha_2",
        id="another letter",
    ),
    pytest.param(
        r"-\sin(\alpha_1 - \alpha_2)", r"\sin(\alpha_1 - \alpha_2)", "drop -", id="leading minus"
    ),
    pytest.param(
        r"\sin(\alpha_1 - \alpha_2)", r"-\sin(\alpha_1 - \alpha_2)", "insert -", id="missing minus"
    ),
    pytest.param(r"L\cos\theta", r"L\sin\theta", r"\cos -> \sin", id="function"),
    pytest.param(
        r"\frac{8}{2\cos\theta + \sin\theta}",
        r"\frac{8}{2\cos\theta + \sin 2\theta}",
        "insert 2",
        id="factor of an angle",
    ),
    pytest.param(
        r"\frac{4}{2\cos\theta + \sin 2\theta}",
        r"\frac{8}{2\cos\theta + \sin 2\theta}",
        "4 -> 8",
        id="constant",
    ),
    pytest.param(
        r"2\cos\theta + 2\sin 2\theta",
        r"2\cos\theta + \sin 2\theta",
        "drop 2",
        id="superfluous factor",
    ),
    pytest.param(r"\sin\theta", r"L\sin\theta", "insert L", id="missing length"),
    pytest.param(r"\sin L\theta", r"\sin\theta", "drop L", id="superfluous length"),
    pytest.param(
        r"\sin\theta\cos\theta",
        r"\frac{1}{2}\sin\theta\cos\theta",
        r"insert \frac{1}{2}",
        id="missing half",
    ),
]


@pytest.mark.parametrize(("printed", "right", "description"), TABLE)
def test_the_first_repair_is_the_misprint(printed, right, description):
    found = mended(printed, right)
    assert found[0].description == description
    assert sp.simplify(value(found[0].text) - value(right)) == 0


@pytest.mark.parametrize(("printed", "right", "description"), TABLE)
def test_the_edit_is_where_its_span_says(printed, right, description):
    edit = mended(printed, right)[0]
    start, end = edit.span
    assert edit.text.startswith(printed[:start])
    assert edit.text.endswith(printed[end:])


def test_repairs_come_in_order_of_likelihood():
    found = mended(r"\sin\theta + \sin\theta", "0")
    assert [edit.kind for edit in found] == sorted(edit.kind for edit in found)
    assert found[0].description == "+ -> -"
    assert len({edit.text for edit in found}) == len(found) > 1


def test_the_spelling_of_the_paper_is_kept():
    (edit,) = mended(r"\sin  \alpha_{1}  +  \sin\alpha_2", r"\sin\alpha_1 - \sin\alpha_2")
    assert edit.text == r"\sin  \alpha_{1}  -  \sin\alpha_2"


def test_a_command_is_kept_apart_from_a_letter():
    found = mended(r"\sin\theta", r"\sin L")
    assert found[0].text == r"\sin L"


def test_two_misprints_are_no_single_edit():
    assert mended(r"\sin\alpha_1 + \cos\alpha_2", r"\cos\alpha_1 - \cos\alpha_2") == ()


@pytest.mark.parametrize("text", [r"\badcommand x", "$", "", "x" * 20_000, "é"])
def test_unreadable_text_has_no_repair(text):
    assert repair(text, lambda _: False, VOCABULARY) == ()


SIGNS = st.lists(st.sampled_from("+-"), min_size=2, max_size=4)
TERMS = st.lists(
    st.sampled_from([r"\sin\alpha_1", r"L\cos\alpha_2", r"3\sin\alpha_3", r"R\theta"]),
    min_size=4,
    max_size=4,
    unique=True,
)


@settings(max_examples=15, deadline=None)
@given(SIGNS, TERMS, st.integers(0, 100))
def test_a_planted_sign_is_found(signs, terms, place):
    right = terms[0] + "".join(f" {s} {t}" for s, t in zip(signs, terms[1:], strict=False))
    flips = [k for k, letter in enumerate(right) if letter in "+-"]
    at = flips[place % len(flips)]
    printed = right[:at] + ("-" if right[at] == "+" else "+") + right[at + 1 :]
    found = mended(printed, right)
    assert found[0].text == right
    assert found[0].span == (at, at + 1)
