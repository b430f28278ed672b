"""Printed inputs carried into an output, by hand on small functions."""

import pytest
import sympy as sp

from omniproof.audit.answer import Undecided
from omniproof.audit.propagation import Reach, propagate
from omniproof.audit.ranges import Reading, stands_for

V, r, x = sp.symbols("V r x", real=True)
RPM = 30 * V / (sp.pi * r)
ROUNDED, TRUNCATED, EITHER = Reading.ROUNDED, Reading.TRUNCATED, Reading.EITHER


@pytest.mark.parametrize(
    ("value", "inputs", "printed", "readings", "reach"),
    [
        # x in [1.95, 2.05]: all of them print 2.0, none of 2 x in [3.9, 4.1] need print 4.0
        pytest.param(x, {x: "2.0"}, "2.0", (ROUNDED, ROUNDED), Reach.CERTAIN, id="same"),
        pytest.param(2 * x, {x: "2.0"}, "4.0", (ROUNDED, ROUNDED), Reach.POSSIBLE, id="doubled"),
        # 2 x in [3.9, 4.1] and [4.1, 4.2): 4.1 is common; x < 2.05 would leave nothing
        pytest.param(2 * x, {x: "2.0"}, "4.1", (ROUNDED, TRUNCATED), Reach.POSSIBLE, id="touch"),
        # x in [2.0, 2.1), 2 x in [4.0, 4.2), against [4.2, 4.3)
        pytest.param(2 * x, {x: "2.0"}, "4.2", (TRUNCATED, TRUNCATED), Reach.EXCLUDED, id="miss"),
        pytest.param(-x, {x: "2.0"}, "-2.0", (TRUNCATED, TRUNCATED), Reach.CERTAIN, id="falling"),
        # x (1 - x) on [0.45, 0.55] is [0.2475, 0.25]
        pytest.param(x * (1 - x), {x: "0.5"}, "0.25", (ROUNDED, ROUNDED), Reach.CERTAIN, id="hump"),
        pytest.param(
            x * (1 - x), {x: "0.5"}, "0.24", (ROUNDED, ROUNDED), Reach.EXCLUDED, id="hump above"
        ),
        pytest.param(
            x * (1 - x), {x: "0.5"}, "0.26", (ROUNDED, ROUNDED), Reach.EXCLUDED, id="hump below"
        ),
        pytest.param(
            x * (1 - x), {x: "0.5"}, "0.249", (ROUNDED, ROUNDED), Reach.POSSIBLE, id="part of it"
        ),
        # 30/pi * [0.0215, 0.023) / [0.0225, 0.024) is within (8.5, 9.8)
        pytest.param(
            RPM, {V: "0.022", r: "0.023"}, "20.8", (EITHER, EITHER), Reach.EXCLUDED, id="0.022"
        ),
        # 30/pi * [0.0495, 0.0505] / [0.0225, 0.0235] is about [20.1, 21.5]
        pytest.param(
            RPM, {V: "0.050", r: "0.023"}, "20.8", (ROUNDED, ROUNDED), Reach.POSSIBLE, id="0.050"
        ),
        pytest.param(sp.pi + 0 * x, {x: "1"}, "3.1", (ROUNDED, ROUNDED), Reach.CERTAIN, id="fixed"),
    ],
)
def test_reach(value, inputs, printed, readings, reach):
    of_input, of_output = readings
    intervals = {symbol: stands_for(text, of_input) for symbol, text in inputs.items()}
    assert propagate(value, intervals, stands_for(printed, of_output)) == reach


@pytest.mark.parametrize(
    ("value", "reason"),
    [
        pytest.param(1 / x, "it may have a pole or a kink in the range of x", id="pole"),
        pytest.param(sp.Abs(x), "it may have a pole or a kink in the range of x", id="kink"),
        pytest.param(x * V, "the symbol V has no value", id="another symbol"),
    ],
)
def test_what_is_not_decided(value, reason):
    answer = propagate(value, {x: stands_for("0.0", ROUNDED)}, stands_for("1", ROUNDED))
    assert isinstance(answer, Undecided)
    assert answer.reason == reason


def test_an_input_without_influence_does_not_matter():
    """2 x in [3.9, 4.1] reaches 4.1, although r in [2, 3) does not reach 3."""
    inputs = {x: stands_for("2.0", ROUNDED), r: stands_for("2", TRUNCATED)}
    assert propagate(2 * x, inputs, stands_for("4.1", TRUNCATED)) == Reach.POSSIBLE


@pytest.mark.parametrize(
    ("printed", "reading", "reason"),
    [
        pytest.param("0.25", TRUNCATED, "it is nearly zero", id="one point of [0.25, 0.26)"),
        pytest.param(
            "0.2", ROUNDED, "it reaches a bound without passing it", id="all within [0.15, 0.25]"
        ),
    ],
)
def test_a_bound_that_is_reached_inside_only_is_not_decided(printed, reading, reason):
    """x (1 - x) <= 1/4 with equality at 1/2."""
    inputs = {x: stands_for("0.5", ROUNDED)}
    answer = propagate(x * (1 - x), inputs, stands_for(printed, reading))
    assert isinstance(answer, Undecided)
    assert answer.reason == reason
