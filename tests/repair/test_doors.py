"""One code, two doors: a claim of a paper and a formula by itself are mended alike."""

import numpy as np
import pytest
from sympy import And, Integer, Or, cos, pi, sin, symbols

from omniproof.audit import check as alone
from omniproof.audit import mending
from omniproof.audit.check import Finding, check
from omniproof.audit.setting import Assumptions
from omniproof.decide.answer import Proved
from omniproof.registry import Ordered, Relation
from omniproof.repair.search import Search

a, b, x = symbols("a b x", real=True)

MISPRINTS = [
    pytest.param(r"\cos(a + b)", cos(a + b), r"\cos a\cos b + \sin a\sin b",
                 r"\cos a\cos b - \sin a\sin b", id="a sign between terms"),
    pytest.param(r"\sin(a - b)", sin(a - b), r"-\sin a\cos b - \cos a\sin b",
                 r"\sin a\cos b - \cos a\sin b", id="a sign before a term"),
    pytest.param(r"\sin 2x", sin(2 * x), r"2\sin x\sin x", r"2\cos x\sin x", id="a function"),
    pytest.param(r"\cos(a + b)", cos(a + b), r"\cos a\cos b - \sin a\sin a",
                 r"\cos a\cos b - \sin b\sin a", id="a letter"),
    pytest.param("(a + b)^2", (a + b) ** 2, "a^2 + 3ab + b^2", "a^2 + 2ab + b^2",
                 id="a coefficient"),
    pytest.param(r"\sin 2x", sin(2 * x), r"\sin x\cos x", r"2\sin x\cos x", id="a lost factor"),
    pytest.param(r"\sin^2 x", sin(x) ** 2, r"\frac{1 - \cos 4x}{2}",
                 r"\frac{1 - \cos 2x}{2}", id="a factor of an angle"),
]  # fmt: skip


@pytest.mark.parametrize(("left", "derived", "printed", "right"), MISPRINTS)
def test_a_misprint_is_mended_alike_by_the_same_engines(paper, left, derived, printed, right):
    judged, found = paper(printed, derived), check(f"{left} = {printed}")
    assert (judged.row.verdict, found.verdict) == ("erratum", Finding.ERRATUM)
    assert judged.row.correction == right
    assert f"{left} = {right}" in [edit.text for edit in found.repairs]
    engines = {edit.engines for edit in (*judged.mended.repairs, *found.repairs)}
    assert engines == {("flint", "modular", "z3")}


ORDERS = [
    pytest.param(r"\sin x > x", (x, sin(x)), {x: (Integer(0), pi / 2)}, r"0 < x < \frac{\pi}{2}",
                 r"\sin x < x", id="turned"),
]  # fmt: skip


@pytest.mark.parametrize(("printed", "terms", "box", "between", "right"), ORDERS)
def test_an_order_is_mended_alike(paper, printed, terms, box, between, right):
    judged = paper(printed, Relation(Ordered(terms, box)), form="chain")
    found = check(printed, Assumptions(between=(between,)))
    assert (judged.row.verdict, judged.row.repair) == ("erratum", "explained")
    assert judged.row.correction == found.repairs[0].text == right


def test_a_condition_is_mended(paper):
    same_sign = Or(And(a > 0, b > 0), And(a < 0, b < 0))
    judged = paper("a b < 0", Relation(same_sign), form="equivalent")
    assert (judged.row.verdict, judged.row.correction) == ("erratum", "a b > 0")


@pytest.mark.parametrize("door", ["paper", "alone"])
def test_direct_evaluation_is_asked_of_each_repair(paper, monkeypatch, door):
    """What the engines prove by mistake is stopped by the third voice, at either door."""

    decide = alone.confirmed_equal

    def believes(*sides, enough=None, **options):
        return Proved(("flint",)) if enough is None else decide(*sides, enough=enough)

    monkeypatch.setattr(Search, "is_right", lambda self, values, shape: np.ones(shape, bool))
    monkeypatch.setattr(mending, "equal_to_derived", lambda *_: Proved(("flint",)))
    monkeypatch.setattr(alone, "confirmed_equal", believes)
    with pytest.raises(RuntimeError, match="direct evaluation contradicts flint"):
        paper("x + a", x + b) if door == "paper" else check("x + a = x + b")
