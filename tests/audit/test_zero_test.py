"""The zero test against textbooks, mpmath and random trigonometric polynomials."""

from fractions import Fraction

import mpmath
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from identity_table import BRANCH, ROWS, Row, x, y, z

from omniproof.decide.answer import DisagreementError, OnBranch, Proved, Refuted, Undecided
from omniproof.decide.in_sympy.domain import Domain
from omniproof.decide.in_sympy.equality import decide_equal
from omniproof.decide.normal_form import angles, quotient_ring
from omniproof.decide.normal_form.radicals import Extension

KINDS = {"true": Proved, "false": Refuted, "branch": OnBranch}
WITH_ID = [pytest.param(row, id=row.name) for row in ROWS]
NOT_TRUE = [pytest.param(row, id=row.name) for row in ROWS if row.expected != "true"]


def answer(row: Row):
    return decide_equal(row.left, row.right, row.domain)


def high_precision(expression: sp.Expr, point: dict[str, str]) -> mpmath.mpf:
    """Evaluate with mpmath at 50 digits, sharing no code with the engine."""
    names = list(point)
    function = sp.lambdify([sp.Symbol(name) for name in names], _plain(expression), "mpmath")
    with mpmath.workdps(50):
        values = [
            mpmath.mpf(Fraction(point[k]).numerator) / Fraction(point[k]).denominator for k in names
        ]
        return mpmath.mpf(function(*values))


def _plain(expression: sp.Expr) -> sp.Expr:
    return expression.xreplace({s: sp.Symbol(s.name) for s in expression.free_symbols})


@pytest.mark.parametrize("row", WITH_ID)
def test_the_answer_is_the_textbook_answer(row):
    assert isinstance(answer(row), KINDS[row.expected]), (row.source, answer(row))


@pytest.mark.parametrize("row", WITH_ID)
def test_the_sides_can_be_exchanged(row):
    assert isinstance(decide_equal(row.right, row.left, row.domain), KINDS[row.expected])


@pytest.mark.parametrize("row", NOT_TRUE)
def test_mpmath_confirms_the_witness(row):
    witness = answer(row).witness
    printed = high_precision(row.left, witness.point)
    derived = high_precision(row.right, witness.point)
    assert abs(printed - derived) > mpmath.mpf(10) ** -45
    assert witness.printed != witness.derived
    for shown, value in ((witness.printed, printed), (witness.derived, derived)):
        assert abs(mpmath.mpf(shown) - value) <= abs(value) * mpmath.mpf("1e-3")


@pytest.mark.parametrize("row", [pytest.param(row, id=row.name) for row in BRANCH])
def test_the_condition_is_exact(row):
    """At rational points on a lattice, the sides agree just where the relations hold."""
    found = answer(row)
    symbols = sorted((row.left - row.right).free_symbols, key=str)
    tried = set()
    for k in range(60):
        point = {s.name: str(_lattice(s, k, i)) for i, s in enumerate(symbols)}
        holds = all(_holds(relation, point) for relation in found.relations)
        gap = abs(high_precision(row.left, point) - high_precision(row.right, point))
        assert (gap < mpmath.mpf(10) ** -40) == holds, (point, found.condition)
        tried.add(holds)
    assert tried == {True, False}


def _lattice(symbol: sp.Symbol, k: int, i: int) -> Fraction:
    value = (Fraction(17 * k + 29 * i * (k + 1), 7) + Fraction(i, 5)) % 6
    return value + Fraction(1, 3) if symbol.is_positive else value - 3 + Fraction(1, 97)


def _holds(relation: sp.Basic, point: dict[str, str]) -> bool:
    left = high_precision(relation.lhs, point)
    return bool(left > 0)


@pytest.mark.parametrize(
    ("row", "condition"),
    [
        pytest.param(BRANCH[0], r"x \geq 0", id="a symbol"),
        pytest.param(BRANCH[1], r"\cos{\left(x \right)} \geq 0", id="a function"),
        pytest.param(BRANCH[5], r"x \geq 0 \text{ and } y \geq 0", id="two conditions"),
        pytest.param(BRANCH[6], r"x y \geq 0", id="a product"),
    ],
)
def test_conditions_are_written_in_the_terms_of_the_formula(row, condition):
    assert answer(row).condition == condition


def test_a_condition_is_strict_where_its_border_is_a_pole():
    assert answer(BRANCH[4]).condition.endswith("> 0")


def test_a_domain_that_excludes_the_branch_refutes():
    row = BRANCH[1]
    beyond = Domain({"x": (sp.pi / 2, sp.pi)})
    assert isinstance(decide_equal(row.left, row.right, beyond), Refuted)
    assert isinstance(decide_equal(row.left, -row.right, beyond), Proved)


