"""The importable formulas say the same as the corrections of the ledger, and none is missing.

What a correction says is read by our reader of LaTeX and evaluated by SymPy or mpmath at a point;
what a function says is what NumPy makes of the derivation. Both have to agree.
"""

from __future__ import annotations

import inspect
import re
from pathlib import Path
from random import Random
from typing import Any

import mpmath
import numpy as np
import pytest
from audited import audited_once
from numpy.testing import assert_allclose
from sympy import Abs, atan2, lambdify
from sympy.core.function import AppliedUndef

from omniproof.audit.context import Context
from omniproof.audit.ledger import Ledger, Row, Verdict
from omniproof.audit.run import prepare
from omniproof.corrected import FUNCTIONS, omni_trajectory, two_roller_sphere
from omniproof.transcription.ids import base, index
from omniproof.transcription.model import Kind, Source

Point = dict[str, Any]

ATAN2 = re.compile(r"\\operatorname\{atan\}_\{2\}\{\\left\((.*),(.*) \\right\)\}")
"""How SymPy writes what papers do not print and our reader of papers does not read."""

RENAMED = {
    "v_x_B": "v_x",
    "d_x_B": "d_x",
    "d_y_B": "d_y",
    "delta_z_B": "delta_z",
    "X_m": "x_velocity",
    "Y_m": "y_velocity",
    "nu_i": "nu",
}
"""Symbol of a ledger -> argument of a function."""

APART = {"eq:8", "eq:9", "eq:26"}
"""Formulas with a test of their own: two are integrals, one says more than its last side, 0."""


def faulty(ledger: Ledger) -> list[Row]:
    """Formulas that are not right as printed, where the source is clear."""
    return [
        row
        for row in ledger.rows
        if row.kind is Kind.IDENTITY and row.verdict.is_fault and row.source is Source.CLEAR
    ]


def comparable(ledger: Ledger) -> list[Row]:
    """Those of them with a function of their own, and no test of their own."""
    return [row for row in faulty(ledger) if base(row.id) in FUNCTIONS[ledger.paper].keys() - APART]


def right_side(text: str, claim: str, context: Context) -> Any:
    """Return the last side of a formula as an expression."""
    if found := ATAN2.fullmatch(text):
        return atan2(*(context.value(argument, claim) for argument in found.groups()))
    value = context.value(text, claim)
    return value[-1] if isinstance(value, tuple) else value


def corrected(row: Row, context: Context) -> Any:
    """Return what a row should say; a conditional one is right where it is positive."""
    claim = base(row.id)
    if row.verdict is Verdict.CONDITIONAL:
        return Abs(right_side(row.printed, claim, context))
    return right_side(row.correction, claim, context)


def arguments(function: Any, point: Point) -> Point:
    """Return the values that a function takes, of those at a point."""
    names = inspect.signature(function).parameters
    if "columns" in names:
        edges = [[point[f"a_{i}{k}"] for k in (1, 2, 3)] for i in (1, 2, 3)]
        return {"columns": np.array(edges)}
    return {name: point[name] for name in names}


class RandomPoint(dict[str, Any]):
    """A number for every name that is asked for, the same whenever it is asked for again."""

    def __init__(self) -> None:
        super().__init__()
        self._random = Random(7)

    def __missing__(self, name: str) -> float:
        self[name] = self._random.uniform(0.2, 1.2)
        return float(self[name])


@pytest.fixture(scope="module", params=sorted(FUNCTIONS))
def ledger(request: pytest.FixtureRequest, root: Path) -> Ledger:
    return audited_once(root / "paper_data" / request.param)


def test_every_false_formula_has_a_function(ledger: Ledger) -> None:
    functions = FUNCTIONS[ledger.paper].keys()
    lacking = {base(row.id) for row in faulty(ledger)} - functions
    # A column of a matrix with a function repeats its misprint.
    repeated = {base(row.id) for row in faulty(ledger) if base(row.follows) in functions}
    assert lacking <= repeated


