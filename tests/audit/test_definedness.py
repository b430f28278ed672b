"""An identity is asserted where its printed roots are defined, also those that cancel."""

import pytest

from omniproof.audit.check import Finding, check
from omniproof.audit.setting import Assumptions

TRUE = Finding.VERIFIED
FALSE = Finding.ERRATUM


@pytest.mark.parametrize(
    ("statement", "verdict"),
    [
        pytest.param(r"(\sqrt{x})^2 = |x|", TRUE, id="squared: defined for x >= 0 only"),
        pytest.param(r"\sqrt{x}\sqrt{x} = |x|", TRUE, id="times itself"),
        pytest.param(r"\frac{(\sqrt{a - b})^2}{2} = \frac{|a - b|}{2}", TRUE, id="a difference"),
        pytest.param(r"(\sqrt{-x})^2 = |x|", TRUE, id="defined for x <= 0 only"),
        pytest.param(r"(\sqrt{x})^2 = -|x|", FALSE, id="false where it is defined"),
        pytest.param(r"(\sqrt{x})^2 = x^2", FALSE, id="false for most x"),
        pytest.param(r"(\sqrt{x^2 + 1})^2 = x^2 + 1", TRUE, id="never negative"),
        pytest.param(r"x = |x|", Finding.CONDITIONAL, id="without a root nothing is presumed"),
        pytest.param(r"\sqrt{x^2} = x", Finding.CONDITIONAL, id="the root of a square is kept"),
    ],
)
def test_identities_with_roots_that_cancel(statement, verdict):
    assert check(statement).verdict is verdict


def test_a_root_that_is_defined_nowhere_proves_nothing():
    assert check(r"(\sqrt{x})^2 = x", Assumptions(between=("x < 0",))).verdict is Finding.UNDECIDED


def test_conditions_without_an_interior_prove_nothing():
    assumptions = Assumptions(between=("0 < x",))
    assert check(r"(\sqrt{-x})^2 = 5", assumptions).verdict is Finding.UNDECIDED
