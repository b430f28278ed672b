"""What is true only where the paper says so, and what follows from what it says."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
import tiny_paper
from sympy import Abs, And, Expr, Ne, Rational, Symbol, cos, pi, sin, sqrt, symbols
from sympy import false as sp_false

from omniproof.audit import run
from omniproof.audit.ledger import Row
from omniproof.audit.relations import judge
from omniproof.decide.answer import OnBranch, Proved, Refuted, Undecided
from omniproof.decide.in_sympy.domain import REALS, Domain
from omniproof.decide.in_sympy.equality import decide_equal
from omniproof.decide.in_sympy.sampling import sample_points
from omniproof.decide.order.hypotheses import domain_of, sign_under
from omniproof.formula.errors import UnsupportedError
from omniproof.registry import Curve, Family, Obligation, Ordered, Registry
from omniproof.transcription.faults import BadInput
from omniproof.transcription.model import Form

a, b, c, t, x = symbols("a b c t x", real=True)
A1, A2, A3 = symbols("alpha_1:4", real=True)
TURN = [And(angle > 0, angle < 2 * pi) for angle in (A1, A2, A3)]
ORDER = [*TURN, A1 < A2, A2 < A3]
ARCS = sin((A2 - A1) / 2) * sin((A3 - A2) / 2) * sin((A3 - A1) / 2)


def case(printed: Expr, derived: Expr, *stated: Any, expected: type, why: str) -> Any:
    return pytest.param(printed, derived, stated, expected, id=why)


IDENTITIES = [
    case(sqrt(1 - cos(t) ** 2), sin(t), t > 0, t < pi, expected=Proved, why="upper half"),
    case(sqrt(1 - cos(t) ** 2), sin(t), t > -1, t < pi, expected=OnBranch, why="not from -1 on"),
    case(sqrt(1 - cos(t) ** 2), sin(t), t > -pi, t < 0, expected=Refuted, why="lower half"),
    case(Abs(a - b), b - a, a < b, expected=Proved, why="an order"),
    case(Abs(a - c), c - a, a < b, b < c, expected=Proved, why="an order in two steps"),
    case(Abs(a - c), a - c, a < b, b < c, expected=Refuted, why="the wrong order"),
    case(Abs(a + b - c), a + b - c, a + b > c, expected=Proved, why="triangle inequality"),
    case(Abs(a * x), a * x, a > 0, expected=OnBranch, why="one sign of two"),
    case(sqrt((1 - cos(A2 - A1)) / 2), sin((A2 - A1) / 2), *ORDER, expected=Proved, why="an arc"),
    case(Abs(ARCS), ARCS, *ORDER, expected=Proved, why="the arcs of three wheels"),
    case(Abs(ARCS), ARCS, *TURN, expected=OnBranch, why="not in any order"),
    case(sin(t), t, Ne(a + b, 0), expected=Refuted, why="a condition that does not matter"),
    case(Abs(a), a, a**2 > b, expected=OnBranch, why="a condition that decides nothing"),
]


@pytest.mark.parametrize(("printed", "derived", "stated", "expected"), IDENTITIES)
def test_identities_on_a_domain(
    printed: Expr, derived: Expr, stated: tuple[Any, ...], expected: type
) -> None:
    domain = domain_of(stated)
    answer = decide_equal(printed, derived, domain)
    assert isinstance(answer, expected)
    if isinstance(answer, OnBranch):
        named = {symbol.name: symbol for symbol in printed.free_symbols}
        point = {named[name]: Rational(value) for name, value in answer.witness.point.items()}
        assert point.keys() == printed.free_symbols, "the witness is a whole point"
        assert sp_false not in [statement.subs(point) for statement in stated]
        assert sp_false in [needed.subs(point) for needed in answer.relations]
        assert abs(float((printed - derived).subs(point))) > 1e-6


def test_points_keep_the_conditions() -> None:
    points = list(sample_points((A1, A2, A3), domain_of(ORDER), count=20))
    assert len(points) == 20
    values = [[float(Fraction(str(point[angle]))) for angle in (A1, A2, A3)] for point in points]
    assert all(0 < one < two < three < 6.2832 for one, two, three in values)


def test_a_closed_end_and_a_tighter_bound() -> None:
    tighter = domain_of([a >= 0, a > 1, a < 3, a <= 2])
    assert tighter == Domain({"a": (1, 2)}, closed={"a": (False, True)})
    assert domain_of([]) == REALS


@pytest.mark.parametrize(
    ("stated", "closed"),
    [
        pytest.param([a >= 0], (True, False), id="one side"),
        pytest.param([a >= 0, a >= 0, a <= 1], (True, True), id="said twice"),
        pytest.param([a >= 0, a > 0, a <= 1], (False, True), id="the stricter one counts"),
        pytest.param([a >= 0, a >= 1, a <= 2], (True, True), id="the tighter one counts"),
    ],
)
def test_which_ends_belong_to_an_interval(stated: list[Any], closed: tuple[bool, bool]) -> None:
    assert domain_of(stated).closed == {"a": closed}


def test_an_open_range_stays_open() -> None:
    assert domain_of([a >= 0], Domain({"a": (0, 1)})).closed == {}


@pytest.mark.parametrize(
    "stated", [(a > 1, a < 0), (a > 0, a < 0), (Symbol("L", positive=True) < 0,)]
)
def test_nothing_fulfils_a_contradiction(stated: tuple[Any, ...]) -> None:
    with pytest.raises(UnsupportedError):
        domain_of(stated)


def test_conditions_that_exclude_each_other_leave_it_undecided() -> None:
    answer = decide_equal(Abs(a - b), a - b, domain_of([a < b, b < a]))
    assert isinstance(answer, Undecided)


@pytest.mark.parametrize(
    ("expression", "stated", "sign"),
    [
        pytest.param(a - b, (a > b,), 1, id="the condition itself"),
        pytest.param(2 * b - 2 * a, (a > b,), -1, id="a multiple"),
        pytest.param(a * b**3, (a > 0, b < 0), -1, id="a product"),
        pytest.param(a**2, (a > 0,), 1, id="a square of a positive number"),
        pytest.param(a + b, (a > 0, b > 1), 1, id="a sum"),
        pytest.param(a - b, (a > 0, b > 0), None, id="a difference"),
        pytest.param(sin((A1 - A2) / 2), ORDER, -1, id="half an arc"),
        pytest.param(sin(A2 - A1), ORDER, None, id="an arc may be more than half a turn"),
        pytest.param(sin(t), (t > 0, t < pi), 1, id="a box"),
        pytest.param(
            sin(A1) + t * sin(A2), (*TURN, pi > A1, pi > A2, t > 0), 1, id="terms of one sign"
        ),
    ],
)
def test_signs_that_follow(expression: Expr, stated: tuple[Any, ...], sign: int | None) -> None:
    assert sign_under(expression, domain_of(stated)) == sign


LINE = {t: (0, 3)}
UPWARD = (Form.POSITIVE, Family(t, LINE))
UNIT = {a: (-1, 1), b: (-1, 1)}
ORDERED = (Form.POSITIVE, Family(b - a, UNIT))


@pytest.mark.parametrize(
    ("form", "subject", "stated", "expected"),
    [
        pytest.param(Form.POSITIVE, Family(sin(t), {t: (0, 2 * pi)}), (t < pi,), Proved,
                     id="the box is cut"),
        pytest.param(Form.POSITIVE, Family(sin(t), {t: (0, 2 * pi)}), (t > pi,), Refuted,
                     id="the other half"),
        pytest.param(Form.POSITIVE, Family(sin(t), {t: (0, 1)}), (t > 2,), Undecided,
                     id="nothing is left"),
        pytest.param(*ORDERED, (a < b,), Proved, id="the condition decides"),
        pytest.param(*ORDERED, (a < b + 1,), Undecided, id="the condition does not"),
        pytest.param(Form.EQUAL, (Abs(a - b), b - a), (a < b,), Proved, id="equal on a domain"),
        pytest.param(*UPWARD, (t < 1,), Proved, id="open end"),
        pytest.param(*UPWARD, (t >= 0,), OnBranch, id="zero at a closed end"),
        pytest.param(*UPWARD, (t >= 1, t <= 2), Proved, id="closed ends that do no harm"),
        pytest.param(Form.CHAIN, Ordered((sin(t), t), LINE), (t >= 0,), OnBranch,
                     id="a chain that fails at a closed end"),
        pytest.param(*ORDERED, (a < b, a >= -1), Proved, id="a condition and a closed end"),
        pytest.param(Form.CHAIN, Ordered((sin(t), cos(t)), {t: (0, pi)}), (t < pi / 4,), Proved,
                     id="a chain"),
        pytest.param(Form.CIRCLE, Curve((a * cos(t), a * sin(t)), {t: (0, pi)}), (a > 0,), Proved,
                     id="a radius that is not zero"),
        pytest.param(Form.CIRCLE, Curve((a * cos(t), a * sin(t)), {t: (0, pi)}), (Ne(a, 0),),
                     Proved, id="or just not zero"),
        pytest.param(Form.INCREASING, (a * 0 + 2, a * 0 + 1), (a < b,), Refuted, id="numbers"),
    ],
)  # fmt: skip
def test_relations_on_a_domain(
    form: Form, subject: Any, stated: tuple[Any, ...], expected: type
) -> None:
    assert isinstance(judge(Obligation(form, subject), domain_of(stated)), expected)


HEAD = tiny_paper.PAPER.lstrip().partition("symbols:")[0]
PAPER = (
    HEAD
    + r"""symbols:
  - {latex: '\theta', name: theta, range: '(0, 180^\circ)', means: an angle}
  - {latex: 'a', name: a, means: a number}
  - {latex: 'b', name: b, means: a number}