def test_what_the_domain_settles_is_no_condition():
    row = BRANCH[5]  # |x| + |y| = x + y
    found = decide_equal(row.left, row.right, Domain({"x": (1, 2)}))
    assert found.condition == r"y \geq 0"
    assert isinstance(
        decide_equal(row.left, row.right, Domain({"x": (1, 2), "y": (0, sp.oo)})), Proved
    )


@pytest.mark.parametrize(
    ("left", "right", "condition"),
    [
        pytest.param(
            sp.cos(x / 3),
            sp.sqrt(1 - sp.sin(x / 3) ** 2),
            r"\cos{\left(\frac{x}{3} \right)} \geq 0",
            id="a slow angle",
        ),
        pytest.param(
            sp.cos(sp.pi * x / 180),
            sp.sqrt((1 + sp.cos(sp.pi * x / 90)) / 2),
            r"\cos{\left(\frac{\pi x}{180} \right)} \geq 0",
            id="degrees",
        ),
        pytest.param(sp.Abs(300 - x), 300 - x, r"300 - x \geq 0", id="a large number"),
    ],
)
def test_a_difference_far_out_is_found(left, right, condition):
    """No point within (-3, 3) shows one."""
    found = decide_equal(left, right)
    assert isinstance(found, OnBranch)
    assert found.condition == condition
    assert abs(Fraction(found.witness.point["x"])) > 3
    gap = high_precision(left - right, found.witness.point)
    assert abs(gap) > mpmath.mpf(10) ** -40


def test_a_bounded_domain_has_nothing_far_out():
    inside = Domain({"x": (-sp.pi, sp.pi)})
    assert isinstance(decide_equal(sp.cos(x / 2), sp.sqrt((1 + sp.cos(x)) / 2), inside), Proved)


@pytest.mark.parametrize(
    ("expression", "reason"),
    [
        pytest.param(x / 0, "undefined value", id="division by zero"),
        pytest.param(sp.nan, "undefined value", id="nan"),
        pytest.param(sp.Float(0.5) * x, "floating-point", id="float"),
        pytest.param(sp.I * x, "imaginary", id="complex"),
        pytest.param(sp.gamma(x) - sp.gamma(x + 1) / x, "gamma", id="unknown function"),
        pytest.param(sp.sqrt(-1 - x**2) * (1 - 1), "", id="nothing left"),
        pytest.param(sp.sqrt(-1 - x**2), "not real", id="nowhere real"),
        pytest.param(
            sp.atan2(y, x) - 2 * sp.atan(y / (sp.sqrt(x**2 + y**2) + x)),
            "no proof|no identity",
            id="inverse functions",
        ),
        pytest.param(
            1 / (sp.sin(x) ** 2 + sp.cos(x) ** 2 - 1), "zero|defined", id="hidden zero below"
        ),
        pytest.param(
            sp.sin(10**6 * x) - sp.sin(10**6 * x + 2 * sp.pi * x * 0), "", id="structural zero"
        ),
    ],
)
def test_what_cannot_be_decided_says_why(expression, reason):
    found = decide_equal(expression, sp.S.Zero)
    if not reason:
        assert isinstance(found, Proved)
    else:
        assert isinstance(found, Undecided)
        assert any(part in found.reason for part in reason.split("|")), found.reason


@pytest.mark.parametrize(
    "expression",
    [
        pytest.param(
            sp.Pow(x + y + z + 1, 90)
            - sp.Pow(1 + z + y + x, 90) * (sp.sin(x) ** 2 + sp.cos(x) ** 2),
            id="large power",
        ),
        pytest.param(sp.sin(500 * x) - 2 * sp.sin(250 * x) * sp.cos(250 * x), id="large multiple"),
        pytest.param(sp.cos(sp.pi / 10007) - 2 * sp.cos(sp.pi / 20014) ** 2 + 1, id="fine angle"),
    ],
)
def test_work_limits_end_in_undecided_or_a_proof(expression):
    assert isinstance(decide_equal(expression, sp.S.Zero), (Undecided, Proved))


@pytest.mark.parametrize("other", [x, y / 0])
def test_nothing_is_said_of_a_side_that_is_undefined(other):
    found = decide_equal(x / 0, other)
    assert "a division by zero or another undefined value" in found.reason


@pytest.mark.parametrize(
    ("side", "reason"),
    [
        pytest.param(sp.sin(x), None, id="a formula"),
        pytest.param(sp.S.Zero, None, id="a number"),
        pytest.param(sp.sqrt(x - 1) / abs(y), None, id="defined in a part"),
        pytest.param(sp.exp(sp.atan2(y, x)), None, id="outside of the normal form"),
        pytest.param(sp.sqrt(-1 - x**2), "no point of the domain", id="nowhere real"),
        pytest.param(1 / (sp.cos(x) ** 2 + sp.sin(x) ** 2 - 1), "no point", id="only poles"),
        pytest.param(sp.gamma(x), "gamma", id="unknown function"),
        pytest.param(sp.Float(0.5) * x, "floating-point", id="inexact"),
    ],
)
def test_sides_that_are_written_alike_are_equal_if_they_are_defined_anywhere(side, reason):
    found = decide_equal(side, side)
    assert isinstance(found, Undecided if reason else Proved)
    assert reason is None or reason in found.reason


