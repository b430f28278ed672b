"""Which set-up do printed cells come from?  Solved from the cells, jointly, or proved impossible.

A table prints values of known functions of a set-up (a speed, a radius, a rate), cut to a few
digits. Each cell confines the set-up to the numbers that its decimal stands for. One number fitted
to all cells would hide which of them disagree; intervals show it, and prove it:

* functions that are linear in the unknown, or a power of it, give intervals with exact ends; all
  others are enclosed in balls (`preimage`), widened outwards, so that emptiness stays a proof;
* further unknowns that enter linearly are eliminated pair by pair (Fourier and Motzkin). For cells
  with two bounds each this loses nothing: intervals on a line have a common point as soon as any
  two of them have one;
* an empty intersection comes with a contradictory subset of cells from which none can be spared.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cmp_to_key, reduce
from itertools import combinations
from typing import Any, TypeAlias

import sympy as sp

from omniproof.audit.confirm_decimals import confirmed_class
from omniproof.audit.decimals import DecimalFinding, solve_for
from omniproof.audit.evidence import Setup
from omniproof.audit.preimage import MOST_CELLS, SMALLEST
from omniproof.audit.ranges import (
    REAL_LINE,
    Pieces,
    Reading,
    add,
    contains,
    decimal_range,
    meet,
    meet_all,
    order,
    root,
    scale,
    stands_for,
)
from omniproof.decide.answer import Undecided
from omniproof.decide.in_sympy.exact import sign
from omniproof.decide.order.intervals import Piece
from omniproof.formula.errors import UnsupportedError

ENGINE = ("flint",)
DIGITS = 12

Within: TypeAlias = Mapping[sp.Symbol, Piece]
"""Ranges of unknowns that are known beforehand; an unknown that is not named is any real number."""
Powers: TypeAlias = tuple[Any, ...]


@dataclass(frozen=True)
class Cell:
    """A printed decimal, and the function of the set-up that it should show.

    `value` is an exact SymPy expression; its free symbols are the unknowns.
    """

    name: str
    printed: str
    value: sp.Expr
    reading: Reading = Reading.EITHER

    @property
    def interval(self) -> Piece:
        """The numbers that the decimal stands for."""
        return stands_for(self.printed, self.reading)


@dataclass(frozen=True)
class Allowed:
    """What some cells together leave for one unknown; enclosed from outside when not `exact`."""

    names: tuple[str, ...]
    pieces: Pieces
    exact: bool = True


@dataclass(frozen=True)
class Solution:
    """What all cells together leave for one unknown.

    `evidence` is what each cell leaves on its own; where other unknowns were eliminated, what each
    group of cells leaves that is free of them. `contradiction` names cells that cannot all be
    right, none of which can be spared; it is empty unless `pieces` is.
    """

    unknown: sp.Symbol
    pieces: Pieces
    evidence: tuple[Allowed, ...]
    contradiction: tuple[str, ...] = ()

    @property
    def is_exact(self) -> bool:
        """Whether the ends are exact, and every number within is a solution."""
        return all(line.exact for line in self.evidence)

    def record(self, digits: int = 6) -> Setup:
        """Return what is left, with decimals for the ends."""
        ranges = tuple(decimal_range(piece, digits) for piece in self.pieces)
        return Setup(unknown=self.unknown.name, ranges=ranges, contradicting=self.contradiction)


@dataclass(frozen=True)
class Checked:
    """A cell beside its exact value in a stated set-up.

    `readings` are the classes, rounded and truncated, under which the cell follows.
    """

    name: str
    printed: str
    finding: DecimalFinding
    readings: tuple[Reading, ...]


def read_as(cells: Iterable[Cell], reading: Reading) -> tuple[Cell, ...]:
    """Take the decimals of all cells in the same way."""
    return tuple(replace(cell, reading=reading) for cell in cells)


def solve(
    cells: Sequence[Cell], unknown: sp.Symbol, within: Within | None = None
) -> Solution | Undecided:
    """Find all values of an unknown that some set-up with all these cells has.

    Further unknowns must enter linearly. A function of another kind than linear or monomial needs
    a bounded range of the unknown in `within`, and a monomial one that starts at zero or above.
    """
    try:
        evidence = _evidence(cells, unknown, within or {})
        pieces = _common(evidence)
        contradiction = () if pieces else _contradiction(evidence)
        return Solution(unknown, pieces, evidence, contradiction)
    except UnsupportedError as reason:
        return Undecided(str(reason), ENGINE)


def readings_left(
    cells: Sequence[Cell], unknown: sp.Symbol, within: Within | None = None
) -> Mapping[str, tuple[Reading, ...]] | Undecided:
    """Find for each cell whether it can be rounded and whether it can be truncated.

    The other cells keep the readings that they have. A reading that is missing is impossible.
    """
    left: dict[str, tuple[Reading, ...]] = {}
    try:
        for place, cell in enumerate(cells):
            left[cell.name] = tuple(
                reading
                for reading in (Reading.ROUNDED, Reading.TRUNCATED)
                if _common(_evidence(_with_reading(cells, place, reading), unknown, within or {}))
            )
    except UnsupportedError as reason:
        return Undecided(str(reason), ENGINE)
    return left


def check_setup(
    cells: Sequence[Cell], setup: Mapping[sp.Symbol, sp.Expr]
) -> tuple[Checked, ...] | Undecided:
    """Compare all cells with their exact values in a stated set-up."""
    try:
        return tuple(_check(cell, setup) for cell in cells)
    except UnsupportedError as reason:
        return Undecided(str(reason), ENGINE)


def contradicting(checked: Iterable[Checked], reading: Reading) -> tuple[str, ...]:
    """Name the cells that do not follow from the set-up when decimals are read so."""
    if reading is Reading.EITHER:
        return tuple(line.name for line in checked if not line.readings)
    return tuple(line.name for line in checked if reading not in line.readings)


def _check(cell: Cell, setup: Mapping[sp.Symbol, sp.Expr]) -> Checked:
    value = cell.value.xreplace(dict(setup))
    finding = confirmed_class(value, cell.printed)
    if isinstance(finding, Undecided):
        raise UnsupportedError(f"{cell.name}: {finding.reason}")
    readings = (Reading.ROUNDED, Reading.TRUNCATED)
    follows = tuple(r for r in readings if contains(stands_for(cell.printed, r), value))
    return Checked(cell.name, cell.printed, finding, follows)


def _with_reading(cells: Sequence[Cell], place: int, reading: Reading) -> list[Cell]:
    return [replace(cell, reading=reading) if k == place else cell for k, cell in enumerate(cells)]


def _evidence(cells: Sequence[Cell], unknown: sp.Symbol, within: Within) -> tuple[Allowed, ...]:
    unknowns = {unknown}.union(*(cell.value.free_symbols for cell in cells))
    domain = within.get(unknown, REAL_LINE)
    others = sorted(unknowns - {unknown}, key=str)
    if not others:
        return tuple(_allowed(cell, unknown, domain) for cell in cells)
    strips = [_strip_of(cell, (unknown, *others)) for cell in cells]
    strips += [_Strip((), {other: sp.S.One}, within.get(other, REAL_LINE)) for other in others]
    for other in others:
        strips = _eliminate(strips, other)
    return tuple(
        Allowed(s.names, _preimage(s.slopes.get(unknown, sp.S.Zero), s.range, domain))
        for s in strips
    )


# One unknown -----------------------------------------------------------------------------------


def _allowed(cell: Cell, unknown: sp.Symbol, domain: Piece) -> Allowed:
    """Solve one cell for its only unknown."""
    terms = _monomials(cell.value, (unknown,))
    powers = [power for (power,) in terms or () if power]
    if terms is None or len(powers) > 1:
        return Allowed((cell.name,), _enclosed(cell, unknown, domain), exact=False)
    power = powers[0] if powers else 1
    slope = terms.get((power,), sp.S.Zero)
    shifted = scale(cell.interval, sp.S.One, -terms.get((0,), sp.S.Zero))
    if power == 1:
        return Allowed((cell.name,), _preimage(slope, shifted, domain))
    # Even powers have two roots where the unknown may be negative.
    if order(domain.lower, sp.S.Zero) < 0:
        return Allowed((cell.name,), _enclosed(cell, unknown, domain), exact=False)
    positive = root(scale(shifted, 1 / slope), power)
    return Allowed((cell.name,), meet_all((positive,), (domain,)) if positive else ())


def _preimage(slope: sp.Expr, interval: Piece, domain: Piece) -> Pieces:
    """Return the x of the domain with slope x in the interval."""
    if sign(slope) == 0:
        return (domain,) if contains(interval, sp.S.Zero) else ()
    return meet_all((scale(interval, 1 / slope),), (domain,))


def _enclosed(cell: Cell, unknown: sp.Symbol, domain: Piece) -> Pieces:
    """Enclose the solutions from outside: decimals, with room for all that was left unsettled."""
    ends = (cell.interval.lower, cell.interval.upper)
    lower, upper = (Fraction(int(end.p), int(end.q)) for end in ends)
    found = solve_for(cell.value, unknown, (lower, upper), (domain.lower, domain.upper), DIGITS)
    if isinstance(found, Undecided):
        raise UnsupportedError(f"{cell.name}: {found.reason}")
    # `solve_for` leaves cells of this size open: without room for them, emptiness is no proof.
    room = (domain.upper - domain.lower) * sp.Rational(MOST_CELLS * SMALLEST.p, SMALLEST.q)
    wide = (Piece(_widened(a, -1) - room, _widened(b, 1) + room, True, True) for a, b in found)
    return meet_all(tuple(wide), (domain,))


def _widened(decimal: str, side: int) -> sp.Rational:
    """Move a decimal outwards by more than one unit of its last digit."""
    value = sp.Rational(decimal)
    return value + side * abs(value) * sp.Rational(2, 10 ** (DIGITS - 1))


def _monomials(value: sp.Expr, unknowns: Sequence[sp.Symbol]) -> dict[Powers, sp.Expr] | None:
    """Write an expression as a sum of products of powers: exponents -> exact coefficient.

    Terms that are proved to vanish are left out. None when it is no such sum.
    """
    terms: dict[Powers, sp.Expr] = {}
    for term in sp.Add.make_args(sp.expand(value)):
        coefficient, product = term.as_independent(*unknowns, as_Add=False)
        powers = {
            base: power for base, power in product.as_powers_dict().items() if base not in (0, 1)
        }
        # sin(V) or V^x: no sum of powers, and solved by enclosure instead.
        if not all(base in unknowns and power.is_Rational for base, power in powers.items()):
            return None
        key = tuple(powers.get(unknown, 0) for unknown in unknowns)
        terms[key] = terms.get(key, sp.S.Zero) + coefficient
    return {key: c for key, c in terms.items() if sign(c) != 0}


# Several unknowns ------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Strip:
    """The set-ups with sum(slope * unknown) in a range, as some cells demand."""

    names: tuple[str, ...]
    slopes: Mapping[sp.Symbol, sp.Expr]
    range: Piece


def _strip_of(cell: Cell, unknowns: Sequence[sp.Symbol]) -> _Strip:
    terms = _monomials(cell.value, unknowns)
    if terms is None or any(sorted(filter(None, key)) not in ([], [1]) for key in terms):
        names = ", ".join(unknown.name for unknown in unknowns)
        raise UnsupportedError(f"{cell.name} is not linear in {names}")
    slopes = {unknowns[key.index(1)]: slope for key, slope in terms.items() if any(key)}
    constant = terms.get((0,) * len(unknowns), sp.S.Zero)
    return _Strip((cell.name,), slopes, scale(cell.interval, sp.S.One, -constant))


def _eliminate(strips: Sequence[_Strip], unknown: sp.Symbol) -> list[_Strip]:
    """Project the common part of strips along one unknown."""
    without = [strip for strip in strips if unknown not in strip.slopes]
    scaled = [_divided(strip, unknown) for strip in strips if unknown in strip.slopes]
    # Fourier and Motzkin: what two strips say of the rest is left when the unknown cancels.
    return [*without, *(_difference(a, b) for a, b in combinations(scaled, 2))]


def _divided(strip: _Strip, unknown: sp.Symbol) -> _Strip:
    factor = 1 / strip.slopes[unknown]
    slopes = {symbol: factor * slope for symbol, slope in strip.slopes.items() if symbol != unknown}
    return _Strip(strip.names, slopes, scale(strip.range, factor))


def _difference(left: _Strip, right: _Strip) -> _Strip:
    zero = sp.S.Zero
    slopes = {
        symbol: sp.expand(left.slopes.get(symbol, zero) - right.slopes.get(symbol, zero))
        for symbol in {**left.slopes, **right.slopes}
    }
    names = tuple(dict.fromkeys((*left.names, *right.names)))
    kept = {symbol: slope for symbol, slope in slopes.items() if sign(slope) != 0}
    return _Strip(names, kept, add(left.range, scale(right.range, sp.Integer(-1))))


# All cells together ----------------------------------------------------------------------------


def _common(evidence: Iterable[Allowed]) -> Pieces:
    return reduce(meet_all, (line.pieces for line in evidence), (REAL_LINE,))


def _contradiction(evidence: Sequence[Allowed]) -> tuple[str, ...]:
    """Drop cell after cell while the rest still contradicts itself."""
    names = _outermost(evidence)
    for name in names:
        rest = tuple(other for other in names if other != name)
        if not _common(_among(evidence, rest)):
            names = rest
    return names


def _outermost(evidence: Sequence[Allowed]) -> tuple[str, ...]:
    """Name the cells that demand most and least, if these are at odds, else all cells."""
    for line in evidence:
        if not line.pieces:
            return line.names
    most = max(evidence, key=cmp_to_key(_by_lower))
    least = min(evidence, key=cmp_to_key(_by_upper))
    above = replace(most.pieces[0], upper=sp.oo)
    below = replace(least.pieces[-1], lower=-sp.oo)
    # Two cells that contradict each other tell a reader more than a list of all.
    if meet(above, below) is None:
        return tuple(dict.fromkeys((*most.names, *least.names)))
    return tuple(dict.fromkeys(name for line in evidence for name in line.names))


def _by_lower(left: Allowed, right: Allowed) -> int:
    return order(left.pieces[0].lower, right.pieces[0].lower)


def _by_upper(left: Allowed, right: Allowed) -> int:
    return order(left.pieces[-1].upper, right.pieces[-1].upper)


def _among(evidence: Iterable[Allowed], names: Collection[str]) -> list[Allowed]:
    return [line for line in evidence if set(line.names) <= set(names)]
