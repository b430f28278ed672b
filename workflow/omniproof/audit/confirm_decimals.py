"""Every printed decimal twice: FLINT's class of rounding, and the same from mpmath's intervals.

The second computation shares neither arithmetic nor reasoning with the first. It asks in which
stretch between two multiples of half a unit the value lies, and reads the class off that stretch;
the first compares the value with the bounds of each class. On such a multiple itself (an exact
decimal, a tie) no interval decides, unless the value is a plain fraction: there the modular test
says whether the value is that multiple. Who decided is named, as in `confirm`.

Direct evaluation to 60 digits is asked, too, which may contradict, and is not named.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from math import ceil, floor, trunc

import sympy as sp
from mpmath import mp

from omniproof.audit.decimals import (
    Decimal,
    DecimalFinding,
    Rounding,
    classify,
    format_fraction,
    read_decimal,
)
from omniproof.decide.answer import DisagreementError, Undecided
from omniproof.decide.digits import DIGITS, UndefinedError, are_equal
from omniproof.decide.in_sympy.digits import known_value
from omniproof.decide.order.enclosure import enclose
from omniproof.decide.prime_fields.zero import NonZero, Zero, vanishes
from omniproof.formula.sympy_terms import term_of
from omniproof.formula.term import number, subtract

Steps = Fraction
"""A number counted in units of the last printed place."""


def confirmed_class(value: sp.Expr, printed: str) -> DecimalFinding | Undecided:
    """Classify as `classify` does, and name every engine that comes to the same class.

    Raises `DisagreementError` when another engine, or direct evaluation, comes to another class or
    another correction.
    """
    finding = classify(value, printed)
    if isinstance(finding, Undecided):
        return finding
    decimal = read_decimal(printed)
    finding = _confirmed(finding, value, decimal)
    _heard(finding, value, decimal)
    return finding


def _heard(finding: DecimalFinding, value: sp.Expr, decimal: Decimal) -> None:
    """Ask direct evaluation, which says nothing of what it does not tell from a bound."""
    try:
        with mp.workdps(DIGITS):
            halves = 2 * decimal.unit.denominator * known_value(value, {})
            nearest, below = int(mp.nint(halves)), int(mp.floor(halves))
            is_on_a_bound = are_equal(halves, mp.mpf(nearest))
    except UndefinedError:
        return
    if is_on_a_bound and finding.rounding not in {Rounding.EXACT, Rounding.TIE}:
        return
    # All numbers between two bounds are of one class.
    steps = Fraction(nearest, 2) if is_on_a_bound else Fraction(2 * below + 1, 4)
    _agreed(finding, "direct evaluation", steps, value, decimal)


def _confirmed(finding: DecimalFinding, value: sp.Expr, decimal: Decimal) -> DecimalFinding:
    ends = enclose(value)
    if ends is None:
        return finding
    low, high = (end / decimal.unit for end in ends)
    if low == high or _is_inside_a_stretch(low, high):
        return _agreed(finding, "mpmath", low, value, decimal)
    # What is so close to a multiple of half a unit is one, or the first engine is wrong.
    multiple = Fraction(round(2 * low), 2)
    match vanishes(subtract(term_of(value), number(multiple * decimal.unit))):
        case Zero():
            return _agreed(finding, "modular", multiple, value, decimal)
        case NonZero() if finding.rounding in {Rounding.EXACT, Rounding.TIE}:
            raise DisagreementError(_both_sides("modular", finding, "neither", value, decimal))
    return finding


def _is_inside_a_stretch(low: Steps, high: Steps) -> bool:
    return floor(2 * low) == floor(2 * high) and (2 * low).denominator != 1


def _agreed(
    finding: DecimalFinding, engine: str, steps: Steps, value: sp.Expr, decimal: Decimal
) -> DecimalFinding:
    """Name an engine that finds the value at `steps`; raises `DisagreementError` for another."""
    own = f"{_class_of(steps, trunc(decimal.value / decimal.unit))}, {_nearest(steps, decimal)}"
    if own != f"{finding.rounding}, {finding.correction}":
        raise DisagreementError(_both_sides(engine, finding, own, value, decimal))
    return replace(finding, engines=(*finding.engines, engine))


def _both_sides(
    engine: str, finding: DecimalFinding, own: str, value: sp.Expr, decimal: Decimal
) -> str:
    said = f"{finding.rounding}, {finding.correction}"
    printed = format_fraction(decimal.value, decimal.unit)
    first = "+".join(finding.engines)
    return f"{engine} contradicts {first} on {sp.sstr(value)} = {printed}: {own} is not {said}"


def _class_of(steps: Steps, printed: int) -> Rounding:
    """Tell a class from the integers around a number."""
    nearest = {floor(steps + Fraction(1, 2)), ceil(steps - Fraction(1, 2))}
    if steps == printed:
        return Rounding.EXACT
    if printed in nearest:
        return Rounding.TIE if len(nearest) > 1 else Rounding.ROUNDED
    if printed == trunc(steps):
        return Rounding.TRUNCATED
    neighbour = len(nearest) == 1 and abs(printed - min(nearest)) == 1
    return Rounding.OFF_BY_ONE if neighbour else Rounding.WRONG


def _nearest(steps: Steps, decimal: Decimal) -> str:
    """Write the nearest decimal; of two, the one further from zero."""
    size = floor(abs(steps) + Fraction(1, 2))
    return format_fraction((size if steps >= 0 else -size) * decimal.unit, decimal.unit)
