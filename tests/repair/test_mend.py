"""Repair of misprints: the right edit is found, first, at the right place."""

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from omniproof.decide.answer import Proved
from omniproof.decide.in_sympy.equality import decide_equal
from omniproof.formula.evaluation import evaluate
from omniproof.repair.edits import edits
from omniproof.repair.in_sympy import at_points
from omniproof.repair.likeness import likeness
from omniproof.repair.mend import mend
from omniproof.repair.misprint import Misprint
from omniproof.repair.values import POINTS, agree
from omniproof.repair.values import evaluate as evaluate_roughly
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
    return evaluate(tree_of(text), MEANINGS, text)


def tree_of(text: str):
    return read(text, Notation(), VOCABULARY + EXTRA)


def meaning(symbol):
    return at_points(MEANINGS[symbol.name])


def misprint(printed: str, right: str, prove=decide_equal) -> Misprint:
    target = value(right)

    def proved(text: str) -> tuple[str, ...]:
        try:
            answer = prove(value(text), target)
        except (LatexError, TypeError):
            return ()
        return answer.engines if isinstance(answer, Proved) else ()

    return Misprint(printed, tree_of, tree_of, proved, meaning, at_points(target), words=VOCABULARY)


def mended(printed: str, right: str, size: int = 1):
    found = mend(misprint(printed, right))
    return found.repairs if found and found.size == size else ()


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
    pytest.param(
        r"\frac{\cos\theta}{L}", r"\frac{L}{\cos\theta}", "invert the ratio", id="ratio upside down"
    ),
    pytest.param(
        r"\sin\alpha_2 \cos\alpha_1 + L",
        r"\sin\alpha_1 \cos\alpha_2 + L",
        r"\alpha_2 <-> \alpha_1",
        id="transposed symbols",
    ),
    pytest.param(
        r"\cos\theta - \sin\alpha_1",
        r"\sin\alpha_1 - \cos\theta",
        "swap the terms",
        id="transposed terms",
    ),
    pytest.param(r"3 + L", r"\sqrt{3} + L", r"3 -> \sqrt{3}", id="missing root"),
    pytest.param(r"|\sin\theta| + L", r"\sin\theta + L", "drop bars", id="superfluous bars"),
    pytest.param(r"\sqrt{L}", "L", "drop the sqrt", id="superfluous root"),
    pytest.param(
        r"\frac{\sin\theta}{L}", r"\arctan\frac{\sin\theta}{L}", None, id="missing inverse tangent"
    ),
    pytest.param(r"\sin^2\theta + L", r"\sin\theta + L", "2 -> 1", id="superfluous power"),
    pytest.param(r"\sin\theta", r"\frac{\sin\theta}{R}", "divide by R", id="missing divisor"),
    pytest.param(r"5\theta", r"6\theta", "5 -> 6", id="constant off by one"),
    pytest.param(
        r"\sin(\alpha_1 \alpha_2)", r"\sin(\alpha_1 - \alpha_2)", "insert -", id="lost minus"
    ),
    pytest.param(
        r"\cos\alpha_3 - \cos\alpha_1 \sin\alpha_3",
        r"\sin\alpha_1 \cos\alpha_3 - \cos\alpha_1 \sin\alpha_3",
        r"insert \sin \alpha_1",
        id="lost sine",
    ),
    pytest.param(r"30^\circ - L", r"30^\circ + L", "- -> +", id="sign after degrees"),
    pytest.param(r"\|(1, \theta)\| - L", r"\|(1, \theta)\| + L", "- -> +", id="sign after bars"),
    pytest.param(
        r"\langle (1, L)^T, (2, \theta)^T \rangle + \theta",
        r"\langle (1, L)^T, (2, \theta)^T \rangle - \theta",
        "+ -> -",
        id="sign after an inner product",
    ),
]


@pytest.mark.parametrize(("printed", "right", "description"), TABLE)
def test_the_first_repair_is_the_misprint(printed, right, description):
    found = mended(printed, right)
    assert description in {None, found[0].description}
    assert sp.simplify(value(found[0].text) - value(right)) == 0


