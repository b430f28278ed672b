r"""A printed tree as boxes on a line: what stands where, for every notation of people alike.

Which sign stands between two parts, what goes over a line or into a script, and where brackets are
needed is decided once, here; a notation only says how each box is written. Brackets are set by the
binding strength of the parts. A formula that has been printed keeps its own: `source` is the text
that the tree was read from, and tells by the places of its parts where brackets stand, whether a
slash divides, and which name a function has.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, TypeAlias

from omniproof.transcription import tree
from omniproof.transcription.functions import FUNCTIONS
from omniproof.transcription.tokens import Token, tokenize

Row: TypeAlias = "tuple[Box, ...]"
"""Boxes side by side."""
Parts: TypeAlias = tuple[Row, ...]
STATEMENT, SUM, NEGATIVE, PRODUCT, POWER, ATOM = range(6)
"""Binding strengths, the weakest first."""

STRENGTHS: dict[type[tree.Node], int] = {
    tree.Chain: STATEMENT, tree.Comparison: STATEMENT, tree.Logic: STATEMENT,
    tree.Listing: STATEMENT, tree.Sum: SUM, tree.Negative: NEGATIVE, tree.Product: PRODUCT,
    tree.Dot: PRODUCT, tree.Cross: PRODUCT, tree.Integral: PRODUCT, tree.Power: POWER,
    tree.Degrees: POWER, tree.Transpose: POWER,
}  # fmt: skip
CLOSED = {"(": ")", "[": "]", "{": "}", "\\{": "\\}"}
END = Token("end", "", (0, 0))


@dataclass(frozen=True)
class Box:
    r"""A box of a kind, with rows inside.

    Without any inside: `letter` (also digits, `\alpha`), `sign` between or `prefix` before parts,
    `word` (a function or a word, upright). With one: `name`, `root`, `accent`, `font`, `fence` (its
    text is both brackets, `( )`), `degrees`, `differential`, `mark`. With two: `fraction`, `call`
    (function and argument), `integral` (its ends). `scripts` has a base, what is below, what is
    above; a `grid` any number: its text is the number of columns and the brackets.
    """

    kind: str
    text: str = ""
    parts: Parts = ()


TALL = frozenset({"fraction", "grid", "integral"})
MINUS = Box("prefix", "-")


def sign(text: str) -> Box:
    """Return a sign that stands between two parts."""
    return Box("sign", text)


def fence(left: str, inside: Row, right: str) -> Box:
    """Return a row in brackets."""
    return Box("fence", f"{left} {right}", (inside,))


def listed(items: Sequence[Row]) -> Row:
    """Return rows with commas between them."""
    return _chained(sign(","), items)


def walk(row: Row) -> Iterator[Box]:
    """All boxes in a row, from the outside in."""
    for box in row:
        yield box
        for part in box.parts:
            yield from walk(part)


def is_tall(box: Box) -> bool:
    """Whether brackets grow with what is in this box."""
    return any(inner.kind in TALL for part in box.parts for inner in walk(part))


def layout(node: tree.Node, source: str = "") -> Row:
    """Lay a tree out; `source`: the text that it was read from."""
    return tree.fold(node, _Layout(source).row)


def name(latex: str) -> Row:
    r"""Lay a symbol out by its LaTeX, `\mathbf{n}_k` or a canonical name."""
    return (Box("name", latex, (_Spelling(latex).row(),)),)


@dataclass(frozen=True)
class _Layout:
    source: str

    def row(self, node: tree.Node, parts: Parts) -> Row:
        """Lay a node out from what its parts gave, in the brackets that it is printed in."""
        row = _RULES[type(node)](self, node, parts)
        own = isinstance(node, tree.Tuple | tree.SetBuilder)
        bracket = "" if own else self.enclosure(node)[0]
        return (fence(bracket, row, CLOSED[bracket]),) if bracket else row

    def printed(self, node: tree.Node) -> str:
        """The text of a node, without brackets around all of it."""
        return self.enclosure(node)[1]

    def between(self, left: tree.Node, right: tree.Node) -> str:
        """The text between two nodes."""
        return self.source[left.span[1] : right.span[0]]

    def enclosure(self, node: tree.Node) -> tuple[str, str]:
        """The outermost bracket around all of a node, and the text in it; braces do not print."""
        text, bracket = self.source[slice(*node.span)], ""
        while text[:1] in {"{", "(", "[", "\\"} and (tokens := tokenize(text)):
            if tokens[0].text not in CLOSED or _end(tokens) != len(tokens) - 1:
                break
            bracket = bracket or tokens[0].text.removeprefix("{")
            text = text[tokens[0].span[1] : tokens[-1].span[0]].strip()
        return bracket, text

    def within(self, node: tree.Node, row: Row, strength: int) -> Row:
        """Put a part that is not printed in brackets if it binds more weakly than needed."""
        if self.source or STRENGTHS.get(type(node), ATOM) >= strength:
            return row
        return (fence("(", row, ")"),)


def _end(tokens: Sequence[Token]) -> int:
    """The place of the token that closes the first one."""
    depth = 0
    for place, token in enumerate(tokens):
        depth += (token.text in CLOSED) - (token.text in CLOSED.values())
        if depth == 0:
            return place
    return -1


class _Spelling:
    """Reads the tokens of one symbol."""

    def __init__(self, latex: str) -> None:
        self.tokens = iter([*tokenize(latex), END])
        self.next = next(self.tokens)

    def take(self) -> Token:
        token, self.next = self.next, next(self.tokens, END)
        return token

    def row(self) -> Row:
        """Row = {atom {"'" | ("_" | "^") atom}}, up to a brace that closes."""
        row: Row = ()
        while self.next.text not in {"", "}"}:
            base = self.atom()
            below: Row = ()
            above: Row = ()
            while self.next.text in {"_", "^", "'"}:
                sign = self.take().text
                if sign == "'":
                    above += (Box("letter", "\\prime"),)
                else:
                    script = self.atom()
                    below, above = (
                        (below + script, above) if sign == "_" else (below, above + script)
                    )
            row += (Box("scripts", parts=(base, below, above)),) if below or above else base
        return row

    def atom(self) -> Row:
        """Atom = "{" row "}" | (accent | font) atom | token."""
        token = self.take()
        if token.text == "{":
            row = self.row()
            self.take()
            return row
        if token.kind in {"accent", "font"}:
            return (Box(token.kind, token.text, (self.atom(),)),)
        return (Box("word" if token.kind in {"text", "command"} else "letter", token.text),)


def _sum(page: _Layout, node: tree.Sum, parts: Parts) -> Row:
    row = page.within(node.terms[0], parts[0], NEGATIVE)
    for term, part in zip(node.terms[1:], parts[1:], strict=True):
        if part[0] == MINUS:
            row += (sign("-"), *part[1:])
        else:
            row += (sign("+"), *page.within(term, part, PRODUCT))
    return row


def _product(page: _Layout, node: tree.Product, parts: Parts) -> Row:
    """Factors side by side; a star where numbers meet or a bracket might be an argument."""
    row: Row = ()
    for place, (factor, part) in enumerate(zip(node.factors, parts, strict=True)):
        grouped = place > 0 or isinstance(factor, tree.Product)
        laid = page.within(factor, part, POWER if grouped else PRODUCT)
        if row and page.source:
            starred = "*" in page.between(node.factors[place - 1], factor)
        else:
            starred = bool(row) and _starts(laid[0])
        row += ((sign("*"),) if starred else ()) + laid
    return row


def _starts(box: Box) -> bool:
    """Whether a box starts with a digit or a bracket."""
    if box.kind in {"scripts", "degrees"}:
        return _starts(box.parts[0][0])
    return (box.kind == "letter" and box.text[0].isdigit()) or box.text == "( )"


def _joined(symbol: str) -> Callable[..., Row]:
    def rule(page: _Layout, node: Any, parts: Parts) -> Row:
        left, right = (
            page.within(side, part, strength)
            for side, part, strength in zip(
                (node.left, node.right), parts, (PRODUCT, POWER), strict=True
            )
        )
        return (*left, sign(symbol), *right)

    return rule


def _quotient(page: _Layout, node: tree.Quotient, parts: Parts) -> Row:
    if "/" in page.between(node.numerator, node.denominator):
        above = page.within(node.numerator, parts[0], PRODUCT)
        return (*above, sign("/"), *page.within(node.denominator, parts[1], POWER))
    return (Box("fraction", parts=parts),)


def _power(page: _Layout, node: tree.Power, parts: Parts) -> Row:
    exponent: Row = (Box("letter", str(abs(node.exponent))),)
    exponent = (MINUS, *exponent) if node.exponent < 0 else exponent
    behind = page.source[node.base.span[1] : node.span[1]]
    if page.source and isinstance(node.base, tree.Call) and "^" not in behind:
        ((call,),) = parts  # `\sin^2 x`: the exponent stands at the name
        head, argument = call.parts
        return (Box("call", parts=((Box("scripts", parts=(head, (), exponent)),), argument)),)
    return (Box("scripts", parts=(page.within(node.base, parts[0], ATOM), (), exponent)),)


def _call(page: _Layout, node: tree.Call, parts: Parts) -> Row:
    if node.function == "sqrt":
        return (Box("root", parts=parts),)
    if node.function == "power" and isinstance(node.argument, tree.Tuple):
        base, exponent = node.argument.items
        row = page.within(base, layout(base), ATOM)
        return (Box("scripts", parts=(row, (), layout(exponent))),)
    head = _head(page, node)
    bracketed = page.source or isinstance(node.argument, tree.Tuple)
    return (Box("call", parts=(head, parts[0] if bracketed else (fence("(", parts[0], ")"),))),)


def _applied(page: _Layout, node: tree.Applied, parts: Parts) -> Row:
    argument = listed(parts)
    if len(parts) > 1 or not page.enclosure(node.arguments[0])[0]:
        argument = (fence("(", argument, ")"),)
    return (Box("call", parts=(name(node.name), argument)),)


def _head(page: _Layout, node: tree.Call) -> Row:
    r"""The name of a function: as printed, `\tan^{-1}` or a letter that is short for it."""
    printed = page.printed(node)
    if printed[:1].isalpha():
        return (Box("letter", printed[0]),)
    word = Box("word", "\\det" if node.function == "det" else FUNCTIONS[node.function].latex)
    for direct, row in FUNCTIONS.items():
        if row.inverse == node.function and printed.startswith(f"\\{direct}"):
            above = (MINUS, Box("letter", "1"))
            return (Box("scripts", parts=((Box("word", row.latex),), (), above)),)
    return (word,)


def _tuple(page: _Layout, node: tree.Tuple, parts: Parts) -> Row:
    left, right = ("\\{", "\\}") if node.kind == "set" else ("(", ")")
    if node.kind == "tuple" and page.enclosure(node)[0] == "[":
        left, right = "[", "]"
    return (fence(left, listed(parts), right),)


def _matrix(page: _Layout, node: tree.MatrixLiteral, parts: Parts) -> Row:
    printed = page.printed(node)
    kinds = {"bmatrix": "[ ]", "vmatrix": "| |", "smallmatrix": "", "matrix": ""}
    brackets = next((b for k, b in kinds.items() if f"{{{k}}}" in printed[:24]), "( )")
    return (Box("grid", f"{len(node.rows[0])} {brackets}", parts),)


def _cases(page: _Layout, node: tree.Cases, parts: Parts) -> Row:
    return (Box("grid", "2 cases", tuple(half for part in parts for half in part[0].parts)),)


def _logic(page: _Layout, node: tree.Logic, parts: Parts) -> Row:
    if page.source and all(_goes_on(*pair) for pair in pairwise(node.operands)):
        row = parts[0]
        for operand, part in zip(node.operands[1:], parts[1:], strict=True):
            row += part[len(layout(tree.children(operand)[0], page.source)) :]
        return row
    word = Box("word", f"\\text{{ {node.operator} }}")
    rows: Sequence[Row] = parts if page.source else [(fence("(", part, ")"),) for part in parts]
    if len(rows) == 1:
        return (word, *rows[0])
    return _chained(word, rows)


def _goes_on(one: tree.Node, other: tree.Node) -> bool:
    """Whether `a < b` goes on with `b < c`: they are printed as `a < b < c`."""
    return tree.children(one)[-1].span == tree.children(other)[0].span


def _chained(between: Box, rows: Sequence[Row]) -> Row:
    row = rows[0]
    for other in rows[1:]:
        row += (between, *other)
    return row


def _chain(page: _Layout, node: tree.Chain, parts: Parts) -> Row:
    sides = [page.within(side, part, SUM) for side, part in zip(node.sides, parts, strict=True)]
    row = _chained(sign(node.relation), sides)
    return (sign(node.relation), *row) if node.continued else row


def _component(page: _Layout, node: tree.Component, parts: Parts) -> Row:
    vector = page.within(node.vector, parts[0], ATOM) if page.source else ()
    base = vector or (fence("(", parts[0], ")"),)
    return (Box("scripts", parts=(base, (Box("letter", node.axis),), ())),)


def _builder(page: _Layout, node: tree.SetBuilder, parts: Parts) -> Row:
    element, *conditions = parts
    return (fence("\\{", (*element, sign("\\mid"), *listed(conditions)), "\\}"),)


_RULES: dict[type[tree.Node], Callable[[_Layout, Any, Parts], Row]] = {
    tree.Number: lambda page, node, parts: (Box("letter", node.text),),
    tree.Degrees: lambda page, node, parts: (
        Box("degrees", parts=((Box("letter", node.value),),)),
    ),
    tree.Pi: lambda page, node, parts: (Box("letter", "\\pi"),),
    tree.Name: lambda page, node, parts: name(page.printed(node) or node.name),
    tree.Applied: _applied,
    tree.Negative: lambda page, node, parts: (
        MINUS,
        *page.within(node.operand, parts[0], PRODUCT),
    ),
    tree.Sum: _sum,
    tree.Product: _product,
    tree.Dot: _joined("\\cdot"),
    tree.Cross: _joined("\\times"),
    tree.Quotient: _quotient,
    tree.Power: _power,
    tree.Transpose: lambda page, node, parts: (
        Box(
            "scripts", parts=(page.within(node.operand, parts[0], ATOM), (), (Box("letter", "T"),))
        ),
    ),
    tree.Call: _call,
    tree.Integral: lambda page, node, parts: (
        Box("integral", parts=parts[:2]),
        *page.within(node.integrand, parts[2], SUM),
        Box("differential", parts=(parts[3],)),
    ),
    tree.Inner: lambda page, node, parts: (fence("\\langle", listed(parts), "\\rangle"),),
    tree.Norm: lambda page, node, parts: (fence("\\|", parts[0], "\\|"),),
    tree.Absolute: lambda page, node, parts: (fence("|", parts[0], "|"),),
    tree.Determinant: lambda page, node, parts: (
        Box("call", parts=((Box("word", "\\det"),), (fence("[", listed(parts), "]"),))),
    ),
    tree.Component: _component,
    tree.Tuple: _tuple,
    tree.MatrixLiteral: _matrix,
    tree.SetBuilder: _builder,
    tree.Branch: lambda page, node, parts: (Box("grid", "2", parts),),
    tree.Cases: _cases,
    tree.Comparison: lambda page, node, parts: _chained(
        sign(node.operator),
        [page.within(n, p, SUM) for n, p in zip((node.left, node.right), parts, strict=True)],
    ),
    tree.Logic: _logic,
    tree.Chain: _chain,
    tree.Listing: lambda page, node, parts: listed(parts),
}
