"""Global extrema over a box, proved together with where they are attained.

A claim about f = N/D is brought to the form "h is positive except at known zeros", which
`positivity` proves: f >= m with equality at the candidates only is h = N - m D where D > 0. So
poles at the border (D = 0 there) are no trouble: h is regular, and the sign of D inside is a
question of its own. Questions of sign and concavity are in `signs`.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from typing import Any, assert_never

import sympy as sp

from omniproof.audit.answer import Answer, Proved, Refuted, Undecided, Witness
from omniproof.audit.balls import exact_number
from omniproof.audit.exact import subtract, vanishes
from omniproof.audit.ordering import digits
from omniproof.audit.positivity import Negative, Open, Positive, prove_positive
from omniproof.audit.quotient import Family, Quotient
from omniproof.audit.sign_chart import recognise
from omniproof.audit.signs import concave, denominator_sign, guarded, sign_on

__all__ = ["concave", "prove_extremum", "sign_on"]

ENGINE = ("flint",)
DIRECTION = {"minimum": 1, "maximum": -1}

Points = Sequence[tuple[Any, ...]]


def prove_extremum(family: Family, candidates: Points, kind: str) -> Answer:
    """Decide whether the global minimum or maximum is attained at the candidates, and only there.

    `candidates` are exact points, coordinates in the order of the box; `kind` is "minimum" or
    "maximum". A witness shows the candidates' value (printed) beside a better one (derived), or an
    equal one at another point. Never raises for a family: what is not decided is `Undecided`.
    """
    return guarded(lambda: _extremum(Quotient.of(family), candidates, DIRECTION[kind]))


def _extremum(function: Quotient, candidates: Points, direction: int) -> Answer:
    candidates = [tuple(exact_number(x) for x in point) for point in candidates]
    best = function.at(candidates[0])
    for point in candidates:
        value = function.at(point)
        if not function.box.contains(point):
            witness = Witness(function.name(point), digits(value), "undefined")
            return Refuted(ENGINE, witness, "the point is not inside of the box")
        if not vanishes(subtract(value, best)):
            witness = Witness(function.name(point), digits(best), digits(value))
            return Refuted(ENGINE, witness, "the points do not have the same value")
    better = function.find(subtract(function.value, best), -direction)
    if better is not None:
        return _refuted(function, better, best)
    sign = direction * denominator_sign(function)
    above = sign * (function.numerator - best * function.denominator)
    outcome = prove_positive(above, function.box, candidates)
    match outcome:
        case Positive():
            return Proved(ENGINE)
        case Negative():
            return _refuted(function, outcome.point, best)
        case Open():
            return _not_proved(function, outcome, candidates, best)
        case _ as never:
            assert_never(never)


def _refuted(function: Quotient, point: tuple[Any, ...], best: sp.Expr) -> Refuted:
    return Refuted(ENGINE, Witness(function.name(point), digits(best), function.digits(point)))


def _not_proved(function: Quotient, stuck: Open, candidates: Points, best: sp.Expr) -> Answer:
    """Look for a further point with exactly the best value where the proof got stuck."""
    for place in stuck.places:
        for point in product(*(recognise(x, 1e-5, 24) for x in place)):
            if point in candidates:
                continue
            if function.box.contains(point) and vanishes(subtract(function.at(point), best)):
                witness = Witness(function.name(point), digits(best), digits(best))
                return Refuted(ENGINE, witness, "the same value is attained there")
    return Undecided(f"no proof that it is the extremum: {stuck.reason}", ENGINE)