@pytest.mark.parametrize(("printed", "right", "description"), TABLE)
def test_the_edit_is_where_its_span_says(printed, right, description):
    edit = mended(printed, right)[0]
    start, end = edit.span
    assert edit.text.startswith(printed[:start])
    assert edit.text.endswith(printed[end:])


def test_repairs_come_in_order_of_likelihood():
    found = mended(r"L\sin\theta - L\cos\theta", "0")
    assert [edit.kind for edit in found] == sorted(edit.kind for edit in found)
    assert found[0].description == r"\sin -> \cos"
    assert len({edit.text for edit in found}) == len(found) > 1


def test_the_spelling_of_the_paper_is_kept():
    (edit,) = mended(r"\sin  \alpha_{1}  +  \sin\alpha_2", r"\sin\alpha_1 - \sin\alpha_2")
    assert edit.text == r"\sin  \alpha_{1}  -  \sin\alpha_2"


def test_a_command_is_kept_apart_from_a_letter():
    found = mended(r"\sin\theta", r"\sin L")
    assert found[0].text == r"\sin L"


def test_letters_of_two_symbols_are_kept_apart():
    names = ("L", "x", "y")
    assert {edit.text for edit in edits("x y", names)} >= {"L x y", "L (x y)", "L y"}
    assert not [edit.text for edit in edits("x y", names) if "Lx" in edit.text]


def test_a_dropped_factor_leaves_no_blank():
    assert r"\cos\theta" in {edit.text for edit in edits(r"2 \cos\theta", VOCABULARY)}


def test_only_relatives_of_a_symbol_replace_it():
    texts = {edit.text for edit in edits("a_1 b", (), ("a_2", "c_1", "c_2", "d"))}
    assert texts >= {"a_2 b", "c_1 b", "a_1 d"}
    assert not texts & {"c_2 b", "d b", "a_1 a_2"}


def test_a_superscript_belongs_to_a_declared_symbol():
    texts = {edit.text for edit in edits("v_k^T + v_k^R", (), ("v_k^T", "v_k^R"))}
    assert texts >= {"v_k^R + v_k^R", "v_k^T + v_k^T", "v_k^R + v_k^T"}


@pytest.mark.parametrize("printed", ["v_x^B", "v_{x}^{B}"])
def test_a_symbol_that_is_only_known_goes_as_one(printed):
    known = ("v_x^B", r"\omega_z^B")
    texts = {edit.text for edit in edits(f"{printed} L", ("L", "R"), known=known)}
    assert texts >= {"L", "R L"}
    assert not [text for text in texts if r"\omega" in text or "L^B" in text]


DIVERSE = [
    r"\frac{\sin \alpha_1 - 2}{L}^2 + \sqrt{L} |\cos\theta| - \tan 30^\circ",
    r"\langle (\theta, L)^T, (R, \pi) \rangle \arctan \theta",
    r"\|(\theta, L, R) \times (1, 2, 3)\| \cdot \operatorname{atan2}(\theta, L)",
    r"\det[(\theta, L)^T, (R, 2)^T] + ((\theta, R))_y",
    r"\begin{pmatrix} \theta & L \\ R & 2 \end{pmatrix}^{-1} (1, \theta)^T",
    r"\det \begin{pmatrix} \theta & L \\ R & 2 \end{pmatrix} (\sec\theta + \csc\theta)\cot\theta",
]


@pytest.mark.parametrize("text", DIVERSE)
def test_rough_values_are_those_of_the_expression(text):
    rough = evaluate_roughly(tree_of(text), meaning)
    exact = at_points(value(text))
    assert rough.shape == exact.shape
    assert agree(rough, exact)
    assert not agree(rough * 1.001, exact)


def test_where_the_truth_is_undefined_nothing_agrees():
    assert not agree(at_points(sp.Integer(1)), at_points(sp.Integer(1)) * float("nan"))
    assert at_points(sp.Integer(1)).shape == (POINTS, 1, 1)


