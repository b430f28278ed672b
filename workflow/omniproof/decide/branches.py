"""Where a formula with absolute values and roots is true: from sign patterns to a condition.

The normal form tells exactly for which signs of the irreducible factors a formula vanishes. A
reader wants that as "where sin x >= 0", in terms of what is printed. So the parts of the formula
are tried, alone, as products and together: each that is a product of the same factors has its sign
on every pattern, and it is the condition if it is positive on just the patterns that are true.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from math import prod

import sympy as sp

from omniproof.decide import domain as decide
from omniproof.decide.answer import Proved
from omniproof.decide.balls import enclose
from omniproof.decide.in_sympy.domain import converter_for, in_sympy
from omniproof.decide.in_sympy.exact import subtract
from omniproof.decide.normal_form.form import NormalForm, Signs
from omniproof.decide.order.hypotheses import sign_under
from omniproof.decide.order.quotient import OnBox
from omniproof.decide.order.signs import sign_on
from omniproof.decide.sampling import Sample
from omniproof.formula.sympy_terms import CIRCULAR_FUNCTIONS, term_of
from omniproof.formula.term import Term, symbols

MOST_PARTS = 14
MOST_TOGETHER = 3


@dataclass(frozen=True)
class Condition:
    """Formulas that must all be positive (or zero, where the identity is defined there)."""

    parts: tuple[sp.Expr, ...]
    strict: bool

    @property
    def relations(self) -> tuple[sp.Basic, ...]:
        """Write the condition as SymPy relations."""
        kind = sp.StrictGreaterThan if self.strict else sp.GreaterThan
        return tuple(kind(part, 0, evaluate=False) for part in self.parts)

    @property
    def latex(self) -> str:
        r"""Write the condition as LaTeX, parts joined by `\text{ and }`."""
        sign = ">" if self.strict else r"\geq"
        return r" \text{ and } ".join(f"{sp.latex(part)} {sign} 0" for part in self.parts)

    def is_missed_at(self, point: Sample) -> bool:
        """Whether a part is certainly negative at a point."""
        return any(enclose(term_of(part), point) < 0 for part in self.parts)


class Branches:
    """The signs of parts of an equation, and the conditions that they make, in SymPy's words."""

    def __init__(self, terms: tuple[Term, Term], domain: decide.Domain) -> None:
        converter = converter_for(domain, set().union(*map(symbols, terms)))
        self.difference = subtract(*map(converter.expression, terms))
        self.domain = in_sympy(domain, converter)
        self.positive = tuple(map(converter.expression, domain.positive))

    def settle(self, form: NormalForm) -> None:
        """Tell a normal form the signs that the domain gives to parts of the equation."""
        for part in (*self.positive, *named_parts(self.difference)):
            term = term_of(part)
            pattern = form.sign_pattern(term)
            own = sign_under(part, self.domain) if pattern and pattern[1] else None
            if own:
                form.presume(term, own)

    def condition(self, form: NormalForm) -> Condition | None:
        """Find the condition, without the parts of it that the domain settles."""
        condition = find_condition(form, self.difference)
        if condition is None:
            return None
        parts = (part for part in condition.parts if not self._is_positive(part))
        return Condition(tuple(parts), condition.strict)

    def _is_positive(self, part: sp.Expr) -> bool:
        """Prove that a formula is positive everywhere in the domain."""
        sides = {s: self.domain.intervals[s.name] for s in part.free_symbols if self._is_limited(s)}
        rest = part.free_symbols - set(sides)
        shifted = part.subs({symbol: self._shifted(symbol) for symbol in rest})
        if not sides or rest:
            return bool(sp.expand(shifted).is_nonnegative)
        return isinstance(sign_on(OnBox(part, sides), 1), Proved)

    def _is_limited(self, symbol: sp.Symbol) -> bool:
        """Whether the domain of a symbol is bounded."""
        lower, upper = self.domain.interval(symbol.name)
        return lower != -sp.oo and upper != sp.oo

    def _shifted(self, symbol: sp.Symbol) -> sp.Expr:
        """Write a symbol that is bounded on one side by a positive one."""
        lower, upper = self.domain.interval(symbol.name)
        positive = sp.Symbol(symbol.name, positive=True)
        if lower == -sp.oo:
            return symbol if upper == sp.oo else upper - positive
        return lower + positive


@dataclass(frozen=True)
class _Part:
    expression: sp.Expr
    sign: int
    places: frozenset[str]

    def on(self, signs: Signs) -> int:
        return self.sign * prod(signs[place] for place in self.places)


def find_condition(form: NormalForm, expression: sp.Expr) -> Condition | None:
    """Find the condition under which a formula vanishes; None when it is not in its own terms."""
    patterns = list(form.patterns())
    truth = [true for _, true in patterns]
    if all(truth) or not any(truth):
        return None
    parts = list(_parts(form, expression))
    for count in range(1, MOST_TOGETHER + 1):
        for chosen in combinations(parts, count):
            if [all(p.on(signs) > 0 for p in chosen) for signs, _ in patterns] == truth:
                return Condition(tuple(p.expression for p in chosen), _is_strict(form, chosen))
    return None


def _parts(form: NormalForm, expression: sp.Expr) -> Iterator[_Part]:
    """Yield parts of the formula, positive and negative, with different sign patterns."""
    seen: set[tuple[int, frozenset[str]]] = set()
    for candidate in named_parts(expression):
        pattern = form.sign_pattern(term_of(candidate))
        if pattern is None or not pattern[1] or pattern in seen:
            continue
        sign, places = pattern
        seen |= {(sign, places), (-sign, places)}
        yield _Part(candidate, sign, places)
        yield _Part(-candidate, -sign, places)
        if len(seen) >= 2 * MOST_PARTS:
            return


def named_parts(expression: sp.Expr) -> Iterator[sp.Expr]:
    """Yield what a reader would name: arguments of |.|, functions, symbols, sums, products."""
    nodes = [node for node in sp.preorder_traversal(expression) if isinstance(node, sp.Expr)]
    absolute = [node.args[0] for node in nodes if isinstance(node, (sp.Abs, sp.sign))]
    simple = [
        n for n in nodes if n.free_symbols and (n.is_Symbol or isinstance(n, CIRCULAR_FUNCTIONS))
    ]
    sums = [node for node in nodes if node.is_Add and node.free_symbols]
    known = list(dict.fromkeys([*absolute, *simple]))
    yield from known
    yield from (left * right for left, right in combinations(known[:8], 2))
    yield from dict.fromkeys(sums)


def _is_strict(form: NormalForm, parts: Sequence[_Part]) -> bool:
    """Whether the formula is undefined where a part is zero: a factor of it is in a denominator."""
    denominator = form.fraction.denominator
    for name in frozenset().union(*(part.places for part in parts)):
        if denominator.gcd(form.basis.factors[int(name[1:])]) != 1:
            return True
    return False
