r"""Writes a tree as LaTeX that reads back as the same tree.

Brackets are set by the binding strength of the parts, not by what was printed: a repaired
formula has no print. Function arguments always get theirs, since `\sin x y` needs a convention.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from omniproof.formula.functions import FUNCTIONS
from omniproof.transcription import tree

STATEMENT, SUM, NEGATIVE, PRODUCT, POWER, ATOM = range(6)
"""Binding strengths, the weakest first."""

STRENGTHS: dict[type[tree.Node], int] = {
    tree.Chain: STATEMENT, tree.Comparison: STATEMENT, tree.Logic: STATEMENT,
    tree.Listing: STATEMENT, tree.Sum: SUM, tree.Negative: NEGATIVE, tree.Product: PRODUCT,
    tree.Dot: PRODUCT, tree.Cross: PRODUCT, tree.Integral: PRODUCT, tree.Power: POWER,
    tree.Degrees: POWER, tree.Transpose: POWER,
}  # fmt: skip


def latex(node: tree.Node) -> str:
    """Write a tree as LaTeX, matrices as `pmatrix`."""
    return _RULES[type(node)](node)


def _in(node: tree.Node, strength: int) -> str:
    """Write a part, in brackets if it binds more weakly than its place needs."""
    text = latex(node)
    return text if STRENGTHS.get(type(node), ATOM) >= strength else f"({text})"


def _sum(node: tree.Sum) -> str:
    text = _in(node.terms[0], NEGATIVE)
    for term in node.terms[1:]:
        minus = isinstance(term, tree.Negative)
        part = _in(term.operand if isinstance(term, tree.Negative) else term, PRODUCT)
        text += f" {'-' if minus else '+'} {part}"
    return text


def _product(node: tree.Product) -> str:
    """Factors side by side; a dot where numbers meet or a bracket might be an argument."""
    text = ""
    for place, factor in enumerate(node.factors):
        grouped = place > 0 or isinstance(factor, tree.Product)
        part = _in(factor, POWER if grouped else PRODUCT)
        starred = text and (part[0].isdigit() or part[0] == "(")
        text += (" * " if starred else " " if text else "") + part
    return text


def _power(node: tree.Power) -> str:
    exponent = str(node.exponent)
    return f"{_in(node.base, ATOM)}^{exponent if len(exponent) == 1 else f'{{{exponent}}}'}"


def _call(node: tree.Call) -> str:
    name = "\\det" if node.function == "det" else FUNCTIONS[node.function].latex
    if node.function == "sqrt":
        return f"{name}{{{latex(node.argument)}}}"
    argument = latex(node.argument)
    return f"{name}{argument}" if isinstance(node.argument, tree.Tuple) else f"{name}({argument})"


def _chain(node: tree.Chain) -> str:
    text = f" {node.relation} ".join(_in(side, SUM) for side in node.sides)
    return f"{node.relation} {text}" if node.continued else text


def _tuple(node: tree.Tuple) -> str:
    left, right = ("\\{", "\\}") if node.kind == "set" else ("(", ")")
    return f"{left}{_list(node.items)}{right}"


def _matrix(node: tree.MatrixLiteral) -> str:
    rows = " \\\\ ".join(" & ".join(latex(entry) for entry in row) for row in node.rows)
    return f"\\begin{{pmatrix}} {rows} \\end{{pmatrix}}"


def _cases(node: tree.Cases) -> str:
    rows = " \\\\ ".join(f"{latex(row.value)} & {latex(row.condition)}" for row in node.branches)
    return f"\\begin{{cases}} {rows} \\end{{cases}}"


def _logic(node: tree.Logic) -> str:
    word = f" \\text{{ {node.operator} }} "
    text = word.join(f"({latex(part)})" for part in node.operands)
    return f"{word.strip()} {text}" if len(node.operands) == 1 else text


def _list(nodes: tuple[tree.Node, ...]) -> str:
    return ", ".join(latex(item) for item in nodes)


def _bars(node: tree.Node, bar: str) -> str:
    """Write bars that show their direction where others stand inside."""
    nested = any(isinstance(item, tree.Norm | tree.Absolute) for item in tree.walk(node))
    return f"\\left{bar}{latex(node)}\\right{bar}" if nested else f"{bar}{latex(node)}{bar}"


def _fraction(node: tree.Quotient) -> str:
    return f"\\frac{{{latex(node.numerator)}}}{{{latex(node.denominator)}}}"


_RULES: dict[type[tree.Node], Callable[[Any], str]] = {
    tree.Number: lambda node: node.text,
    tree.Degrees: lambda node: f"{node.value}^\\circ",
    tree.Pi: lambda node: "\\pi",
    tree.Name: lambda node: node.name,
    tree.Applied: lambda node: f"{node.name}({_list(node.arguments)})",
    tree.Negative: lambda node: f"-{_in(node.operand, PRODUCT)}",
    tree.Sum: _sum,
    tree.Product: _product,
    tree.Dot: lambda node: f"{_in(node.left, PRODUCT)} \\cdot {_in(node.right, POWER)}",
    tree.Cross: lambda node: f"{_in(node.left, PRODUCT)} \\times {_in(node.right, POWER)}",
    tree.Quotient: _fraction,
    tree.Power: _power,
    tree.Transpose: lambda node: f"{_in(node.operand, ATOM)}^T",
    tree.Call: _call,
    tree.Integral: lambda node: (
        f"\\int_{{{latex(node.lower)}}}^{{{latex(node.upper)}}} "
        f"{_in(node.integrand, SUM)} d{latex(node.variable)}"
    ),
    tree.Inner: lambda node: f"\\langle {latex(node.left)}, {latex(node.right)} \\rangle",
    tree.Norm: lambda node: _bars(node.operand, "\\|"),
    tree.Absolute: lambda node: _bars(node.operand, "|"),
    tree.Determinant: lambda node: f"\\det[{_list(node.columns)}]",
    tree.Component: lambda node: f"({latex(node.vector)})_{node.axis}",
    tree.Tuple: _tuple,
    tree.MatrixLiteral: _matrix,
    tree.SetBuilder: lambda node: f"\\{{{latex(node.element)} \\mid {_list(node.conditions)}\\}}",
    tree.Branch: lambda node: f"{latex(node.value)} & {latex(node.condition)}",
    tree.Cases: _cases,
    tree.Comparison: lambda node: f"{_in(node.left, SUM)} {node.operator} {_in(node.right, SUM)}",
    tree.Logic: _logic,
    tree.Chain: _chain,
    tree.Listing: lambda node: _list(node.items),
}
