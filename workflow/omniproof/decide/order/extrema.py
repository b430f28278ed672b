"""Global extrema over a box, proved together with where they are attained.

A claim about f = N/D is brought to the form "h is positive except at known zeros", which
`positivity` proves: f >= m with equality at the candidates only is h = N - m D where D > 0. So
poles at the border (D = 0 there) are no trouble: h is regular, and the sign of D inside is a
question of its own. Questions of sign and concavity are in `signs`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import product
from typing import Any, assert_never

import sympy as sp

from omniproof.decide.answer import Answer, Proved, Refuted, Undecided
from omniproof.decide.balls import enclose, format_ball
from omniproof.decide.exact import sign
from omniproof.decide.in_sympy.balls import exact_number
from omniproof.decide.in_sympy.exact import subtract, vanishes
from omniproof.decide.order.box import Box
from omniproof.decide.order.positivity import Negative, Open, Positive, prove_positive
from omniproof.decide.order.quotient import Family, OnBox, Quotient
from omniproof.decide.order.sign_chart import recognise
from omniproof.decide.order.signs import (
    OPEN,
    Closed,
    concave,
    denominator_sign,
    faces,
    guarded,
    of_number,
    on_face,
    sign_on,
)
from omniproof.formula.sympy_terms import term_of
from omniproof.formula.term import Term, multiply, number
from omniproof.formula.term import subtract as difference_of

__all__ = ["concave", "prove_extremum", "sign_on"]

ENGINE = ("flint",)
DIRECTION = {"minimum": 1, "maximum": -1}

Points = Sequence[tuple[Any, ...]]


def prove_extremum(family: Family, candidates: Points, kind: str, closed: Closed = OPEN) -> Answer:
    """Decide whether the global minimum or maximum is attained at the candidates, and only there.

    Sides of the box are open, but for ends that are `closed`. `candidates` are exact points,
    coordinates in the order of the box; `kind` is "minimum" or "maximum". A witness shows the
    candidates' value (printed) beside a better one (derived), or an equal one at another point.
    Never raises for a family: what is not decided is `Undecided`.
    """
    return guarded(lambda: _extremum(family, candidates, DIRECTION[kind], closed))


def _extremum(family: Family, candidates: Points, direction: int, closed: Closed) -> Answer:
    function = Quotient.of(family)
    ends = [closed.get(symbol, (False, False)) for symbol in family.box]
    candidates = [tuple(exact_number(x) for x in point) for point in candidates]
    best = function.value_at(candidates[0])
    for point in candidates:
        value = function.value_at(point)
        if not function.box.contains(point, ends):
            witness = function.witness(point, _digits(value), "undefined")
            return Refuted(ENGINE, witness, "the point is not inside of the box")
        if sign(difference_of(value, best)) != 0:
            witness = function.witness(point, _digits(best), _digits(value))
            return Refuted(ENGINE, witness, "the points do not have the same value")
    better = function.find(difference_of(function.term, best), -direction)
    if better is not None:
        return _refuted(function, better, best)
    above, below = term_of(function.numerator), term_of(function.denominator)
    factor = number(direction * denominator_sign(function))
    outcome = prove_positive(
        multiply(factor, difference_of(above, multiply(best, below))), function.box, candidates
    )
    match outcome:
        case Positive():
            return _not_on_faces(family, candidates, direction, closed) or Proved(ENGINE)
        case Negative():
            return _refuted(function, outcome.point, best)
        case Open():
            return _not_proved(function, outcome, (candidates, ends), best)
        case _ as never:
            assert_never(never)


def _digits(value: Term) -> str:
    return format_ball(enclose(value), 6)


def _not_on_faces(
    family: Family, candidates: Points, direction: int, closed: Closed
) -> Answer | None:
    """Return why a point of a closed face is as good as the candidates; None where none is."""
    best = family.expression.subs(dict(zip(family.box, candidates[0], strict=True)))
    for at, rest in faces(family.box, closed):
        own = _lying_on(family, candidates, at)
        value = family.expression.subs(at)
        # A corner that is a candidate itself is no better than the candidates.
        if value.has(sp.nan, sp.zoo, sp.oo, -sp.oo) or (own and not rest):
            continue
        inner = [tuple(point[symbol] for symbol in rest) for point in own]
        inner = [point for point in inner if Box.of(rest).contains(point)]
        if inner:
            answer = _extremum(OnBox(value, rest), inner, direction, OPEN)
        else:
            answer = _worse(OnBox(direction * subtract(value, best), rest))
        if not isinstance(answer, Proved):
            return on_face(answer, at)
    return None


def _lying_on(
    family: Family, candidates: Points, at: Mapping[sp.Symbol, Any]
) -> list[dict[sp.Symbol, Any]]:
    """Return the candidates that lie on the face where some symbols have these values."""
    points = [dict(zip(family.box, point, strict=True)) for point in candidates]
    return [p for p in points if all(vanishes(subtract(p[s], end)) for s, end in at.items())]


def _worse(lead: OnBox) -> Answer:
    return sign_on(lead, 1) if lead.box else of_number(term_of(lead.expression), 1)


def _refuted(function: Quotient, point: tuple[Any, ...], best: Term) -> Refuted:
    return Refuted(ENGINE, function.witness(point, _digits(best), function.digits(point)))


def _not_proved(
    function: Quotient,
    stuck: Open,
    known: tuple[Points, Sequence[tuple[bool, bool]]],
    best: Term,
) -> Answer:
    """Look for a further point with exactly the best value where the proof got stuck."""
    candidates, ends = known
    for place in stuck.places:
        for point in product(*(recognise(x, 1e-5, 24) for x in place)):
            if point in candidates:
                continue
            excess = difference_of(function.value_at(point), best)
            if function.box.contains(point, ends) and sign(excess) == 0:
                witness = function.witness(point, _digits(best), _digits(best))
                return Refuted(ENGINE, witness, "the same value is attained there")
    return Undecided(f"no proof that it is the extremum: {stuck.reason}", ENGINE)
