"""Three-roller sphere, equations (5)-(10), all angles, speeds and the radius free.

Directly: the printed optimum with everything inserted satisfies the normal equations. In stages, as
one proves it on paper: each coefficient that (10) reads off from a few points is the coefficient of
d_i^2; with the coefficients as free symbols, the optimum (7)-(9) satisfies the normal equations,
and the least value is as printed.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from functools import cache
from typing import Any

import sympy as sp
from questions import ask

from corpus import load
from omniproof.decide import zero_test
from omniproof.decide.answer import Answer, Proved
from omniproof.decide.in_sympy.equality import decide_equal
from omniproof.formula.sympy_terms import term_of
from omniproof.formula.term import Term, substitute
from omniproof.transcription.symbols import symbol_name

RADIUS = sp.Symbol("r", positive=True)
SPEEDS = sp.symbols("v_1:4", real=True)
LONGITUDES = sp.symbols("theta_(1:2)(1:4)", real=True)
LATITUDES = sp.symbols("theta_(2:3)(1:4)", real=True)
TURNS = sp.symbols("psi_1:4", real=True)
POINT = sp.symbols("x y z", real=True)
STAGES = ("elimination-x", "elimination-y", "elimination-z", "elimination-minimum")
Pair = tuple[sp.Expr, sp.Expr]


@cache
def axis_and_contact(roller: int) -> tuple[sp.Matrix, sp.Matrix]:
    """Return the axis (3)-(4) and the contact point of a roller, as columns."""
    one, two, turn = LONGITUDES[roller], LATITUDES[roller], TURNS[roller]
    along = sp.Matrix([-sp.sin(one), sp.cos(one), 0])
    up = sp.Matrix([-sp.sin(two) * sp.cos(one), -sp.sin(two) * sp.sin(one), sp.cos(two)])
    contact = sp.Matrix([sp.cos(two) * sp.cos(one), sp.cos(two) * sp.sin(one), sp.sin(two)])
    return along * sp.cos(turn) + up * sp.sin(turn), RADIUS * contact


def squared_distance(roller: int, point: Iterable[Any]) -> sp.Expr:
    """Return d_i^2 by (6)."""
    place = sp.Matrix(list(point))
    axis, contact = axis_and_contact(roller)
    gap = -SPEEDS[roller] / RADIUS * axis + contact.dot(place) / RADIUS**2 * contact - place
    return gap.dot(gap)


def read_off(distance: Callable[..., sp.Expr]) -> dict[str, sp.Expr]:
    """Return C_1 to C_10 by (10) of a function of three coordinates."""
    at = distance
    centre = at(0, 0, 0)
    ends = [
        (at(1, 0, 0), at(-1, 0, 0)), (at(0, 1, 0), at(0, -1, 0)), (at(0, 0, 1), at(0, 0, -1)),
    ]  # fmt: skip
    found = {f"C_{k + 1}": (a + b - 2 * centre) / 2 for k, (a, b) in enumerate(ends)}
    found |= {f"C_{k + 7}": (a - b) / 2 for k, (a, b) in enumerate(ends)}
    found["C_4"] = (at(1, 1, 0) - at(-1, 1, 0) - at(1, -1, 0) + at(-1, -1, 0)) / 4
    found["C_5"] = (at(0, 1, 1) - at(0, -1, 1) - at(0, 1, -1) + at(0, -1, -1)) / 4
    found["C_6"] = (at(1, 0, 1) - at(1, 0, -1) - at(-1, 0, 1) + at(-1, 0, -1)) / 4
    return found | {"C_{10}": centre}


def expected(roller: int) -> dict[str, sp.Expr]:
    """Return the coefficients of d_i^2 = |Q|^2 - <P,Q>^2/r^2 + 2v/r <eta,Q> + v^2/r^2."""
    axis, contact = axis_and_contact(roller)
    normal, speed = contact / RADIUS, SPEEDS[roller] / RADIUS
    squares = {f"C_{k + 1}": 1 - normal[k] ** 2 for k in range(3)}
    linear = {f"C_{k + 7}": 2 * speed * axis[k] for k in range(3)}
    mixed = {"C_4": (0, 1), "C_5": (1, 2), "C_6": (0, 2)}
    products = {name: -2 * normal[i] * normal[j] for name, (i, j) in mixed.items()}
    return squares | linear | products | {"C_{10}": speed**2}


def coefficients() -> dict[str, sp.Expr]:
    """Return C_1 to C_10 of the sum (5) as derived."""
    parts = [expected(roller) for roller in range(3)]
    return {name: sum(part[name] for part in parts) for name in parts[0]}


def staged() -> list[Pair]:
    """Return all lemmas: ten coefficients, the normal equations, the least value.

    The coefficients are proved for one roller: the others are instances, and (10) is linear in L.
    """
    printed = read_off(lambda *point: squared_distance(0, point))
    lemmas = [(printed[name], derived) for name, derived in expected(0).items()]
    records = {record.id: record for record in load()}
    return lemmas + [pair for name in STAGES for pair in ask(records[name]).pairs]


def direct() -> list[tuple[Term, Term]]:
    """Return the three normal equations at the printed optimum, everything put in as it is."""
    values = {symbol_name(name): term_of(value) for name, value in coefficients().items()}
    records = {record.id: record for record in load()}
    pairs = [pair for name in STAGES[:3] for pair in ask(records[name]).pairs]
    return [(substitute(term_of(left), values), term_of(right)) for left, right in pairs]


def answers() -> dict[str, Callable[[], list[Answer]]]:
    """Return what is to be decided, in stages and directly."""
    lemmas, equations = staged(), direct()
    return {
        "staged": lambda: [decide_equal(left, right) for left, right in lemmas],
        "direct": lambda: [zero_test.decide_equal(left, right) for left, right in equations],
    }


def elimination_times() -> dict[str, dict[str, str | float]]:
    """Return what is said of the elimination, in stages and directly, and the seconds it takes."""
    found: dict[str, dict[str, str | float]] = {}
    for name, decide in answers().items():
        start = time.process_time()
        said = decide()
        seconds = round(time.process_time() - start, 3)
        open_ones = [answer for answer in said if not isinstance(answer, Proved)]
        result = str(open_ones[0]) if open_ones else "proved"
        found[name] = {"questions": len(said), "said": result, "seconds": seconds}
    return found
