"""Random formulas that know their LaTeX and their value, and true rewritings of them.

The value is computed by mpmath from the very structure that the LaTeX is written from: neither the
reader nor an engine nor the digits of the mutation study have a part in it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from random import Random
from typing import Any

from hypothesis import strategies as st
from mpmath import mp, mpf

DIGITS = 60
POINTS = 6
NUMBERS, ANGLES = ("x", "L", "v_1", "v_2"), (r"\alpha_1", r"\alpha_2", r"\theta")
SYMBOLS, POSITIVE = (*NUMBERS, *ANGLES), "L"
Point = Mapping[str, str]


@dataclass(frozen=True)
class Formula:
    """An operation on formulas, or a leaf: a number, a symbol, an angle in degrees."""

    kind: str
    parts: tuple[Formula, ...] = ()
    text: str = ""

    @property
    def has_root(self) -> bool:
        """Whether there is a square root in it, which may be undefined on half of its points."""
        return self.kind == "root" or any(part.has_root for part in self.parts)

    @property
    def latex(self) -> str:
        """The LaTeX, in brackets wherever it could be read in another way."""
        return _WRITTEN[self.kind](self.text, *(part.latex for part in self.parts))

    def at(self, point: Point) -> Any:
        """The value to 60 digits, `None` where there is no real one."""
        with mp.workdps(DIGITS):
            try:
                value = self._value(point)
            except ZeroDivisionError:
                return None
            return value if mp.im(value) == 0 and mp.isfinite(value) else None

    def _value(self, point: Point) -> Any:
        if self.kind == "symbol":
            return mpf(point[self.text])
        value = _VALUES[self.kind](self.text, *(part._value(point) for part in self.parts))
        if mp.im(value) != 0:
            raise ZeroDivisionError("a root of a negative number")
        return value


_WRITTEN: dict[str, Callable[..., str]] = {
    "number": lambda text: text,
    "symbol": lambda text: text,
    "degrees": lambda text: rf"{text}^\circ",
    "pi": lambda text: r"\pi",
    "negative": lambda _, a: f"-({a})",
    "sum": lambda _, a, b: f"({a}) + ({b})",
    "difference": lambda _, a, b: f"({a}) - ({b})",
    "product": lambda _, a, b: rf"({a}) \cdot ({b})",
    "quotient": lambda _, a, b: rf"\frac{{{a}}}{{{b}}}",
    "power": lambda text, a: f"({a})^{{{text}}}",
    "root": lambda _, a: rf"\sqrt{{{a}}}",
    "size": lambda _, a: f"|({a})|",
    "sin": lambda _, a: rf"\sin({a})",
    "cos": lambda _, a: rf"\cos({a})",
    "tan": lambda _, a: rf"\tan({a})",
    "cot": lambda _, a: rf"\cot({a})",
}

_VALUES: dict[str, Callable[..., Any]] = {
    "number": mpf,
    "degrees": lambda text: mpf(text) * mp.pi / 180,
    "pi": lambda text: +mp.pi,
    "negative": lambda _, a: -a,
    "sum": lambda _, a, b: a + b,
    "difference": lambda _, a, b: a - b,
    "product": lambda _, a, b: a * b,
    "quotient": lambda _, a, b: a / b,
    "power": lambda text, a: a ** int(text),
    "root": lambda _, a: mp.sqrt(a),
    "size": lambda _, a: abs(a),
    "sin": lambda _, a: mp.sin(a),
    "cos": lambda _, a: mp.cos(a),
    "tan": lambda _, a: mp.sin(a) / mp.cos(a),
    "cot": lambda _, a: mp.cos(a) / mp.sin(a),
}

ONE, TWO = Formula("number", text="1"), Formula("number", text="2")
RIGHT_ANGLE = Formula("degrees", text="90")


def points(seed: int = 0) -> list[dict[str, str]]:
    """Return decimals for all symbols, of both signs but for L: the same in every run."""
    chance = Random(seed)
    found = [{name: chance.uniform(-3, 3) for name in SYMBOLS} for _ in range(POINTS)]
    return [
        {name: f"{abs(x) if name == POSITIVE else x:.9f}" for name, x in point.items()}
        for point in found
    ]


def agree(one: Any, other: Any) -> bool:
    """Whether two values agree to 30 digits: cancellation may cost the others."""
    with mp.workdps(DIGITS):
        return bool(abs(one - other) <= mpf(10) ** -30 * (1 + abs(one) + abs(other)))


def _angles() -> st.SearchStrategy[Formula]:
    """Rational-linear forms in angles and rational multiples of pi."""
    symbol = st.sampled_from(ANGLES).map(lambda name: Formula("symbol", text=name))
    constant = st.sampled_from(("30", "45", "60", "90", "120", "180", "36", "22.5")).map(
        lambda text: Formula("degrees", text=text)
    )
    multiple = st.tuples(st.sampled_from("23"), symbol).map(
        lambda pair: Formula("product", (Formula("number", text=pair[0]), pair[1]))
    )
    half = symbol.map(lambda name: Formula("quotient", (name, TWO)))
    term = symbol | constant | multiple | half
    both = st.tuples(st.sampled_from(("sum", "difference")), symbol | multiple | half, term)
    return term | both.map(lambda t: Formula(t[0], t[1:]))


def formulas(*, leaves: int = 6, roots: bool = True) -> st.SearchStrategy[Formula]:
    """Formulas of the class that the zero test is made for."""
    number = st.sampled_from(("1", "2", "3", "5", "0.5", "8")).map(
        lambda text: Formula("number", text=text)
    )
    symbol = st.sampled_from(SYMBOLS).map(lambda name: Formula("symbol", text=name))
    circular = st.tuples(st.sampled_from(("sin", "cos", "sin", "cos", "tan", "cot")), _angles())
    leaf = number | symbol | circular.map(lambda t: Formula(t[0], t[1:]))
    return st.recursive(leaf, lambda inner: _operations(inner, roots), max_leaves=leaves)


def _operations(inner: st.SearchStrategy[Formula], roots: bool) -> st.SearchStrategy[Formula]:
    two = st.sampled_from(("sum", "difference", "product", "quotient"))
    one = st.sampled_from(("negative", "root", "size") if roots else ("negative",))
    return (
        st.tuples(two, inner, inner).map(lambda t: Formula(t[0], t[1:]))
        | st.tuples(one, inner).map(lambda t: Formula(t[0], t[1:]))
        | st.tuples(st.sampled_from(("2", "3", "-1")), inner).map(
            lambda t: Formula("power", t[1:], t[0])
        )
    )


def rewritten(formula: Formula, chance: Random) -> Formula:
    """Write a formula in another way, by identities of school; the value stays."""
    parts = tuple(rewritten(part, chance) for part in formula.parts)
    same = Formula(formula.kind, parts, formula.text)
    rules = _RULES.get(formula.kind, ())
    return chance.choice(rules)(*parts) if rules and chance.random() < 0.5 else same


def _f(kind: str, *parts: Formula, text: str = "") -> Formula:
    return Formula(kind, parts, text)


def _square(part: Formula) -> Formula:
    return _f("power", part, text="2")


def _half(part: Formula) -> Formula:
    return _f("quotient", part, TWO)


_RULES: dict[str, tuple[Callable[..., Formula], ...]] = {
    "sum": (lambda a, b: _f("sum", b, a), lambda a, b: _f("difference", a, _f("negative", b))),
    "difference": (lambda a, b: _f("negative", _f("difference", b, a)),),
    "product": (
        lambda a, b: _f("product", b, a),
        lambda a, b: _f("quotient", _f("difference", _square(_f("sum", a, b)),
                                       _square(_f("difference", a, b))),
                        Formula("number", text="4")),
    ),
    "quotient": (lambda a, b: _f("product", a, _f("power", b, text="-1")),),
    "sin": (
        lambda a: _f("cos", _f("difference", RIGHT_ANGLE, a)),
        lambda a: _f("product", _f("product", TWO, _f("sin", _half(a))), _f("cos", _half(a))),
    ),
    "cos": (
        lambda a: _f("sin", _f("sum", a, RIGHT_ANGLE)),
        lambda a: _f("difference", ONE, _f("product", TWO, _square(_f("sin", _half(a))))),
    ),
    "tan": (lambda a: _f("quotient", _f("sin", a), _f("cos", a)),),
    "root": (lambda a: _f("root", _f("product", ONE, a)),),
    "size": (lambda a: _f("root", _square(a)), lambda a: _f("size", _f("negative", a))),
}  # fmt: skip
