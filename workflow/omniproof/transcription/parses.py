r"""Every way to read a formula that its print leaves open, and the words to say which."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import product
from math import prod

from omniproof.transcription.arguments import Argument
from omniproof.transcription.conventions import Names, Writing
from omniproof.transcription.reader import Reader, read_with
from omniproof.transcription.tokens import LatexError
from omniproof.transcription.tree import Node


@dataclass(frozen=True)
class Parse:
    """One way to read a formula; `chosen` are the printed terms and how they were read."""

    node: Node
    chosen: tuple[tuple[str, str], ...] = ()


MOST_PARSES = 32
"""More readings than these take seconds to judge; then only the consistent ones are looked at."""


def parses(text: str, notation: Writing, names: Names) -> tuple[tuple[Parse, ...], bool]:
    r"""Read a formula in each way that its print allows, the usual one first.

    Print leaves open whether an argument without brackets takes in the factors after it:
    `\cos\theta T`. Tells, too, whether these are all of them.
    """
    first = Reader(text, names, notation, {})
    node = first.document()
    arguments = tuple(first.arguments.values())
    ways: Iterable[tuple[int, ...]] = product(*(range(len(each.ends)) for each in arguments))
    complete = prod(len(each.ends) for each in arguments) <= MOST_PARSES
    if not complete:
        ways = ((0,) * len(arguments), tuple(len(each.ends) - 1 for each in arguments))
    usual = tuple(each.usual for each in arguments)
    found = [_parse(text, node, arguments, usual)]
    for way in ways:
        if way != usual:
            reach = {each.start: end for each, end in zip(arguments, way, strict=True)}
            try:
                other = read_with(text, notation, names, reach)
            except LatexError:  # no formula in this reading
                continue
            found.append(_parse(text, other, arguments, way))
    return tuple(found), complete


def _parse(text: str, node: Node, arguments: Sequence[Argument], way: Sequence[int]) -> Parse:
    """Say of each argument that was open what was printed and how it was read."""
    chosen = {}
    for each, end in zip(arguments, way, strict=True):
        printed = text[each.function : each.ends[-1]]
        function = _balanced(text[each.function : each.start]).strip()
        argument = _balanced(text[each.start : each.ends[end]]).strip()
        rest = _balanced(text[each.ends[end] : each.ends[-1]])
        chosen[_balanced(printed)] = f"{function}({argument}){rest}"
    return Parse(node, tuple(chosen.items()))


def _balanced(text: str) -> str:
    """Leave out the braces whose partner was cut off."""
    opened: list[int] = []
    alone: set[int] = set()
    for place, sign in enumerate(text):
        if sign == "{":
            opened.append(place)
        elif sign == "}":
            alone.add(place) if not opened else opened.pop()
    alone.update(opened)
    return "".join(sign for place, sign in enumerate(text) if place not in alone)
