r"""What a formula that stands alone does not tell of itself, and what would then be guessed.

A paper's list of symbols says that `d` is a length, `R` a matrix and `f` a function. Without one, a
statement whose truth hangs on it is refused, with the way to write what was meant.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import NoReturn

from omniproof.transcription import tree
from omniproof.transcription.symbols import DIFFERENCES
from omniproof.transcription.tokens import NO_DERIVATIVES, LatexError

CONSTANTS = {
    "e": "`e` may be Euler's number or a symbol",
    "i": "`i` may be the imaginary unit or a symbol",
}
OPERATORS = {"\\nabla": "`\\nabla` is an operator", "\\mathrm{d}": "`\\mathrm{d}` is an operator"}
POINTS = re.compile(r"\\angle .*|\\(?:vec|overrightarrow|overline|widehat)\{[A-Z]{2,}\}")
"""Names made of points: `\\overrightarrow{AB}`."""
ARRAYS = re.compile(
    r"\\(?:mathbf|boldsymbol|bm|vec|overrightarrow|underline)(?![A-Za-z])"
    r"|\\(?:mathrm|mathsf|mathbb|mathcal|mathfrak)\s*\{?\s*[A-Z]"
)
"""What is set like this is a vector or a matrix, as long as nobody says otherwise."""
FONTS = re.compile(r"\\(mathbf|boldsymbol|bm|mathrm|mathbb|mathcal|mathsf|mathfrak)(?![A-Za-z])")
CAPITAL = re.compile(r"[A-Z](?:_.*)?")
IN_ENTRIES = "write the entries of vectors and matrices out"


def refuse_unclear(node: tree.Node, text: str, functions: Mapping[str, str]) -> None:
    """Raise `LatexError` for the first part of a statement that has several meanings."""
    _Unclear(node, text, functions).refuse()


def refuse_mixed_differences(node: tree.Node, text: str) -> None:
    r"""Raise `LatexError` where `\Delta` stands for itself and in `\Delta x`, too."""
    alone = {item.name for item in tree.walk(node) if isinstance(item, tree.Name | tree.Applied)}
    for item in tree.walk(node):
        if not isinstance(item, tree.Name | tree.Applied):
            continue
        sign, _, of = item.name.partition(" ")
        if sign == "d" and text.startswith("\\mathrm", item.span[0]):
            sign = "\\mathrm{d}"
        if sign in DIFFERENCES and ((of and sign in alone) or isinstance(item, tree.Applied)):
            message = f"`{item.name}` may be a difference or a product"
            cure = f"write `{sign} \\cdot …` for the product"
            raise LatexError(message, text, item.span, cure)


def refuse_if_false(node: tree.Node, text: str) -> None:
    r"""Raise `LatexError` for what may be true after all of an equation that is false of numbers.

    A differential `\mathrm{d}y` hangs on others, and a side `AB` may be one quantity.
    """
    for item in tree.walk(node):
        if _is_differential(item):
            message = (
                f"what `{text[slice(*item.span)]}` has to do with other differentials is not known"
            )
            raise LatexError(message, text, item.span, NO_DERIVATIVES)
    for side in node.sides if isinstance(node, tree.Chain) else ():
        factors = _factors(side)
        names = [each.name for each in factors if isinstance(each, tree.Name)]
        together = all(one.span[1] == other.span[0] for one, other in pairwise(factors))
        if len(names) == len(factors) == 2 and together and all(map(CAPITAL.fullmatch, names)):
            message = f"`{''.join(names)}` may be one symbol or a product"
            cure = "write `{} {}` for the product, a letter with an index for one symbol"
            raise LatexError(message, text, side.span, cure.format(*names))


class _Unclear:
    """The questions to one statement; `functions` are letters that stand for functions."""

    def __init__(self, node: tree.Node, text: str, functions: Mapping[str, str]) -> None:
        self.node, self.text, self.functions = node, text, functions
        self.all = tuple(tree.walk(node))
        self.arrays = frozenset(self._arrays())

    def refuse(self) -> None:
        for item in self.all:
            if isinstance(item, tree.Name):
                self.name(item)
            if isinstance(item, tree.Applied):
                self.applied(item)
            if isinstance(item, tree.Quotient):
                self.derivative(item)
            if isinstance(item, tree.Product):
                self.powers_applied(item)
                self.mixed_number(item)
        self.fonts()
        self.differentials()
        self.functions_of_sums()
        for item in self.all:
            self.commuting(item)

    def say(self, item: tree.Node, message: str, cure: str) -> NoReturn:
        raise LatexError(message, self.text, item.span, cure)

    def printed(self, item: tree.Node) -> str:
        return " ".join(self.text[slice(*item.span)].split())

    def name(self, item: tree.Name) -> None:
        """Refuse constants, operators, and what needs the entries of a matrix."""
        if item.name in CONSTANTS:
            cure = f"give a symbol an index: `{item.name}_1`; exponentials and complex numbers are "
            self.say(item, CONSTANTS[item.name], f"{cure}not read")
        if item.name in self.functions:
            message = f"`{item.name}` stands for `\\{self.functions[item.name]}`, and here for a "
            self.say(item, f"{message}symbol", f"write `{item.name}(…)` for the function")
        if item.name.startswith("\\det "):
            self.say(item, f"`{item.name}` needs the entries of the matrix", "write the matrix out")
        if POINTS.match(item.name):
            message = f"what `{item.name}` has to do with other points is not known"
            self.say(item, message, "give it a letter of its own")
        upright = item.name == "d" and "mathrm" in self.printed(item)
        base = "\\mathrm{d}" if upright else re.split("[_^]", item.name)[0]
        if base in OPERATORS:
            self.say(item, OPERATORS[base], NO_DERIVATIVES)

    def applied(self, item: tree.Node) -> NoReturn:
        """Refuse `f(x)`, which may be a product."""
        printed = self.printed(item)
        head, _, bracketed = printed.replace("\\left(", "(").partition("(")
        cure = f"write `{head.strip()} \\cdot ({bracketed}` for the product"
        self.say(item, f"`{printed}` may be a function or a product", cure)

    def powers_applied(self, item: tree.Product) -> None:
        r"""Refuse `R^{-1}(\theta)`, which may be the inverse function or matrix."""
        for first, second in pairwise(item.factors):
            begin, end = first.span[1], second.span[0]
            raised = isinstance(first, tree.Power | tree.Transpose)
            base = tree.children(first)[0] if raised else first
            if not raised or "*" in self.text[begin:end] or self.text[end : end + 1] != "(":
                continue
            if isinstance(base, tree.Name) and not isinstance(second, tree.Sum):
                self.applied(tree.Node(span=(first.span[0], second.span[1])))

    def mixed_number(self, item: tree.Product) -> None:
        r"""Refuse `1\frac{1}{2}`, which may be 3/2."""
        for first, second in pairwise(item.factors):
            fraction = isinstance(second, tree.Quotient) and all(
                isinstance(part, tree.Number) for part in tree.children(second)
            )
            begin, end = first.span[1], second.span[0]
            if isinstance(first, tree.Number) and fraction and "*" not in self.text[begin:end]:
                both = tree.Node(span=(first.span[0], second.span[1]))
                message = f"`{self.printed(both)}` may be a sum or a product"
                self.say(both, message, "write `+` or `\\cdot` between number and fraction")

    def derivative(self, item: tree.Quotient) -> None:
        r"""Refuse `\frac{dy}{dx}`."""
        above, below = _factors(item.numerator)[0], _factors(item.denominator)
        plain = len(below) > 1 and _is_d(below[0]) and _is_d(_base(above))
        upright = _is_differential(_base(below[0])) and (
            _is_differential(_base(above)) or _is_d(_base(above))
        )
        if plain or upright:
            cure = f"{NO_DERIVATIVES}; write `d \\cdot x` for a product"
            self.say(item, f"`{self.printed(item)}` may be a derivative or a quotient", cure)

    def differentials(self) -> None:
        """Refuse `dx`, unless `d` stands for itself somewhere."""
        followed = [
            (first, second)
            for item in self.all
            if isinstance(item, tree.Product)
            for first, second in pairwise(item.factors)
            if _is_d(first) and isinstance(second, tree.Name)
        ]
        alone = sum(_is_d(item) for item in self.all) - len(followed)
        if followed and not alone:
            first, second = followed[0]
            both = tree.Node(span=(first.span[0], second.span[1]))
            message = f"`{self.printed(both)}` may be a differential or a product"
            self.say(both, message, f"write `d \\cdot {self.printed(second)}` for the product")

    def functions_of_sums(self) -> None:
        """Refuse `f(x + 1) = …` of an `f` that stands nowhere else."""
        names = [item.name for item in self.all if isinstance(item, tree.Name)]
        for side in self.node.sides if isinstance(self.node, tree.Chain) else ():
            match side:
                case tree.Product(factors=(tree.Name(name=name) as first, tree.Sum() as second)):
                    between = self.text[first.span[1] : second.span[0] + 1]
                    if names.count(name) == 1 and re.fullmatch(r"\s*(\\left)?\s*\(", between):
                        self.applied(side)

    def fonts(self) -> None:
        """Refuse one letter in two fonts: they would be read as one symbol."""
        seen: dict[str, tree.Name] = {}
        for item in self.all:
            if not isinstance(item, tree.Name):
                continue
            other = seen.setdefault(item.name, item)
            fonts = {tuple(sorted(FONTS.findall(self.printed(each)))) for each in (item, other)}
            if len(fonts) > 1:
                both = f"`{self.printed(other)}` and `{self.printed(item)}`"
                self.say(item, f"{both} would be read as one symbol", "give one another letter")

    def _arrays(self) -> Iterator[str]:
        """Names of vectors and matrices: by their font, or by `^T` and `^{-1}` of a capital."""
        names = [item for item in self.all if isinstance(item, tree.Name)]
        marked = {item.name for item in names if ARRAYS.search(self.printed(item))}
        yield from marked
        if marked or any(map(is_raised, self.all)):
            yield from (item.name for item in names if CAPITAL.fullmatch(item.name))

    def has_array(self, item: tree.Node) -> bool:
        return not self.arrays.isdisjoint(tree.names(item))

    def commuting(self, item: tree.Node) -> None:
        """Refuse what is true or false of numbers, and may not be so of vectors and matrices."""
        cure = IN_ENTRIES
        match item:
            case tree.Norm(operand=operand):
                unclear = bool(tree.names(operand)) and not _has_literal(operand)
            case tree.Cross(left=left, right=right) if not _has_literal(item):
                unclear = bool(tree.names(left) and tree.names(right))
                cure = f"{IN_ENTRIES}; write `\\cdot` between numbers"
            case tree.Product() | tree.Dot() | tree.Cross() | tree.Inner():
                unclear = self._multiplied(tree.children(item))
            case tree.Quotient(denominator=below):
                unclear = self.has_array(below)
            case tree.Power() | tree.Transpose() | tree.Call() | tree.Absolute():
                unclear = self.has_array(item)
            case tree.Comparison():
                unclear = self.has_array(item)
            case _:
                return
        if unclear:
            message = f"`{self.printed(item)}` may be of vectors or matrices, which do not commute"
            self.say(item, message, cure)

    def _multiplied(self, factors: tuple[tree.Node, ...]) -> bool:
        """Whether a named vector or matrix meets another one, or a printed one."""
        named = sum(map(self.has_array, factors))
        printed = sum(map(_has_literal, factors))
        return named > 1 or (named > 0 and printed > 0)


def is_raised(node: tree.Node) -> bool:
    """Whether a node is written as matrices are: transposed, or the inverse of capitals."""
    if isinstance(node, tree.Power) and node.exponent == -1:
        factors = _factors(node.base)
        return all(isinstance(each, tree.Name) and CAPITAL.fullmatch(each.name) for each in factors)
    return isinstance(node, tree.Transpose)


_LITERALS = (tree.MatrixLiteral, tree.Tuple)


def _has_literal(node: tree.Node) -> bool:
    """Whether a vector or matrix is printed with its entries."""
    return any(isinstance(part, _LITERALS) for part in tree.walk(node))


def _factors(node: tree.Node) -> tuple[tree.Node, ...]:
    return node.factors if isinstance(node, tree.Product) else (node,)


def _base(node: tree.Node) -> tree.Node:
    return node.base if isinstance(node, tree.Power) else node


def _is_d(node: tree.Node) -> bool:
    return isinstance(node, tree.Name) and node.name == "d"


def _is_differential(node: tree.Node) -> bool:
    return isinstance(node, tree.Name) and node.name.startswith("\\mathrm{d} ")
