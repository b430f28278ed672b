r"""Formulas to paste: LaTeX, SymPy and NumPy that run where they are put, with all that they need.

LaTeX goes into one display: nothing is left of an `align`, and nothing begins with an equals sign.
"""

from __future__ import annotations

import keyword
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import sympy
from sympy import Integral, MatrixBase, Symbol, sstr
from sympy.core.function import AppliedUndef
from sympy.printing.numpy import NumPyPrinter

from omniproof.report.latexfmt import TAG

LONGEST = 1500
"""Characters of a formula in code; a longer one nobody reads, and it makes a page heavy."""

_ALIGNED = re.compile(r"&(?=\s*(?:=|<|>|\\(?:leq?|geq?|in)(?![a-z])))")
_ATAN2 = re.compile(r"\\operatorname\{atan\}_\{2\}\{(\\left\(.*?\\right\))\}")
_CALLED = re.compile(r"\b([A-Za-z]\w*)(?=\()|\b(pi)\b")
_RUNNING = """def running_integral(time, values):
    steps = np.diff(time) * (values[1:] + values[:-1]) / 2
    return np.concatenate([[0.0], np.cumsum(steps)])"""


@dataclass(frozen=True)
class Product:
    """What a formula is worth: a product of SymPy values, over one of them."""

    factors: tuple[Any, ...]
    per: Any = None

    @property
    def value(self) -> Any:
        """Return the product itself."""
        whole = sympy.Integer(1)
        for factor in self.factors:
            whole = whole * factor
        return whole / self.per if self.per is not None else whole

    @property
    def letters(self) -> list[Symbol]:
        """Return its symbols, by name."""
        found = {s for part in self.parts for s in part.free_symbols}
        return sorted(found, key=str)

    @property
    def functions(self) -> list[AppliedUndef]:
        """Return the unknown functions of time in it, by name; each once."""
        found = {f.func: f for part in self.parts for f in part.atoms(AppliedUndef)}
        return sorted(found.values(), key=str)

    @property
    def parts(self) -> tuple[Any, ...]:
        """Return its factors, and what they are divided by."""
        return self.factors if self.per is None else (*self.factors, self.per)


def latex_paste(latex: str) -> str:
    r"""Return LaTeX for a display of its own: no tag, no mark of alignment, no leading sign.

    `\\operatorname{atan}_{2}`, as SymPy writes it, becomes the `atan2` of other programs.
    """
    text = _ALIGNED.sub("", TAG.sub("", latex)).strip()
    text = _ATAN2.sub(r"\\operatorname{atan2}\1", text)
    return text.removeprefix("=").rstrip(",.; ").strip()


def sympy_paste(name: str, product: Product) -> str:
    """Return a program that makes the formula with SymPy; nothing for one that is too long."""
    texts = [_sympy_text(part) for part in product.parts]
    body = _joined(name, product, texts)
    letters = product.letters
    functions = [str(f.func) for f in product.functions]
    if not body or not _writable([*map(str, letters), *functions, name]):
        return ""
    head = [_declared(letters, "positive"), _declared(letters, "real")]
    head += [f'{function} = Function("{function}", real=True)' for function in functions]
    used = {found[1] or found[2] for found in _CALLED.finditer("\n".join([*head, body]))}
    names = sorted({word for word in used if hasattr(sympy, word)} - {*functions})
    lines = [f"from sympy import {', '.join(names)}", "", *filter(None, head), "", body]
    return "\n".join(lines if names else [body])


def numpy_paste(name: str, product: Product) -> str:
    """Return a function for NumPy; nothing for a formula that is too long, or no such function.

    Symbols are its arguments, in SI units and radians. An integral over time takes samples.
    """
    timed = bool(product.functions)
    if timed:
        return _sampled(name, product)
    texts = [_numpy_text(part) for part in product.parts]
    body = _joined("return", product, texts).replace("return = ", "return ")
    letters = [str(letter) for letter in product.letters]
    if not body or not _writable([*letters, name]) or "Not supported" in body:
        return ""
    inside = "\n".join(f"    {line}" for line in body.splitlines())
    return f"import numpy as np\n\n\ndef {name}({', '.join(letters)}):\n{inside}"


