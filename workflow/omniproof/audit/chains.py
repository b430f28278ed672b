"""Inequality chains a < b < c on a box: the sign of each difference, and the set where one fails.

With one variable the sets where the links hold are known exactly; the chain holds in what they have
in common, and fails in the rest of the box, points at which a term is not defined apart.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import pairwise
from typing import Any

import sympy as sp

from omniproof.decide.answer import Answer, OnBranch, Proved, Refuted, Undecided
from omniproof.decide.in_sympy.exact import subtract
from omniproof.decide.order.evident import is_evident
from omniproof.decide.order.intervals import Piece, condition_latex, in_degrees
from omniproof.decide.order.quotient import OnBox, Quotient
from omniproof.decide.order.signs import OPEN, Closed, guarded, sign_on
from omniproof.formula.sympy_terms import assumed_signs, term_of
from omniproof.registry import Ordered

ENGINE = ("flint",)
LONGEST = 300


def holds(chain: Ordered, closed: Closed = OPEN) -> Answer:
    """Decide whether each term is less than the next one at every point of the box.

    Sides of the box are open, but for ends that are `closed`.

    With one variable, a chain that holds in parts is `OnBranch` with the exact set; the note gives
    the set where it fails. Never raises for a chain: what is not decided is `Undecided`.
    """
    if len(chain.terms) < 2:
        return Undecided("one term is compared with nothing")
    links = [
        (_order(OnBox(subtract(right, left), chain.box), closed), left, right)
        for left, right in pairwise(_without_bars(chain.terms))
    ]
    if all(isinstance(answer, Proved) for answer, _, _ in links):
        return Proved(ENGINE)
    for answer, left, right in links:
        if isinstance(answer, Refuted) or (isinstance(answer, OnBranch) and len(chain.box) > 1):
            where = "never" if len(chain.box) == 1 and not answer.note else "not always"
            link = f"${sp.latex(left)} < {sp.latex(right)}$"
            shown = link if len(link) < LONGEST else "a link"
            return Refuted(ENGINE, answer.witness, f"{shown} holds {where}")
    for answer, _, _ in links:
        if isinstance(answer, Undecided):
            return answer
    parts = [answer for answer, _, _ in links if isinstance(answer, OnBranch)]
    return _in_parts(parts, chain, closed)


def _without_bars(terms: tuple[sp.Expr, ...]) -> tuple[sp.Expr, ...]:
    """Square absolute values: that keeps their order, and leaves no kinks."""
    if any(term.has(sp.Abs) for term in terms) and all(map(_is_nonnegative, terms)):
        return tuple(term**2 for term in terms)
    return terms


def _is_nonnegative(term: sp.Expr) -> bool:
    return is_evident(term_of(term), "\\geq", assumed_signs(term))


def _order(difference: OnBox, closed: Closed) -> Answer:
    """Decide where a difference is positive; a point where it is negative refutes in any case."""
    answer = sign_on(difference, 1, closed=closed)
    if not isinstance(answer, Undecided):
        return answer
    return guarded(lambda: _counterexample(Quotient.of(difference), answer))


def _counterexample(function: Quotient, otherwise: Undecided) -> Answer:
    wrong = function.find(function.term, -1)
    if wrong is None:
        return otherwise
    witness = function.witness(wrong, "> 0", function.digits(wrong))
    return Refuted(ENGINE, witness, otherwise.reason)


def _in_parts(answers: list[OnBranch], chain: Ordered, closed: Closed) -> Answer:
    ((symbol, (lower, upper)),) = chain.box.items()
    left, right = closed.get(symbol, (False, False))
    kept = sp.Intersection(*(_as_set(answer.relations[0]) for answer in answers))
    if kept is sp.S.EmptySet:
        return Refuted(ENGINE, answers[0].witness, "its links hold nowhere together")
    poles = [end for end in _ends(kept) if not _defined(chain.terms, symbol, end)]
    lost = sp.Interval(lower, upper, not left, not right) - kept - sp.FiniteSet(*poles)
    pieces = tuple(_pieces(kept))
    note = f"it fails for {_written(symbol, lost)}"
    condition = condition_latex(symbol, pieces)
    relation = sp.Or(*(piece.relation(symbol) for piece in pieces))
    return OnBranch(ENGINE, condition, answers[0].witness, note, (relation,))


def _as_set(condition: sp.Basic) -> sp.Set:
    """Read intervals off a condition; SymPy's own `as_set` looks for periods, which takes long."""
    parts = condition.args if isinstance(condition, sp.Or) else (condition,)
    return sp.Union(*(_interval(part.args) for part in parts))


def _interval(bounds: Iterable[Any]) -> sp.Interval:
    """Read `lower < x` and `x <= upper`, in any order."""
    low, high = sorted(bounds, key=lambda bound: bool(bound.lts.free_symbols))
    strict = sp.StrictLessThan, sp.StrictGreaterThan
    return sp.Interval(low.lts, high.gts, isinstance(low, strict), isinstance(high, strict))


def _parts(numbers: sp.Set) -> tuple[sp.Set, ...]:
    """Intervals and single points of a set, from the left."""
    parts = numbers.args if isinstance(numbers, sp.Union) else (numbers,)
    return tuple(sorted(parts, key=lambda part: part.inf))


def _pieces(numbers: sp.Set) -> Iterator[Piece]:
    for part in _parts(numbers):
        if isinstance(part, sp.Interval):
            yield Piece(part.start, part.end, not part.left_open, not part.right_open)


def _ends(numbers: sp.Set) -> Iterable[Any]:
    return (end for piece in _pieces(numbers) for end in (piece.lower, piece.upper))


def _written(symbol: sp.Symbol, numbers: sp.Set) -> str:
    """Write a set as LaTeX, and in degrees where the ends are multiples of pi."""
    texts, degrees = [], []
    for part in _parts(numbers):
        if isinstance(part, sp.FiniteSet):
            texts += [f"${sp.latex(symbol)} = {sp.latex(point)}$" for point in part]
            ends = [in_degrees(symbol, [Piece(point, point)]) for point in part]
            degrees += [end and f"{sp.pretty(symbol)} = {end.rpartition(' ')[2]}" for end in ends]
    pieces = tuple(_pieces(numbers))
    texts[:0] = [f"${condition_latex(symbol, [piece])}$" for piece in pieces]
    degrees[:0] = [in_degrees(symbol, [piece]) for piece in pieces]
    text = " or ".join(texts)
    return f"{text} ({' or '.join(degrees)})" if all(degrees) else text


def _defined(terms: Iterable[sp.Expr], symbol: sp.Symbol, point: Any) -> bool:
    values = (term.subs(symbol, point) for term in terms)
    return not any(value.has(sp.nan, sp.zoo, sp.oo, -sp.oo) for value in values)
