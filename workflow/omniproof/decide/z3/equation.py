"""A third opinion on small formulas: z3 looks for real numbers at which two sides differ.

A difference of fractions is multiplied out (left as fractions, most are answered "unknown"). The
procedure behind it, nlsat, is a cylindrical algebraic decomposition; there are no random points, no
prime fields and no balls. It grows doubly exponentially, so only small formulas without roots of
variables are asked, with a limit on z3's own count of steps: the answer does not depend on the
speed of the machine. z3 is imported when the first such formula comes.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

from omniproof.decide.z3.translation import OutsideError, Translation, refuse_large
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.functions import CIRCULAR
from omniproof.formula.monomials import expand, joined
from omniproof.formula.term import Call, Pi, Term, symbols, walk

STEPS = 100_000
NOWHERE = "there is no point at which both sides are defined"


@dataclass(frozen=True)
class Equal:
    """There are no real numbers at which the sides differ, and some at which they are defined.

    What was `widened` may be defined nowhere: a part that cancels was left out.
    """

    widened: bool = False


@dataclass(frozen=True)
class Different:
    """At these numbers (cosines, sines and symbols, as z3 writes them) the sides differ."""

    model: Mapping[str, str]


@dataclass(frozen=True)
class NoAnswer:
    """z3 was not asked, or found nothing within its limit of steps."""

    reason: str


SmtAnswer = Equal | Different | NoAnswer


@lru_cache(maxsize=1024)
def differ_somewhere(
    printed: Term,
    derived: Term,
    assumed: frozenset[tuple[str, str]] = frozenset(),
    steps: int = STEPS,
) -> SmtAnswer:
    r"""Ask z3 for a real point at which both sides are defined and differ.

    `assumed` are pairs of a symbol's name and how it stands to 0: `("r", ">")`, `("L", "\\neq")`.
    """
    try:
        refuse_large(printed, derived)
        return _Question(printed, derived, assumed).answer(steps)
    except (OutsideError, UnsupportedError) as reason:
        return NoAnswer(str(reason))


class _Question(Translation):
    def __init__(self, left: Term, right: Term, assumed: frozenset[tuple[str, str]]) -> None:
        plain = [_without_what_cancels(side) for side in (left, right)]
        super().__init__(plain, assumed)
        self.widened = plain != [left, right]
        self.left, self.right = map(self.fraction, plain)
        self.refuse_many_variables()

    def answer(self, steps: int) -> SmtAnswer:
        """Ask for a model of: both sides defined, and different when multiplied out."""
        left, right = self.left, self.right
        defined = [side.below != 0 for side in (left, right) if side.below is not self.one]
        differ = left.above * right.below != right.above * left.below
        verdict, model = self.check(steps, *defined, differ)
        if verdict == self.z3.unsat:
            nowhere = (defined or self.conditions) and self.check(steps, *defined)[0]
            return NoAnswer(NOWHERE) if nowhere == self.z3.unsat else Equal(self.widened)
        if verdict != self.z3.sat:
            return NoAnswer(f"no answer within {steps} steps")
        if self.is_mixed:
            return NoAnswer("a symbol is both angle and number: its point may not exist")
        if self.widened:
            return NoAnswer("a part that cancels may be undefined at the point that was found")
        return Different({str(name): str(model[name]) for name in sorted(model, key=str)})


def _without_what_cancels(side: Term) -> Term:
    """Leave out a root or a pi of which nothing is left in a side that is multiplied out.

    So `0 / sqrt(x)` and `2 pi - (x + 2 pi)` are asked; where they are defined is forgotten.
    """
    outside = set(filter(_is_outside, walk(side)))
    if not outside:
        return side
    try:
        plain = joined(expand(side))
    except UnsupportedError:
        return side
    return side if outside.intersection(walk(plain)) else plain


def _is_outside(part: Term) -> bool:
    """Whether a part is no rational function of symbols, cosines and sines."""
    if isinstance(part, Call):
        return part.function not in CIRCULAR and bool(symbols(part))
    return isinstance(part, Pi)