def omniproof_paste(module: str, name: str, call: str) -> str:
    """Return an import of a corrected formula, and a call of it."""
    arrays = "import numpy as np\n\n" if "np." in call else ""
    return f"{arrays}from {module} import {name}\n\n{call}"


def _joined(name: str, product: Product, texts: Sequence[str]) -> str:
    """Return `name = product`, its factors apart; nothing when it is too long."""
    if sum(map(len, texts)) > LONGEST:
        return ""
    single = len(texts) == 1
    bracketed = [text if single else _bracketed(text) for text in texts]
    whole = " * ".join(bracketed[: len(product.factors)])
    if product.per is not None:
        whole = f"{whole} / {bracketed[-1]}"
    return f"{name} = {whole}"


def _bracketed(text: str) -> str:
    return text if re.match(r"(?:np\.array|Matrix)\(|\w+$", text) else f"({text})"


def _sympy_text(value: Any) -> str:
    if not isinstance(value, MatrixBase):
        return str(sstr(value))
    return _rows("Matrix", [[str(sstr(x)) for x in row] for row in value.tolist()])


def _numpy_text(value: Any) -> str:
    if not isinstance(value, MatrixBase):
        return _numpy(value)
    if value.cols == 1:
        return f"np.array([{', '.join(_numpy(entry) for entry in value.flat())}])"
    return _rows("np.array", [[_numpy(x) for x in row] for row in value.tolist()])


def _rows(name: str, rows: Iterable[Sequence[str]]) -> str:
    """Write a matrix, a row on a line."""
    lines = "".join(f"    [{', '.join(row)}],\n" for row in rows)
    return f"{name}([\n{lines}])"


def _numpy(value: Any) -> str:
    return str(NumPyPrinter().doprint(value)).replace("numpy.", "np.")


def _declared(letters: Iterable[Symbol], kind: str) -> str:
    """Declare symbols of one kind: `positive` ones, or those that are `real` only."""
    names = [str(s) for s in letters if ("positive" if s.is_positive else "real") == kind]
    if not names:
        return ""
    return f'{", ".join(names)} = symbols("{" ".join(names)}", {kind}=True)'


def _writable(names: Iterable[str]) -> bool:
    return all(name.isidentifier() and not keyword.iskeyword(name) for name in names)


def _sampled(name: str, product: Product) -> str:
    """Return a function of samples for an integral over time of unknown functions."""
    (value,) = product.factors
    factor, integral = value.as_coeff_Mul()
    if not isinstance(integral, Integral):
        return ""
    (time, *_), *others = integral.limits
    inner = sorted(integral.function.atoms(Integral), key=str)
    if others:
        return ""
    names = {part: Symbol(f"integral_{k}") for k, part in enumerate(inner, 1)}
    bare = integral.function.xreplace(names)
    lines = [
        f"{own} = running_integral({time}, {_numpy(_sample(part.function))})"
        for part, own in names.items()
    ]
    whole = f"running_integral({time}, {_numpy(_sample(bare))})"
    if factor != 1:
        whole = f"{whole} * {_numpy(factor)}"
    arguments = [str(f.func) for f in product.functions]
    constants = [str(s) for s in product.letters if s != time]
    inside = "\n".join(f"    {line}" for line in [*lines, f"return {whole}"])
    return (
        f"import numpy as np\n\n\n{_RUNNING}\n\n\n"
        f"def {name}({', '.join([str(time), *arguments, *constants])}):\n{inside}"
    )


def _sample(value: Any) -> Any:
    """Write a symbol, an array of samples, for each unknown function."""
    return value.xreplace({f: Symbol(str(f.func)) for f in value.atoms(AppliedUndef)})
