"""Exact comparison of numbers: order, monotone sequences, extreme members, equality.

Balls decide whatever differs; the zero test decides what is equal. No tolerance anywhere.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cmp_to_key
from itertools import pairwise

import sympy as sp

from omniproof.decide.answer import Answer, Proved, Refuted, Undecided, Witness
from omniproof.decide.balls import format_ball
from omniproof.decide.in_sympy.balls import evaluate
from omniproof.decide.in_sympy.exact import sign, subtract
from omniproof.formula.errors import UnsupportedError

ENGINE = ("flint",)


def compare(left: sp.Expr, right: sp.Expr) -> int:
    """Return -1, 0 or 1 as `left` is less than, equal to or greater than `right`.

    Raises `UnsupportedError` for what is no finite exact real number; the functions that answer
    claims return `Undecided` instead.
    """
    return sign(subtract(left, right))


def monotone(values: Sequence[sp.Expr], direction: int) -> Answer:
    """Decide whether a sequence increases (direction 1) or decreases (-1), strictly.

    A witness names the places, from 1, of the first two neighbours that are out of order.
    """
    return _all_pairs(values, lambda order: order == -direction)


def extreme_members(values: Mapping[str, sp.Expr], direction: int) -> tuple[str, ...] | Undecided:
    """Name the largest members (direction 1) or the smallest (-1): all of them, if they tie."""
    try:
        best = max(values.values(), key=cmp_to_key(lambda a, b: direction * compare(a, b)))
        return tuple(name for name, value in values.items() if compare(value, best) == 0)
    except UnsupportedError as reason:
        return Undecided(str(reason), ENGINE)


def is_extreme(values: Mapping[str, sp.Expr], member: str, direction: int) -> Answer:
    """Decide whether one member is the only largest (direction 1) or smallest (-1).

    A witness names the best of the others, where it is as good or better. Raises `KeyError` for an
    unknown member.
    """
    value = values[member]
    others = {name: other for name, other in values.items() if name != member}
    if not others:
        return Proved(ENGINE)
    rivals = extreme_members(others, direction)
    if isinstance(rivals, Undecided):
        return rivals
    best = others[rivals[0]]
    try:
        if direction * compare(value, best) > 0:
            return Proved(ENGINE)
        return Refuted(ENGINE, Witness({"member": rivals[0]}, digits(value), digits(best)))
    except UnsupportedError as reason:
        return Undecided(str(reason), ENGINE)


def _all_pairs(values: Sequence[sp.Expr], holds: Callable[[int], bool]) -> Answer:
    try:
        for place, (left, right) in enumerate(pairwise(values), start=1):
            if not holds(compare(left, right)):
                point = {"first": str(place), "second": str(place + 1)}
                return Refuted(ENGINE, Witness(point, digits(left), digits(right)))
    except UnsupportedError as reason:
        return Undecided(str(reason), ENGINE)
    return Proved(ENGINE)


def digits(value: sp.Expr) -> str:
    """Write an exact number to six significant digits."""
    return format_ball(evaluate(value), 6)