claims:
  - {id: 'eq:1', kind: identity, line: 1, says: a half, latex: '|\sin \theta|'}
  - {id: 'eq:2', kind: identity, line: 2, says: free, latex: '|\cos \theta|'}
  - id: eq:3
    kind: identity
    line: 3
    says: stated
    latex: '|\cos \theta|'
    assumes: '\theta < 90^\circ'
  - {id: 'eq:4', kind: identity, line: 4, says: order, latex: '|a - b|', assumes: ['a > b']}
  - {id: 'eq:5', kind: identity, line: 5, says: not enough, latex: '|a b|', assumes: ['a > 0']}
  - id: sec:1/chain
    kind: relation
    line: 6
    says: for acute angles
    latex: '\sin \theta < \theta < \tan \theta'
    asserts: {form: chain}
    assumes: '\theta < 90^\circ'
"""
)
theta = Symbol("theta", real=True)


def registry() -> Registry:
    found = Registry("tiny-paper")
    found.derives("eq:1")(lambda: sin(theta))
    found.derives("eq:2", "eq:3")(lambda: cos(theta))
    found.derives("eq:4")(lambda: a - b)
    found.derives("eq:5")(lambda: a * b)
    found.derives("sec:1/chain")(lambda: Ordered((), {theta: (0, pi)}))
    return found


def audited(folder: Path, patch: pytest.MonkeyPatch, text: str) -> dict[str, Row]:
    patch.setattr(run, "load_registry", lambda paper: registry())
    patch.setattr(run, "load_readings", lambda paper: {})
    (folder / "paper.yaml").write_text(text, encoding="utf-8")
    return {row.id: row for row in run.audit_paper(folder).rows}


def test_a_claim_is_judged_where_it_is_stated(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    rows = audited(tmp_path, monkeypatch, PAPER)
    assert {name: (row.verdict.value, row.assumption) for name, row in rows.items()} == {
        "eq:1": ("verified", ""),
        "eq:2": ("conditional", r"\cos {\theta} \geq 0"),
        "eq:3": ("verified", ""),
        "eq:4": ("verified", ""),
        "eq:5": ("conditional", r"b \geq 0"),
        "sec:1/chain": ("verified", ""),
    }
    witness = rows["eq:5"].witness
    assert witness is not None
    assert float(Fraction(witness.point["a"])) > 0


def test_a_contradiction_is_bad_input(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(BadInput, match=r"claims\[eq:4\].assumes: no value of a is left"):
        audited(tmp_path, monkeypatch, PAPER.replace("['a > b']", "['a > 1', 'a < 0']"))
