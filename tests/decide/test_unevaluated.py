"""Every engine on terms as they are printed, which SymPy has never seen."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import pytest

from omniproof.decide.balls import enclose
from omniproof.decide.normal_form.form import normal_form
from omniproof.decide.prime_fields.zero import NonZero, Zero, vanishes
from omniproof.formula.term import Symbol, Term, subtract
from omniproof.formula.unfold import unfold
from omniproof.transcription.reader import read

PRINTED = [
    pytest.param(r"\frac{x^4}{x^2}", "x^2", True, id="a quotient that cancels"),
    pytest.param(r"\frac{1}{\frac{1}{x}}", "x", True, id="nested fractions"),
    pytest.param("x - x + y", "y", True, id="terms that cancel"),
    pytest.param(r"(\sqrt{x^2 + y^2})^2", "y^2 + x^2", True, id="the square of a root"),
    pytest.param(r"\sin(\arccos x)", r"\sqrt{1 - x^2}", True, id="the sine of an arc cosine"),
    pytest.param(r"\cos(2\arctan x)", r"\frac{1 - x^2}{1 + x^2}", True, id="a double angle"),
    pytest.param(r"\tan(y + \arctan x)", r"\frac{\tan y + x}{1 - x\tan y}", True, id="a sum"),
    pytest.param(r"\sin(\arcsin x)", "x", True, id="a function and its inverse"),
    pytest.param(r"\cos(\pi - x)", r"-\cos x", True, id="half a turn"),
    pytest.param(r"\sin 405^\circ", r"\frac{1}{\sqrt{2}}", True, id="more than a turn"),
    pytest.param(r"\sqrt{8}", r"2\sqrt{2}", True, id="roots of numbers"),
    pytest.param(r"\begin{pmatrix} x & 1 \\ 0 & y \end{pmatrix}^{-1}\begin{pmatrix} x \\ 0"
                 r"\end{pmatrix}\cdot(1, 0)", "1", True, id="an inverse matrix"),
    pytest.param(r"\sin(\arccos x)", r"\sqrt{1 + x^2}", False, id="a wrong sign"),
    pytest.param(r"\sin\left(\arccos\left(1 - \frac{\sqrt{2}}{10000000}\right)\right)", "0",
                 False, id="what two digits take for zero"),
    pytest.param(r"\frac{x^4}{x^2}", "x^3", False, id="a wrong power"),
]  # fmt: skip


def sides(left: str, right: str) -> tuple[Term, Term]:
    names = {"x": Symbol("x"), "y": Symbol("y")}
    one, other = (unfold(read(text), names, text) for text in (left, right))
    return one, other


def by_normal_form(left: Term, right: Term) -> bool:
    return normal_form(left, right).is_zero


def by_prime_fields(left: Term, right: Term) -> bool:
    found = vanishes(subtract(left, right))
    assert isinstance(found, Zero | NonZero)
    return isinstance(found, Zero)


def by_balls(left: Term, right: Term) -> bool:
    """Whether no point shows a difference, to 60 digits."""
    places = [{"x": x, "y": y} for x in (1, -1) for y in (2, 3)]
    tenths = [{name: Fraction(n, 10) for name, n in place.items()} for place in places]
    return all(enclose(subtract(left, right), place, 240).contains(0) for place in tenths)


@pytest.mark.parametrize("decides", [by_normal_form, by_prime_fields, by_balls])
@pytest.mark.parametrize(("left", "right", "equal"), PRINTED)
def test_every_engine_decides_what_is_printed(
    decides: Callable[[Term, Term], bool], left: str, right: str, equal: bool
) -> None:
    assert decides(*sides(left, right)) is equal
