"""Whether printed angles are a member of a one-parameter family of angles.

Order and full turns do not matter. Each member of the family is a rational-linear form in the
parameter, so that a full period of the family has finitely many parameters at which a printed angle
takes a given place; the rest of the angles tells whether one of them is right. What is assumed is
asked of each right one, as often as its period comes back in the range of the parameter.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Any

from sympy import And, Expr, Symbol, ceiling, false, floor, ilcm, pi, true
from sympy.logic.boolalg import Boolean

from omniproof.decide.answer import Answer, Proved, Refuted, Undecided, Witness
from omniproof.decide.in_sympy.domain import REALS, Domain

ENGINE = ("exact",)
TURN = 2 * pi
MOST_PERIODS = 8


def instance(
    printed: Sequence[Expr],
    family: Sequence[Expr],
    domain: Domain = REALS,
    assumed: Sequence[Boolean] = (),
) -> Answer:
    """Decide whether the angles are those of a parameter that fulfils what is assumed.

    The intervals of the domain say how often a parameter may come back; whether their ends belong
    to them is asked of `assumed`.
    """
    (parameter,) = set().union(*(member.free_symbols for member in family))
    shown = {f"angle_{i}": _degrees(entry) for i, entry in enumerate(printed, 1)}
    fits = {value: _fit(printed, family, {parameter: value})
            for value in _parameters(printed, family, parameter)}  # fmt: skip
    members = [value for value, fit in fits.items() if fit == len(printed) == len(family)]
    if not members:
        told = f"{max(fits.values())} in one member"
        return Refuted(ENGINE, Witness(shown, f"{len(printed)} angles", told))
    interval = domain.interval(parameter.name)
    period = _period(family, parameter)
    found = {And(*assumed).subs(parameter, again)
             for value in members for again in _returns(value, period, interval)}  # fmt: skip
    if true in found:
        return Proved(ENGINE)
    if found - {false}:
        return Undecided("it hangs on what is assumed of other symbols than the parameter")
    told = " or ".join(_degrees(_reduced(value)) for value in members)
    return Refuted(ENGINE, Witness(shown, "allowed", f"{parameter} = {told}"), "it is out of range")


def _parameters(
    printed: Sequence[Expr], family: Sequence[Expr], parameter: Symbol
) -> Iterator[Expr]:
    """Yield where in a period one entry of the family is one of the printed angles."""
    entry = next(member for member in family if member.has(parameter))
    slope = entry.coeff(parameter)
    for angle in printed:
        first = (angle - entry.subs(parameter, 0)) / slope
        # The entry takes this angle again after each full turn of its own.
        for turns in range(_period(family, parameter) * abs(slope) / TURN):
            yield first + turns * TURN / abs(slope)


def _period(family: Sequence[Expr], parameter: Symbol) -> Expr:
    """Return after which change of the parameter every entry has made full turns."""
    return TURN * ilcm(1, *(member.coeff(parameter).q for member in family))


def _fit(printed: Sequence[Expr], family: Sequence[Expr], at: dict[Symbol, Expr]) -> int:
    """Count the printed angles that are in one member of the family."""
    member = Counter(_reduced(entry.subs(at)) for entry in family)
    return (member & Counter(map(_reduced, printed))).total()


def _returns(value: Expr, period: Expr, interval: tuple[Any, Any]) -> Iterator[Expr]:
    """Yield a parameter again and again, as far as a range goes, or a few times if it is open."""
    lower, upper = interval
    first = ceiling((lower - value) / period) if lower.is_finite else None
    last = floor((upper - value) / period) if upper.is_finite else None
    if first is None:
        first = 0 if last is None else last - 1
    if last is None:
        last = first + 1
    for count in range(first, min(last, first + MOST_PERIODS) + 1):
        yield value + count * period


def _reduced(angle: Expr) -> Expr:
    return angle % TURN


def _degrees(angle: Any) -> str:
    return f"{angle * 180 / pi}°"
