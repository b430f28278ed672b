r"""What a statement defines: nothing is to prove of a symbol that stands nowhere else.

`v = \omega r` says what v is. It is no identity, true or false, and has no repair.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace

from omniproof.audit.unclear import CONSTANTS, is_raised
from omniproof.transcription import tree

IDENTITY = re.compile("I(_.*)?")
"""Where matrices are transposed or inverted, this is the unit matrix and no new symbol."""


@dataclass(frozen=True)
class Definitions:
    """The symbols that a statement defines, and what of it is left to judge (`None`: nothing).

    `sought` are symbols that it may define, too, or be an equation for.
    """

    defined: tuple[tree.Symbolic, ...]
    rest: tree.Node | None
    sought: tuple[tree.Symbolic, ...] = ()


def definitions(node: tree.Node) -> Definitions:
    """Take the definitions out of an equation, a chain of them, or a list.

    A side defines if it is one symbol that stands nowhere else in its equation nor in one before,
    or, as the first side, a vector or matrix of such symbols. Of a chain, the other sides are left.
    """
    before: set[str] = set()
    found: list[Definitions] = []
    for item in node.items if isinstance(node, tree.Listing) else (node,):
        found.append(_taken_apart(item, before))
        before |= tree.names(item)
    defined, sought = (
        tuple(symbol for each in found for symbol in getattr(each, name))
        for name in ("defined", "sought")
    )
    left = tuple(each.rest for each in found if each.rest is not None)
    if len(left) > 1:
        return Definitions(defined, tree.Listing(left, span=node.span), sought)
    return Definitions(defined, left[0] if left else None, sought)


def _taken_apart(node: tree.Node, before: set[str]) -> Definitions:
    if not isinstance(node, tree.Chain) or node.relation != "=" or node.continued:
        return Definitions((), node)
    known = Counter(_all_names(node)) + Counter(before)
    if any(map(is_raised, tree.walk(node))):
        known += Counter(name for name in known if IDENTITY.fullmatch(name))
    new = {
        place: symbols
        for place, side in enumerate(node.sides)
        if (symbols := _symbols(side)) and all(known[symbol.name] == 1 for symbol in symbols)
    }
    defining = [place for place in new if place == 0 or new[place] == (node.sides[place],)]
    sides = tuple(side for place, side in enumerate(node.sides) if place not in defining)
    return Definitions(
        tuple(symbol for place in defining for symbol in new.pop(place)),
        replace(node, sides=sides) if len(sides) > 1 else None,
        tuple(symbol for symbols in new.values() for symbol in symbols),
    )


def _all_names(node: tree.Node) -> Iterator[str]:
    """The name of each symbol, as often as it stands there."""
    return (item.name for item in tree.walk(node) if isinstance(item, tree.Name | tree.Applied))


def _symbols(side: tree.Node) -> tuple[tree.Symbolic, ...]:
    r"""The symbols that a side consists of; nothing if there is more to it.

    `\det A` is none: it follows from A; nor is `e`, which may be a number.
    """
    entries: tuple[tree.Node, ...] = (side,)
    if isinstance(side, tree.MatrixLiteral):
        entries = tuple(entry for row in side.rows for entry in row)
    elif isinstance(side, tree.Tuple):
        entries = side.items
    found = tuple(
        entry
        for entry in entries
        if isinstance(entry, tree.Name | tree.Applied)
        and not (entry.name.startswith("\\det ") or entry.name in CONSTANTS)
    )
    return found if len(found) == len(entries) else ()