def test_no_function_stands_for_a_sound_formula(ledger: Ledger) -> None:
    assert FUNCTIONS[ledger.paper].keys() <= {base(row.id) for row in faulty(ledger)}


def test_functions_equal_the_corrections_of_the_ledger(ledger: Ledger, root: Path) -> None:
    context = prepare(root / "paper_data" / ledger.paper)
    rows = comparable(ledger)
    assert {base(row.id) for row in rows} == FUNCTIONS[ledger.paper].keys() - APART
    for row in rows:
        function, point = FUNCTIONS[ledger.paper][base(row.id)], RandomPoint()
        right = corrected(row, context)
        values = {s: point[RENAMED.get(str(s), str(s))] for s in right.free_symbols}
        place = tuple(int(part) - 1 for part in index(row.id))
        found = function(**arguments(function, point))[place]
        assert_allclose(found, float(right.subs(values)), err_msg=row.id)


def correction(paper: str, claim: str, root: Path) -> tuple[str, Context]:
    """Return the correction of one claim, with what is needed to read it."""
    rows = audited_once(root / "paper_data" / paper).rows
    (text,) = (row.correction for row in rows if row.id == claim)
    return text, prepare(root / "paper_data" / paper)


SPEEDS = {"v_1": (0.3, 0.2), "v_2": (-0.1, 0.5), "v_3": (0.4, -0.3)}
"""Speeds of the rollers that rise or fall in proportion to time: at 0, and in a second."""


def speed(of: AppliedUndef, time: Any) -> Any:
    """Return a speed at a time."""
    start, rise = SPEEDS[str(of.func)]
    return start + rise * time


@pytest.mark.parametrize(
    ("claim", "function"),
    [
        pytest.param("eq:8", omni_trajectory.path_x, id="first coordinate"),
        pytest.param("eq:9", omni_trajectory.path_y, id="second coordinate"),
    ],
)
def test_paths_equal_the_corrected_integrals(claim: str, function: Any, root: Path) -> None:
    text, context = correction("omni-trajectory", claim, root)
    length, end = 0.2, 1.5
    factor, outer = context.value(text, claim).as_coeff_Mul()
    time = outer.limits[0][0]
    known = outer.function.replace(
        lambda part: isinstance(part, AppliedUndef), lambda part: speed(part, part.args[0])
    ).doit()
    (L,) = known.free_symbols - {time}
    integrand = lambdify(time, known.subs(L, length), "mpmath")
    expected = float(factor * mpmath.quad(integrand, [0, end]))
    at = np.linspace(0, end, 20001)
    samples = [start + rise * at for start, rise in SPEEDS.values()]
    assert_allclose(function(at, *samples, length)[-1], expected, rtol=1e-6)


def test_slip_along_the_normal_equals_both_sides_of_the_corrected_equation(root: Path) -> None:
    """For any spin; the sides after them are 0, for the spin that the paper chooses."""
    text, context = correction("two-roller-sphere", "eq:26", root)
    values = {"w_2": 0.7, "w_3": -0.4, "nu_i": 0.3, "alpha_i": 0.5, "r": 0.2}
    found = two_roller_sphere.slip_along_normal(0.7, 0.3, 0.5, 0.2)
    for side in text.split("=")[:2]:
        slip = context.value(side, "eq:23")  # where the spin is any
        at = {symbol: values[str(symbol)] for symbol in slip.free_symbols}
        assert_allclose(found, float(slip.subs(at)))
    chosen = context.value(text, "eq:26")
    assert set(chosen) == {0}
    # That spin has -nu cos(alpha) / r along the tangent.
    assert_allclose(
        two_roller_sphere.slip_along_normal(-0.3 * np.cos(0.5) / 0.2, 0.3, 0.5, 0.2), 0, atol=1e-15
    )
