"""The mutation study: misprints of every kind, and a judge that can tell."""

import itertools
from pathlib import Path
from types import SimpleNamespace

import pytest
import sympy as sp
from mpmath import mp

from omniproof.audit import mutation
from omniproof.audit.mutants import KINDS, Spelled, mutants
from omniproof.audit.mutation import FLAGGED, Fate, originals, study
from omniproof.audit.run import prepare_to_judge
from omniproof.decide import digits
from omniproof.decide.answer import Proved, Refuted
from omniproof.decide.in_sympy.digits import known_value
from omniproof.formula.evaluation import evaluate
from omniproof.repair.kinds import Edit, Repair
from omniproof.repair.misprint import Mended
from omniproof.transcription.model import Notation
from omniproof.transcription.reader import read

ROOT = Path(__file__).parents[2]
PAPERS = sorted(file.parent.name for file in (ROOT / "paper_data").glob("*/paper.yaml"))
FREE = (r"\alpha_1", r"\alpha_2", r"\theta", "L")
BOUND = ("A", "B", r"\mathbf{a}_1", r"\mathbf{a}_2", r"\mathbf{b}_1", r"\mathbf{b}_2", "OH")
SYMBOLS = [
    Spelled(latex, name, latex in FREE)
    for latex, name in zip(
        (*FREE, *BOUND), (*FREE, "A", "B", "a_1", "a_2", "b_1", "b_2", "OH"), strict=True
    )
]


def tree_of(text):
    return read(text, Notation(), (*FREE, *BOUND))


def planted(text, **options):
    return {(m.kind, m.text) for m in mutants(text, tree_of(text), SYMBOLS, **options)}


@pytest.fixture
def at_root(monkeypatch):
    monkeypatch.chdir(ROOT)


@pytest.mark.parametrize(
    ("text", "kind", "misprint"),
    [
        (r"L - \theta", "sign", r"L + \theta"),
        (r"L + \theta", "sign", r"-L + \theta"),
        (r"-L + \theta", "sign", r"L + \theta"),
        (r"L", "sign", r"-L"),
        (r"\sin \alpha_1", "index", r"\sin \alpha_2"),
        (r"\mathbf{a}_1", "index", r"\mathbf{a}_2"),
        (r"\sin\theta", "symbol", r"\sin L"),
        (r"\mathbf{a}_1", "symbol", r"\mathbf{b}_1"),
        ("A + B", "symbol", "B + B"),
        (r"\sin^2 \theta", "function", r"\cos^2 \theta"),
        (r"\arctan L", "function", r"\tan L"),
        (r"L \cos \theta", "factor", r" \cos \theta"),
        (r"\cos \theta", "factor", r"2\cos \theta"),
        ("3 L", "factor", r"2 \cdot 3 L"),
        ("3 L", "factor", "L 3 L"),
        ("3 L", "constant", "4 L"),
        ("3 L", "constant", "6 L"),
        (r"360^\circ", "constant", r"180^\circ"),
        (r"\frac{3}{L}", "constant", r"\frac{4}{L}"),
        (r"\theta^2", "constant", r"\theta^{3}"),
        (r"\theta^{-1}", "constant", r"\theta^{1}"),
        (r"\frac{L}{\theta}", "transposition", r"\frac{\theta}{L}"),
        (r"L - 2", "transposition", r"2 - L"),
        (r"L \sin \theta", "transposition", r"\theta \sin L"),
        (r"(L, 2)", "transposition", r"(2, L)"),
        (r"\mathbf{a}_1 \times \mathbf{b}_2", "transposition", r"\mathbf{b}_2 \times \mathbf{a}_1"),
    ],
)
def test_misprints_of_every_kind_are_planted(text, kind, misprint):
    assert (kind, misprint) in planted(text)


def test_a_variable_never_stands_for_a_quantity():
    texts = {text for _, text in planted(r"\alpha_1 A")}
    assert not texts & {r"A_1 A", r"\mathbf{a}_1 A", r"\alpha_1 L", r"\alpha_1 OH"}


def test_entries_may_be_left_to_themselves():
    assert {text for _, text in planted(r"A (L, \theta)^T", entries=False)} >= {r"B (L, \theta)^T"}
    assert r"A (\theta, L)^T" not in {t for _, t in planted(r"A (L, \theta)^T", entries=False)}


def test_every_misprint_is_another_text_and_reads():
    text = r"\frac{1}{2} \sin(\alpha_1 - \alpha_2) - L \cos 2\theta + A^2"
    found = planted(text)
    assert {kind for kind, _ in found} == set(KINDS)
    assert text not in {misprint for _, misprint in found}
    assert all(tree_of(misprint) for _, misprint in found)


