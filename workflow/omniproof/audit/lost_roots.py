r"""Where printed roots are defined that SymPy multiplies away: `(\sqrt{x})^2` becomes `x`.

An identity is asserted wherever both sides are defined. A value that has forgotten a root would be
judged where the print says nothing, and a true line would be called false there.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy as sp

from omniproof.transcription.tree import Call, Node, walk


def lost_roots(node: Node, value: Callable[[Node], Any]) -> tuple[Any, ...]:
    """Return `radicand >= 0` for each printed root that its product or power no longer shows.

    `value` gives the value of a part of the tree. What has a root without being printed as one (a
    quantity, say) keeps the domain of its value.
    """
    parts = [part for part in walk(node) if isinstance(part, Call) and part.function == "sqrt"]
    if not parts:
        return ()
    kept = _roots(value(node))
    radicands = dict.fromkeys(value(part.argument) for part in parts)
    lost = (x for x in radicands if x.free_symbols and not x.is_nonnegative)
    return tuple(sp.Ge(x, 0) for x in lost if not _roots(sp.sqrt(x)) & kept)


def _roots(value: Any) -> set[Any]:
    if isinstance(value, tuple):
        return set().union(*map(_roots, value))
    powers = value.atoms(sp.Pow)
    return {power.base for power in powers if power.exp.is_Rational and not power.exp.is_Integer}
