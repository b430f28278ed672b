"""What a claim states of its symbols, and which signs follow from it.

Bounds of one symbol become intervals, and which ends belong to them is kept: an order is judged
there, too. (Equality is not: what is continuous and holds inside holds at the ends.) Everything
else (`a + b > c`, an order of angles) is kept as a condition: it restricts the points at which an
engine looks, and it decides the sign of what follows from it. Signs are proved factor by factor,
for each by the first way that works: it is a condition, or a sum of conditions; a function on a
box; a function of one such sum, on the interval that the bounds give it; a sum of terms of one
sign. No way means no sign, never a guess.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import combinations
from typing import Any

import sympy as sp
from sympy.core.relational import Relational

from omniproof.decide.answer import Proved
from omniproof.decide.in_sympy.domain import REAL_LINE, REALS, Domain
from omniproof.decide.in_sympy.exact import sign, subtract
from omniproof.decide.order.quotient import OnBox
from omniproof.decide.order.signs import sign_on
from omniproof.formula.errors import UnsupportedError

MOST_ADDED = 3


def domain_of(statements: Iterable[Any], base: Domain = REALS) -> Domain:
    """Return the domain on which inequalities hold, within another one.

    Raises `UnsupportedError` for what is no inequality, or leaves a symbol no value.
    """
    intervals, conditions = dict(base.intervals), list(base.conditions)
    closed = dict(base.closed)
    for relation in _inequalities(statements):
        bound = _bound(relation)
        if bound is None:
            conditions.append(relation)
            continue
        symbol, lower, upper = bound
        old, belongs = intervals.get(symbol, REAL_LINE), closed.get(symbol, (False, False))
        new = sp.Max(old[0], lower), sp.Min(old[1], upper)
        intervals[symbol] = new
        own = isinstance(relation, sp.GreaterThan | sp.LessThan)
        kept = [
            (end != old[k] or belongs[k]) and (end != (lower, upper)[k] or own)
            for k, end in enumerate(new)
        ]
        closed[symbol] = kept[0] and new[0].is_finite, kept[1] and new[1].is_finite
        if not intervals[symbol][0] < intervals[symbol][1]:
            raise UnsupportedError(f"no value of {symbol} is left")
    return Domain(
        intervals, tuple(conditions), {s: ends for s, ends in closed.items() if any(ends)}
    )


def _inequalities(statements: Iterable[Any]) -> Iterator[Relational]:
    for statement in statements:
        if statement == sp.true:
            continue
        if isinstance(statement, sp.And):
            yield from _inequalities(sorted(statement.args, key=sp.default_sort_key))
        elif isinstance(statement, Relational) and not isinstance(statement, sp.Eq):
            yield statement
        else:
            raise UnsupportedError(f"{statement} is no inequality")


def _bound(relation: Relational) -> tuple[str, Any, Any] | None:
    """Read `symbol > number` or `symbol < number`."""
    if isinstance(relation, sp.Ne):
        return None
    above, below = relation.gts, relation.lts
    if above.is_Symbol and not below.free_symbols:
        return above.name, below, sp.oo
    if below.is_Symbol and not above.free_symbols:
        return below.name, -sp.oo, above
    return None


def sign_under(expression: sp.Expr, domain: Domain) -> int | None:
    """Return the sign 1 or -1 that an expression has everywhere on a domain; None if not proved."""
    total = 1
    for factor in sp.Mul.make_args(sp.factor_terms(expression)):
        base, odd = (factor.base, factor.exp.is_odd) if factor.is_Pow else (factor, True)
        own = _sign_of(base if odd is not None else factor, domain)
        if own is None:
            return None
        total *= own if odd is not False else 1
    return total


def _sign_of(factor: Any, domain: Domain) -> int | None:
    try:
        if not factor.free_symbols:
            return sign(factor) or None
        terms = {sign_under(term, domain) for term in factor.args} if factor.is_Add else {None}
        if terms in ({1}, {-1}):
            return terms.pop()
        for wanted in (1, -1):
            if any(way(wanted * factor, domain) for way in (_follows, _on_box, _of_one, _shifted)):
                return wanted
    except UnsupportedError:
        pass
    return None


def _positive(domain: Domain) -> list[sp.Expr]:
    """Differences that the conditions say to be positive."""
    strict = (sp.StrictGreaterThan, sp.StrictLessThan)
    return [c.gts - c.lts for c in domain.conditions if isinstance(c, strict)]


def _sums(domain: Domain) -> Iterator[sp.Expr]:
    """Yield sums of a few conditions: from a < b < c follows a < c."""
    given = _positive(domain)
    for count in range(1, MOST_ADDED + 1):
        yield from (sp.expand(sum(chosen)) for chosen in combinations(given, count))


def _follows(part: sp.Expr, domain: Domain) -> bool:
    """Whether a part is a positive multiple of a condition, or of a sum of some."""
    ratios = (sp.cancel(part / given) for given in _sums(domain) if given != 0)
    return any(not ratio.free_symbols and sign(ratio) > 0 for ratio in ratios)


def _on_box(part: sp.Expr, domain: Domain) -> bool:
    sides = {symbol: domain.interval(symbol.name) for symbol in part.free_symbols}
    if any(end.is_infinite for side in sides.values() for end in map(sp.sympify, side)):
        return False
    return isinstance(sign_on(OnBox(part, sides), 1), Proved)


def _of_one(part: sp.Expr, domain: Domain) -> bool:
    """Whether a part is a function of one linear sum of conditions, positive where that runs."""
    step = sp.Symbol("step", positive=True)
    for given in _sums(domain):
        solved = next((s for s in sorted(given.free_symbols, key=str) if given.coeff(s) != 0), None)
        reach = _largest(given, domain)
        if solved is None or reach is None:
            continue
        rest = sp.expand((step - given.subs(solved, 0)) / given.coeff(solved))
        new = part.subs(solved, rest)
        new = new.replace(lambda node: node.is_Function, lambda node: node.func(*_plain(node)))
        if new.free_symbols == {step}:
            return isinstance(sign_on(OnBox(new, {step: (sp.S.Zero, reach)}), 1), Proved)
    return False


def _plain(node: Any) -> list[sp.Expr]:
    return [sp.expand(argument) for argument in node.args]


def _largest(form: sp.Expr, domain: Domain) -> Any:
    """Return the upper bound of a linear form on the intervals; None where there is none."""
    total = form.subs(dict.fromkeys(form.free_symbols, 0))
    for symbol in form.free_symbols:
        rate = form.coeff(symbol)
        lower, upper = map(sp.sympify, domain.interval(symbol.name))
        end = upper if rate.is_positive else lower
        if rate.free_symbols or end.is_infinite:
            return None
        total += rate * end
    exact = sp.expand(form - sum(form.coeff(s) * s for s in form.free_symbols))
    return total if not exact.free_symbols and sign(total) > 0 else None


def _shifted(part: sp.Expr, domain: Domain) -> bool:
    """Whether a part is a sum of positive terms, each symbol measured from its end."""
    moved = {}
    for symbol in part.free_symbols:
        lower, upper = map(sp.sympify, domain.interval(symbol.name))
        own = sp.Symbol(symbol.name, positive=True)
        if lower.is_finite:
            moved[symbol] = lower + own
        elif upper.is_finite:
            moved[symbol] = upper - own
    return bool(sp.expand(part.subs(moved)).is_positive)


def within(
    box: Mapping[sp.Symbol, tuple[Any, Any]], domain: Domain
) -> dict[sp.Symbol, tuple[Any, Any]]:
    """Return the part of a box that lies in the intervals of a domain.

    Raises `UnsupportedError` where nothing is left.
    """
    sides = {}
    for symbol, (lower, upper) in box.items():
        own = domain.interval(symbol.name)
        sides[symbol] = (sp.Max(lower, own[0]), sp.Min(upper, own[1]))
        if sign(subtract(*reversed(sides[symbol]))) <= 0:
            raise UnsupportedError(f"no value of {symbol} is left")
    return sides


def closed_ends(
    box: Mapping[sp.Symbol, tuple[Any, Any]], domain: Domain
) -> dict[sp.Symbol, tuple[bool, bool]]:
    """Return which ends of a box are closed ends of the domain."""
    closed = {}
    for symbol, side in box.items():
        own = domain.interval(symbol.name)
        belongs = domain.closed.get(symbol.name, (False, False))
        ends = [belongs[k] and sign(subtract(side[k], own[k])) == 0 for k in (0, 1)]
        if any(ends):
            closed[symbol] = ends[0], ends[1]
    return closed


def with_box(domain: Domain, box: Mapping[sp.Symbol, tuple[Any, Any]]) -> Domain:
    """Return a domain within a box."""
    sides = {symbol.name: side for symbol, side in within(box, domain).items()}
    return Domain({**domain.intervals, **sides}, domain.conditions)