DIVERSE = [
    r"\frac{\sin \theta - 2}{L}^2 + \sqrt{L} |\cos\theta| - \tan 30^\circ",
    r"\langle (\theta, L)^T, (2, \pi) \rangle \arctan \theta",
    r"\|(\theta, L, 2) \times (1, 2, 3)\| \cdot \operatorname{atan2}(\theta, L)",
    r"\det[(\theta, L)^T, (3, 2)^T] + ((\theta, 3))_y - ((1, 2))_1",
    r"\begin{pmatrix} \theta & L \\ 1 & 2 \end{pmatrix}^{-1} (1, \theta)^T",
    r"\det \begin{pmatrix} \theta & L \\ 1 & 2 \end{pmatrix} (\sec\theta + \csc\theta)\cot\theta",
]


@pytest.mark.parametrize("text", DIVERSE)
def test_digits_are_those_of_the_expression(text):
    point = {"theta": sp.Rational(5, 7), "L": sp.Rational(9, 4)}
    meanings = {r"\theta": sp.Symbol("theta"), "L": sp.Symbol("L")}
    own = digits.value(tree_of(text), lambda symbol, _: known_value(meanings[symbol.name], point))
    known = known_value(evaluate(tree_of(text), meanings, text), point)
    assert digits.are_equal(own, known)
    with mp.workdps(digits.DIGITS):
        assert not digits.are_equal(own * (1 + mp.mpf(10) ** -35), known)


TIME = sp.Symbol("t", real=True)
SPEED = sp.Function("v", real=True)


def over_time(text):
    """Give the digits of a text where `v` is a function of the time `t` that nobody knows."""

    def meaning(symbol, bound):
        point = {"t": bound.get("t", mp.mpf(3) / 2)}
        known = {"v": SPEED(TIME), "t": TIME, "w": sp.Integral(SPEED(TIME), (TIME, 0, TIME))}
        return known_value(known[symbol.name], point, seed=1)

    return digits.value(read(text, Notation(), ("v", "t", "w")), meaning)


@pytest.mark.parametrize(
    ("one", "other"),
    [
        pytest.param(r"\int_0^t (2 v + t) dt", r"2 \int_0^t v dt + t^2 / 2", id="linear"),
        pytest.param(r"\int_0^t v \int_0^t v dt dt", r"(\int_0^t v dt)^2 / 2", id="nested"),
        pytest.param(r"\int_0^t \cos t dt", r"\sin t", id="an integral that is known"),
        pytest.param(r"\int_0^t \sqrt{v^2} dt", "w", id="of an expression"),
        pytest.param(r"\int_0^t w dt", r"\int_0^t \int_0^t v dt dt", id="one inside another"),
    ],
)
def test_integrals_of_unknown_functions_have_digits(one, other):
    assert digits.are_equal(over_time(one), over_time(other))


def test_unknown_functions_and_their_integrals_differ():
    values = [over_time(text) for text in (r"v", r"\int_0^t v dt", r"t v", r"\int_0^t t v dt", "t")]
    pairs = itertools.combinations(values, 2)
    assert not [pair for pair in pairs if digits.are_equal(*pair)]


def test_an_unknown_function_is_a_quadratic_with_positive_coefficients():
    places = [sp.Rational(k, 10) for k in range(-30, 31)]
    known = [known_value(SPEED(TIME), {TIME.name: place}) for place in places]
    assert min(known[30:]) > 0
    with mp.workdps(digits.DIGITS):
        steps = [after - before for before, after in itertools.pairwise(known)]
        bends = [after - before for before, after in itertools.pairwise(steps)]
    # Second differences of a quadratic are all the same.
    assert all(digits.are_equal(bends[0], bend) for bend in bends)
    assert min(bends) > 0


@pytest.mark.parametrize("text", [r"\int_0^t |1 - t| dt", "1 < 2", r"\int_0^t \sqrt{t} dt"])
def test_what_the_digits_do_not_reach_is_said_to_be_so(text):
    with pytest.raises(digits.NotEvaluatedError):
        over_time(text)


@pytest.mark.parametrize("text", [r"\sqrt{-v^2}", r"\int_0^t \frac{1}{v - v} dt"])
def test_what_is_nowhere_defined_is_not_counted_as_unknown(text):
    with pytest.raises(digits.UndefinedError) as error:
        over_time(text)
    assert not isinstance(error.value, digits.NotEvaluatedError)


@pytest.mark.parametrize(
    "text", [r"\sqrt{-1}", r"\frac{1}{0}", r"(1, 2) + 3", r"\{1, 2\}", "1 < 2", r"((1, 2))_z"]
)
def test_what_has_no_real_value_has_no_digits(text):
    with pytest.raises(digits.UndefinedError):
        digits.value(tree_of(text), {}.__getitem__)


