r"""What may be assumed of the symbols of one formula: their names, signs and ranges.

Nothing declares the symbols of a formula from the command line, so every symbol met is a free real
number. What would then be read wrongly in silence is refused, see `unclear`.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field
from difflib import get_close_matches
from functools import cached_property
from typing import NoReturn

from omniproof.decide.domain import REAL_LINE, Domain, Range
from omniproof.decide.exact import sign
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.term import ZERO, Call, Symbol, Term, number, subtract
from omniproof.formula.unfold import unfold
from omniproof.formula.value import kind
from omniproof.transcription import tree
from omniproof.transcription.conventions import ALONE, Conventions
from omniproof.transcription.faults import nearest
from omniproof.transcription.functions import SHORTENED
from omniproof.transcription.parses import Parse, parses
from omniproof.transcription.reader import read_with
from omniproof.transcription.symbols import symbol_name
from omniproof.transcription.tokens import LatexError

LARGEST_BOUND = number(10**300)
"""Samples are drawn between floats, which end at 10^308."""
_ACCENT = re.compile(r"^\\(?:wide)?(hat|bar|tilde|dot|ddot|vec)\{(\\?[A-Za-z]+)\}")
_PLAIN = re.compile("[A-Za-z][A-Za-z0-9]*(?:__?[A-Za-z0-9]+)*")


@dataclass(frozen=True)
class Assumptions:
    r"""What is said besides the formula, in LaTeX.

    `positive` are symbols, `between` ranges such as `0 < \theta < 90^\circ`; `functions` and
    `slash` are conventions of writing, as in `reader.Conventions`.
    """

    positive: tuple[str, ...] = ()
    between: tuple[str, ...] = ()
    functions: Mapping[str, str] = field(default_factory=dict)
    slash: str | None = None

    def read(self, text: str) -> tree.Node:
        """Read a formula in the usual way with these conventions; raises `LatexError`."""
        return read_with(text, self._conventions(), ALONE, {})

    def parses(self, text: str) -> tuple[tuple[Parse, ...], bool]:
        """Read a formula in every way, as `parses.parses` does; raises `LatexError`."""
        return parses(text, self._conventions(), ALONE)

    def _conventions(self) -> Conventions:
        for short, function in self.functions.items():
            if function not in SHORTENED:
                near = get_close_matches(function, SHORTENED, n=1) or ["cos"]
                _refuse(f"{short}={function}", f"the function `{function}` is not read",
                        f"did you mean `{short}={near[0]}`?")  # fmt: skip
        return Conventions(self.functions, self.slash)


@dataclass(frozen=True)
class Setting:
    """A plain name for each canonical name of a formula, and the domain of all symbols."""

    names: Mapping[str, str]
    domain: Domain

    @cached_property
    def letters(self) -> dict[str, Symbol]:
        """What each symbol of the formula stands for."""
        return {printed: Symbol(name) for printed, name in self.names.items()}


def settle(node: tree.Node, assumptions: Assumptions) -> Setting:
    """Give each symbol of a formula its range.

    Raises `LatexError` for an assumption that cannot be read, is empty, or is about a symbol that
    the formula does not have.
    """
    found = sorted(tree.names(node))
    ranges = _ranges(found, assumptions)
    spelled = _spell(found)
    return Setting(spelled, Domain({spelled[name]: range_ for name, range_ in ranges.items()}))


def _spell(found: Collection[str]) -> dict[str, str]:
    r"""Names without LaTeX, from which SymPy prints LaTeX again: `\alpha_1` gives `alpha_1`.

    A name that has no such spelling, or shares it with another, stays as it is.
    """
    plain = {name: _plain(name) for name in found}
    taken = list(plain.values())
    return {
        name: short if _PLAIN.fullmatch(short) and taken.count(short) == 1 else name
        for name, short in plain.items()
    }


def _plain(name: str) -> str:
    name = _ACCENT.sub(r"\2\1", name).replace("'", "prime").replace("^", "__")
    if re.search(r"\\[A-Za-z]+\{", name):  # an accent over more than a letter
        return name
    return re.sub(r"[\\{}]", "", re.sub(r"[, ]+", "_", name))


def _ranges(found: Collection[str], assumptions: Assumptions) -> dict[str, Range]:
    ranges: dict[str, Range] = {}
    for name, limits, text in _limits(assumptions):
        if name not in found:
            cure = nearest(name, found, "leave the assumption out")
            _refuse(text, f"the formula has no symbol `{name}`", cure)
        (low, high), (lower, upper) = ranges.get(name, REAL_LINE), limits
        both = _farther(low, lower, 1), _farther(high, upper, -1)
        if _is_empty(*both):
            _refuse(text, f"the range of `{name}` is empty", "write the smaller bound on the left")
        ranges[name] = both
    return ranges


def _farther(one: Term | None, other: Term | None, side: int) -> Term | None:
    """Return the larger of two lower ends (side 1), or the smaller of two upper ones (side -1)."""
    if one is None or other is None:
        return other if one is None else one
    return one if side * sign(subtract(one, other)) >= 0 else other


def _is_empty(lower: Term | None, upper: Term | None) -> bool:
    return lower is not None and upper is not None and sign(subtract(upper, lower)) <= 0


def _limits(assumptions: Assumptions) -> Iterator[tuple[str, Range, str]]:
    """Yield symbol, range, and the text that says so."""
    for text in assumptions.positive:
        yield symbol_name(text), (ZERO, None), text
    for text in assumptions.between:
        node = assumptions.read(text)
        together = isinstance(node, tree.Logic) and node.operator == "and"
        parts = tree.children(node) if together else (node,)
        for part in parts:
            yield *_limit(part, text), text


def _limit(part: tree.Node, text: str) -> tuple[str, Range]:
    r"""Read `a < x` or `x < b`."""
    if not isinstance(part, tree.Comparison) or part.operator not in {"<", ">"}:
        _refuse(text, "expected a range with `<`", r"write `0 < x < 1`: ends do not belong to it")
    below, above = part.left, part.right
    if part.operator == ">":
        below, above = above, below
    if isinstance(above, tree.Name):
        return above.name, (_bound(below, text), None)
    if isinstance(below, tree.Name):
        return below.name, (None, _bound(above, text))
    return _refuse(text, "expected one symbol between two numbers", "write `0 < x < 1`")


def _bound(node: tree.Node, text: str) -> Term:
    if tree.names(node):
        _refuse(text, "expected a number as the end of a range", "write `0 < x < 1`")
    value = unfold(node, {}, text)
    if not isinstance(value, Term):
        _refuse(
            text,
            f"expected a number as the end of a range, found {kind(value)}",
            "write `0 < x < 1`",
        )
    try:
        sign(value)
        within_reach = sign(subtract(LARGEST_BOUND, Call("abs", (value,)))) > 0
    except UnsupportedError as reason:
        _refuse(text, f"expected a number as the end of a range: {reason}", "write `0 < x < 1`")
    if not within_reach:
        _refuse(text, "expected a number below 10^300 as the end of a range", "leave the end out")
    return value


def _refuse(text: str, message: str, cure: str) -> NoReturn:
    raise LatexError(message, text, (0, len(text)), cure)
