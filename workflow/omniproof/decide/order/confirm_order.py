"""Order twice: what balls prove or refute is asked again of z3, which knows neither.

A statement is given by what would refute it: comparisons that hold at a point of a region. No such
point confirms a proof, a point confirms a refutation, and a condition is confirmed when something
is needed (a point without it) and it suffices (none under it). z3 is named only where it came to
the same answer; when it comes to another one, one of the two is broken. z3 looks at terms; what a
condition says, and where it was asked, comes from SymPy.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from omniproof.decide.answer import Answer, DisagreementError, OnBranch, Proved, Refuted, Undecided
from omniproof.decide.z3.order import Nowhere, Region, Somewhere, find_point
from omniproof.formula.sympy_terms import (
    Converter,
    assumed_signs,
    comparison_of,
    end_of,
    term_of,
)
from omniproof.formula.term import Term
from omniproof.formula.value import Comparison

Vote = bool | None
"""True: there is a point; False: there is none; None: not decided."""


def region_of(
    box: Mapping[sp.Symbol, tuple[Any, Any]],
    closed: Mapping[sp.Symbol, tuple[bool, bool]],
    conditions: Sequence[Any],
    formulas: Iterable[sp.Expr],
    apart: Sequence[Sequence[Any]] = (),
) -> Region:
    """Return where z3 looks for a point, and what SymPy assumes of the symbols of formulas.

    Raises `UnsupportedError` where an end or a condition is no term.
    """
    return Region(
        {symbol.name: (end_of(lower), end_of(upper)) for symbol, (lower, upper) in box.items()},
        {symbol.name: ends for symbol, ends in closed.items()},
        tuple(map(comparison_of, conditions)),
        tuple(tuple(map(term_of, point)) for point in apart),
        assumed_signs(*formulas, *conditions, *box),
    )


def confirmed_order(answer: Answer, failures: Sequence[Comparison], region: Region) -> Answer:
    """Name z3 in an answer to which it comes, too; any of the `failures` at a point refutes.

    Raises `DisagreementError` when z3 comes to another answer.
    """
    if isinstance(answer, Undecided) or "z3" in answer.engines:
        return answer
    vote = _vote(answer, failures, region)
    if vote is False:
        told = ", ".join(sp.sstr(Converter().expression(failure)) for failure in failures)
        engines = "+".join(answer.engines)
        raise DisagreementError(f"z3 contradicts {engines} on a point with {told}: {answer}")
    return replace(answer, engines=(*answer.engines, "z3")) if vote else answer


def decided_by_algebra(failures: Sequence[Comparison], region: Region) -> Proved | None:
    """Prove by z3 alone what balls leave open: there is no point with any of the failures."""
    return Proved(("z3",)) if _fails_in(failures, [region]) is False else None


def _vote(
    answer: Proved | Refuted | OnBranch, failures: Sequence[Comparison], region: Region
) -> Vote:
    found = _fails_in(failures, [region])
    if found is None:
        return None
    if isinstance(answer, Proved):
        return not found
    if isinstance(answer, Refuted) or not found:
        # A note gives another reason than a point (the printed point lies outside of the box).
        return True if found else None if answer.note and isinstance(answer, Refuted) else False
    parts = list(_parts(answer, region))
    under = _fails_in(failures, parts) if parts else None
    return None if under is None else not under


def _fails_in(failures: Sequence[Comparison], regions: Sequence[Region]) -> Vote:
    """Whether there is a point in any of the regions; a point that may be none decides nothing."""
    answers = [find_point([failure], region) for region in regions for failure in failures]
    if any(isinstance(answer, Somewhere) and answer.exact for answer in answers):
        return True
    return False if all(isinstance(answer, Nowhere) for answer in answers) else None


def _parts(answer: OnBranch, region: Region) -> Iterator[Region]:
    """Yield the parts of a region in which a condition holds; none where it has another form."""
    if len(region.ranges) > 1:
        points = [{ne.lhs.name: ne.rhs for ne in each.atoms(sp.Ne)} for each in answer.relations]
        if points and all(point.keys() == region.ranges.keys() for point in points):
            apart = tuple(tuple(term_of(point[n]) for n in region.ranges) for point in points)
            yield replace(region, apart=apart)
        return
    ((name, (lower, upper)),) = region.ranges.items()
    left, right = region.closed.get(name, (False, False))
    whole = sp.Interval(_end(lower, -sp.oo), _end(upper, sp.oo), not left, not right)
    kept = sp.And(*answer.relations).as_set() & whole
    for part in kept.args if isinstance(kept, sp.Union) else (kept,):
        if isinstance(part, sp.Interval):
            ends = {name: (end_of(part.inf), end_of(part.sup))}
            closed = (not part.left_open, not part.right_open)
            yield replace(region, ranges=ends, closed={name: closed})
        else:
            for point in map(term_of, part):
                yield replace(region, ranges={name: (point, point)}, closed={name: (True, True)})


def _end(end: Term | None, infinite: Any) -> Any:
    return infinite if end is None else Converter().expression(end)