def test_a_sample_is_flagged_and_repaired(at_root):
    found = study(["omni-arrangement"], sample=25, seed=3)
    assert found.population > 2_000
    assert len(found.cases) == 25
    assert found.flagged == found.different > 15
    assert found.counts[Fate.FALSE_ALARM] == found.counts[Fate.UNDECIDED] == 0
    assert found.repaired >= 0.97 * found.flagged


def test_the_same_seed_draws_the_same_sample(at_root, tmp_path):
    for name in ("one", "other"):
        mutation.write_study(study(["omni-arrangement"], sample=4, seed=5), tmp_path / name)
    assert (tmp_path / "one").read_bytes() == (tmp_path / "other").read_bytes()


def test_a_misprint_is_planted_in_what_mechanics_confirms(at_root):
    """Of two laws that follow from a wrong premise, only the levers and the names are right."""
    context = prepare_to_judge(Path("paper_data/ballbot"))
    found = {each.text for each in originals(context) if each.claim in {"eq:7", "eq:10"}}
    assert found == {r"Ls\phi", "v_y^{C_1}"}


@pytest.fixture
def one_case(at_root):
    """Return a function that judges a misprint of the determinant, Eq. (8)."""
    context = prepare_to_judge(Path("paper_data/omni-arrangement"))
    text = r"\sin(\alpha_1 - \alpha_3)"
    original = next(each for each in originals(context) if each.text == text)

    def judge(misprint):
        return mutation.fate(original, SimpleNamespace(kind="sign", text=misprint), context)

    return judge


@pytest.mark.parametrize(
    ("misprint", "fate"),
    [
        (r"\sin(\alpha_1 + \alpha_3)", Fate.EXPLAINED),
        (r"-\cos(\alpha_1 - \alpha_3)", Fate.POSSIBLE),
        (r"-\sin(\alpha_3 - \alpha_1)", Fate.EQUIVALENT),
        (r"\sin(\alpha_1 - ", Fate.REFUSED),
        (r"\frac{V_x}{1 + v_1^3} - \tan v_2", Fate.UNREPAIRED),
    ],
)
def test_each_fate(one_case, misprint, fate):
    assert one_case(misprint).fate is fate


@pytest.mark.parametrize(
    ("misprint", "answer", "fate"),
    [
        (r"\sin(\alpha_1 + \alpha_3)", Proved(()), Fate.MISSED),
        (r"-\sin(\alpha_3 - \alpha_1)", Refuted((), None), Fate.FALSE_ALARM),
    ],
)
def test_a_wrong_engine_is_caught(one_case, monkeypatch, misprint, answer, fate):
    monkeypatch.setattr(mutation, "confirmed_equal", lambda *_: answer)
    assert one_case(misprint).fate is fate


def test_a_wrong_repair_is_caught(one_case, monkeypatch):
    text = r"\sin(\alpha_1 - \alpha_2)"
    wrong = Mended((Repair(Edit.SIGN, (0, len(text)), "", text),), 1)
    monkeypatch.setattr(mutation, "mend_claim", lambda *_: wrong)
    assert one_case(r"\sin(\alpha_1 + \alpha_3)").fate is Fate.MISREPAIRED


def test_what_is_not_evaluated_is_shown(one_case, monkeypatch):
    def gives_up(*_):
        raise digits.NotEvaluatedError("too deep")

    monkeypatch.setattr(mutation, "value", gives_up)
    case = one_case(r"\sin(\alpha_1 + \alpha_3)")
    assert case.fate is Fate.NOT_EVALUATED
    record = mutation.Study(1, (case,)).record()
    assert record["not_evaluated"] == len(record["failures"]) == 1
    assert record["different"] == record["equivalent"] == 0


def test_figures_add_up():
    case = mutation.Case("eq:1", "x", "sign", "-x", Fate.MISSED)
    others = [mutation.Case("eq:1", "x", "index", "y", fate) for fate in Fate]
    record = mutation.Study(99, (case, *others)).record()
    assert record["mutants"] == len(Fate) + 1
    assert record["different"] == len(FLAGGED) + 2
    assert record["flagged"] == len(FLAGGED)
    assert record["repaired"] == 2
    assert record["equivalent"] == 3
    assert record["kinds"]["sign"] == {"mutants": 1, "different": 1, "flagged": 0, "repaired": 0}
    assert len(record["failures"]) == len(Fate) - 4 + 1


@pytest.mark.slow
@pytest.mark.parametrize("paper", PAPERS)
def test_every_misprint_is_flagged_and_nearly_all_are_repaired(at_root, paper):
    found = study([paper])
    assert found.flagged == found.different
    assert found.counts[Fate.FALSE_ALARM] == found.counts[Fate.UNDECIDED] == 0
    assert found.repaired >= 0.97 * found.flagged
