"""What is true or false of terms."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal, TypeAlias


@dataclass(frozen=True)
class Comparison:
    r"""`a < b`; the operator is one of `=`, `<`, `>`, `\\leq`, `\\geq`, `\\neq`."""

    left: Any
    operator: str
    right: Any


@dataclass(frozen=True)
class Logic:
    """Statements that all hold, of which one holds, or of which all or none hold."""

    operator: Literal["and", "or", "equivalent"]
    operands: tuple[Any, ...]


Statement: TypeAlias = Comparison | Logic