def test_the_domain_bounds_the_points_of_a_witness():
    domain = Domain({"x": (sp.Rational(1, 2), sp.Rational(501, 1000))})
    witness = decide_equal(sp.sin(x), x, domain).witness
    assert sp.Rational(1, 2) < sp.Rational(witness.point["x"]) < sp.Rational(501, 1000)


def wrong_rows() -> list[str]:
    wrong = []
    for row in ROWS:
        try:
            if not isinstance(answer(row), KINDS[row.expected]):
                wrong.append(row.name)
        except DisagreementError:
            wrong.append(row.name)
    return wrong


def _forget_a_sign(self, one, other):
    (cosine, sine, denominator), (c, s, d) = one, other
    times = self.ring.times
    return times(cosine, c) + times(sine, s), times(cosine, s) + times(sine, c), denominator * d


def _always_plus(self, place):
    self.basis.signs[place] = self.basis.signs[place] or 1
    return self.ring.context.constant(1)


@pytest.mark.parametrize(
    ("owner", "name", "broken", "caught"),
    [
        pytest.param(
            angles.CircleChart, "_turn", _forget_a_sign, "cosine-of-sum", id="addition theorem"
        ),
        pytest.param(Extension, "_sign", _always_plus, "root-of-square", id="sign of a root"),
        pytest.param(
            quotient_ring.QuotientRing, "relate", lambda *_: None, "pythagoras", id="relations"
        ),
    ],
)
def test_the_table_fails_when_the_normal_form_is_broken(monkeypatch, owner, name, broken, caught):
    assert wrong_rows() == []
    monkeypatch.setattr(owner, name, broken)
    assert caught in wrong_rows()


FUNCTIONS = [f(k * s) for f in (sp.sin, sp.cos) for s in (x, y) for k in (1, 2)] + [x, z]


@st.composite
def polynomials(draw):
    terms = draw(
        st.lists(st.tuples(st.integers(-4, 4), *[st.integers(0, 9)] * 2), min_size=1, max_size=3)
    )
    return sp.Add(*(n * FUNCTIONS[i] * FUNCTIONS[j] for n, i, j in terms))


@settings(max_examples=60, deadline=None)
@given(polynomials(), polynomials())
def test_expanded_products_are_equal(p, q):
    assert isinstance(decide_equal(p * q, sp.expand(sp.expand_trig(p * q))), Proved)


@settings(max_examples=60, deadline=None)
@given(polynomials(), polynomials(), st.sampled_from(FUNCTIONS), st.integers(1, 10**9))
def test_a_small_perturbation_is_refuted(p, q, error, size):
    found = decide_equal(p * q, sp.expand(p * q) + error / size)
    assert isinstance(found, Refuted)
    point = found.witness.point
    gap = high_precision(
        p * q - sp.expand(p * q) - error / size, {n: point.get(n, "0") for n in "xyz"}
    )
    assert gap != 0


ATOMS = st.sampled_from(
    [
        x,
        y,
        sp.Integer(2),
        sp.Rational(-1, 3),
        sp.pi,
        sp.S.Zero,
        sp.sqrt(2),
        sp.Float(0.5),
        sp.I,
        sp.E,
    ]
)
WRAPPERS = [
    sp.sin,
    sp.tan,
    sp.sqrt,
    sp.Abs,
    sp.sign,
    sp.exp,
    sp.gamma,
    sp.floor,
    sp.atan,
    lambda e: e**-1,
    lambda e: e ** sp.Rational(1, 3),
]


def trees():
    return st.recursive(
        ATOMS,
        lambda inner: st.one_of(
            st.tuples(inner, inner).map(lambda p: p[0] + p[1]),
            st.tuples(inner, inner).map(lambda p: p[0] * p[1]),
            st.tuples(st.sampled_from(WRAPPERS), inner).map(lambda p: p[0](p[1])),
        ),
        max_leaves=8,
    )


@settings(max_examples=150, deadline=None)
@given(trees())
def test_no_formula_makes_it_raise(expression):
    found = decide_equal(expression, sp.S.Zero)
    assert isinstance(found, (Proved, Refuted, OnBranch, Undecided))


def test_sides_that_agree_where_a_factor_is_1_hold_in_no_part_of_the_domain():
    length = sp.Symbol("L", positive=True)
    root = sp.sqrt((x - y) ** 2 + (x - z) ** 2 + (y - z) ** 2) / sp.Abs(x + y + z)
    found = decide_equal(root, length * root)
    assert isinstance(found, Refuted)
    assert found.note == ""