@pytest.mark.parametrize(
    ("printed", "right"),
    [
        (r"\sin 2\theta = 2 \sin \theta \sin \theta", r"\sin 2\theta = 2 \sin \theta \cos \theta"),
        (r"(2\theta, L)^T = (\theta + L, L)^T", r"(2\theta, L)^T = (\theta + \theta, L)^T"),
    ],
)
def test_an_equation_is_mended_on_either_side(printed, right):
    statement = Misprint(printed, tree_of, tree_of, lambda _: ("flint",), meaning, words=VOCABULARY)
    found = mend(statement)
    assert likeness(tree_of(right)) in {likeness(tree_of(edit.text)) for edit in found.repairs}
    assert len(found.repairs) < 8


TWICE = [
    pytest.param(
        r"\sin\alpha_1 + \cos\alpha_2", r"\cos\alpha_1 - \cos\alpha_2", id="function and sign"
    ),
    pytest.param(
        r"L\sin\alpha_2 - R\cos\alpha_2", r"L\sin\alpha_1 - L\cos\alpha_2", id="index and letter"
    ),
    pytest.param(
        r"\frac{8}{2\cos\theta + \sin 3\theta}",
        r"\frac{4}{2\cos\theta + \sin 2\theta}",
        id="two constants",
    ),
    pytest.param(r"-\sin(\alpha_1 - \theta)", r"\cos(\alpha_1 - \theta)", id="one in the other"),
]


@pytest.mark.parametrize(("printed", "right"), TWICE)
def test_two_misprints_are_mended_together(printed, right):
    assert mended(printed, right) == ()
    found = mended(printed, right, size=2)
    assert likeness(tree_of(found[0].text)) == likeness(tree_of(right))
    assert all(sp.simplify(value(edit.text) - value(right)) == 0 for edit in found)


@pytest.mark.parametrize("text", ["$", "x" * 20_000, r"\{\theta\}", r"\theta < L"])
def test_what_is_no_number_has_no_pair_of_repairs(text):
    assert mended(text, "1", size=2) == ()


def test_a_formula_with_nothing_in_common_is_not_mended():
    printed, right = r"\sin\alpha_1 \cos\alpha_2 + L", r"\frac{\theta}{1 + \theta^3} - \tan R"
    assert mended(printed, right) == mended(printed, right, size=2) == ()


ALIKE = [
    (r"-\sin(\alpha_1 - \alpha_2)", r"\sin(\alpha_2 - \alpha_1)"),
    (r"2 L \theta", r"\theta * 2 L"),
    (r"\frac{1}{2} \frac{8}{L}", r"\frac{4}{L}"),
    (r"L - \theta + R", r"R + (L) - \theta"),
    (r"\cos(\theta - L)", r"\cos(L - \theta)"),
]
UNLIKE = [
    (r"\sin(\alpha_1 - \alpha_2)", r"\sin(\alpha_2 - \alpha_1)"),
    (r"\sin 2\theta", r"2 \sin \theta \cos \theta"),
    (r"L - \theta", r"L + \theta"),
    (r"\frac{L}{\theta}", r"\frac{\theta}{L}"),
    (r"\cos 2\theta", r"\cos \theta"),
]


@pytest.mark.parametrize(("one", "other"), ALIKE)
def test_spellings_of_one_formula_are_alike(one, other):
    assert likeness(tree_of(one)) == likeness(tree_of(other))


@pytest.mark.parametrize(("one", "other"), UNLIKE)
def test_other_formulas_are_unlike(one, other):
    assert likeness(tree_of(one)) != likeness(tree_of(other))


def test_two_misprints_are_no_single_edit():
    assert mended(r"\sin\alpha_1 + \cos\alpha_2", r"\cos\alpha_1 - \cos\alpha_2") == ()


@pytest.mark.parametrize("text", [r"\badcommand x", "$", "", "x" * 20_000, "é"])
def test_unreadable_text_has_no_repair(text):
    assert mended(text, "1") == ()


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
