r"""What may be assumed of the symbols of one formula: their names, signs and ranges.

Nothing declares the symbols of a formula from the command line, so every symbol met is a free real
number. What would then be read wrongly in silence is refused, see `unclear`.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field
from difflib import get_close_matches
from typing import Any, NoReturn

import sympy as sp

from omniproof.audit.exact import sign, subtract
from omniproof.audit.sympy_domain import REAL_LINE, Domain
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.evaluation import evaluate
from omniproof.formula.term import Symbol
from omniproof.transcription import tree
from omniproof.transcription.conventions import ALONE, Conventions
from omniproof.transcription.faults import nearest
from omniproof.transcription.functions import SHORTENED
from omniproof.transcription.parses import Parse, parses
from omniproof.transcription.reader import read_with
from omniproof.transcription.symbols import symbol_name
from omniproof.transcription.tokens import LatexError

LARGEST_BOUND = sp.Integer(10) ** 300
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
    """SymPy's symbol for each canonical name of a formula, and the domain of all of them."""

    meanings: Mapping[str, sp.Symbol]
    domain: Domain

    @property
    def letters(self) -> dict[str, Symbol]:
        """The same symbols, in terms."""
        return {name: Symbol(symbol.name) for name, symbol in self.meanings.items()}


def settle(node: tree.Node, assumptions: Assumptions) -> Setting:
    """Give each symbol of a formula its sign and range.

    Raises `LatexError` for an assumption that cannot be read, is empty, or is about a symbol that
    the formula does not have.
    """
    found = sorted(tree.names(node))
    ranges = _ranges(found, assumptions)
    spelled = _spell(found)
    meanings = {name: _symbol(spelled[name], *ranges.get(name, REAL_LINE)) for name in found}
    return Setting(meanings, Domain({spelled[name]: range_ for name, range_ in ranges.items()}))


def _symbol(name: str, lower: Any, upper: Any) -> sp.Symbol:
    if lower.is_nonnegative:
        return sp.Symbol(name, positive=True)
    return sp.Symbol(name, **({"negative": True} if upper.is_nonpositive else {"real": True}))


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


def _ranges(found: Collection[str], assumptions: Assumptions) -> dict[str, tuple[Any, Any]]:
    ranges: dict[str, tuple[Any, Any]] = {}
    for name, lower, upper, text in _limits(assumptions):
        if name not in found:
            cure = nearest(name, found, "leave the assumption out")
            _refuse(text, f"the formula has no symbol `{name}`", cure)
        old = ranges.get(name, REAL_LINE)
        both = _larger(old[0], lower), -_larger(-old[1], -upper)
        if sp.oo not in (-both[0], both[1]) and sign(subtract(both[1], both[0])) <= 0:
            _refuse(text, f"the range of `{name}` is empty", "write the smaller bound on the left")
        ranges[name] = both
    return ranges


def _larger(a: Any, b: Any) -> Any:
    if -sp.oo in (a, b):
        return b if a == -sp.oo else a
    return a if sign(subtract(a, b)) >= 0 else b


def _limits(assumptions: Assumptions) -> Iterator[tuple[str, Any, Any, str]]:
    """Yield symbol, lower and upper bound, and the text that says so."""
    for text in assumptions.positive:
        yield symbol_name(text), sp.Integer(0), sp.oo, text
    for text in assumptions.between:
        node = assumptions.read(text)
        together = isinstance(node, tree.Logic) and node.operator == "and"
        parts = tree.children(node) if together else (node,)
        for part in parts:
            yield *_limit(part, text), text


def _limit(part: tree.Node, text: str) -> tuple[str, Any, Any]:
    r"""Read `a < x` or `x < b`."""
    if not isinstance(part, tree.Comparison) or part.operator not in {"<", ">"}:
        _refuse(text, "expected a range with `<`", r"write `0 < x < 1`: ends do not belong to it")
    below, above = part.left, part.right
    if part.operator == ">":
        below, above = above, below
    if isinstance(above, tree.Name):
        return above.name, _bound(below, text), sp.oo
    if isinstance(below, tree.Name):
        return below.name, -sp.oo, _bound(above, text)
    return _refuse(text, "expected one symbol between two numbers", "write `0 < x < 1`")


def _bound(node: tree.Node, text: str) -> Any:
    if tree.names(node):
        _refuse(text, "expected a number as the end of a range", "write `0 < x < 1`")
    value = evaluate(node, {}, text)
    try:
        sign(value)
        within_reach = sign(subtract(LARGEST_BOUND, sp.Abs(value))) > 0
    except UnsupportedError as reason:
        _refuse(text, f"expected a number as the end of a range: {reason}", "write `0 < x < 1`")
    if not within_reach:
        _refuse(text, "expected a number below 10^300 as the end of a range", "leave the end out")
    return value


def _refuse(text: str, message: str, cure: str) -> NoReturn:
    raise LatexError(message, text, (0, len(text)), cure)
