"""Parts that recur are numbers like any others: an identity in them is one in what they stand for.

A printed optimum with everything put in has 4 000 operations and 20 000 terms when it is multiplied
out, and yet says something of ten coefficients only. As terms keep what was put in as it is, these
show as sums that occur more than once. A symbol takes the place of each, of the large ones first;
as long as too much is forgotten, the formula is not zero at a random point, which takes a
microsecond to see. What is zero with fewer and smaller parts replaced goes to the normal form.
"""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Iterator

from flint import arb, fmpq

from omniproof.decide.balls import compile_balls
from omniproof.decide.normal_form.form import normal_form
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.functions import CIRCULAR
from omniproof.formula.term import Call, Sum, Symbol, Term, rebuild, subtract, symbols, walk


def vanishes_in_parts(left: Term, right: Term) -> bool:
    """Whether a difference is zero whatever numbers stand for its parts; False tells nothing.

    Where it is not defined is forgotten.
    """
    try:
        forms = _with_symbols_for_parts(subtract(left, right))
        found = next(filter(_seems_zero, forms), None)
        return found is not None and normal_form(found).is_zero
    except UnsupportedError:
        return False


def _with_symbols_for_parts(term: Term) -> Iterator[Term]:
    """Yield a term with symbols for the sums that recur: for all of them, then without the largest.

    An angle stays as it is: of its parts, cosine and sine would be lost.
    """
    sizes = _sizes(term)
    places = Counter(inner for part in walk(term) for inner in part.parts)
    recurring = {
        part for part, count in places.items()
        if count > 1 and isinstance(part, Sum) and symbols(part)
    }  # fmt: skip
    for largest in sorted({sizes[part] for part in recurring}, reverse=True):
        new: dict[Term, Term] = {}

        def change(part: Term, largest: int = largest, new: dict[Term, Term] = new) -> Term | None:
            if part in recurring and sizes[part] <= largest:
                return new.setdefault(part, Symbol(f"#{len(new)}"))
            return part if isinstance(part, Call) and part.function in CIRCULAR else None

        yield rebuild(term, change)


def _sizes(term: Term) -> dict[Term, int]:
    """Count the operations in each part of a term."""
    sizes: dict[Term, int] = {}
    for part in walk(term):
        sizes[part] = max(len(part.parts) - 1, 1) + sum(sizes[inner] for inner in part.parts)
    return sizes


def _seems_zero(term: Term) -> bool:
    """Whether a term is not told from zero at a random point."""
    names = sorted(symbols(term))
    generator = random.Random(0)  # noqa: S311 - a point, not a secret
    point = [arb(fmpq(generator.randint(1, 99), generator.randint(100, 199))) for _ in names]
    return bool(compile_balls([term], names).run(point)[0].contains(0))
