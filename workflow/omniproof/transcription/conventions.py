"""What has to be known to read a formula: how it is written, and what is declared."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Protocol


class Writing(Protocol):
    """Conventions of writing: those of a paper (`model.Notation`), or of one formula."""

    @property
    def functions(self) -> Mapping[str, str]:
        """Functions by the letter that is short for them: c for cos."""

    @property
    def slash(self) -> str | None:
        """What `1/3L` divides by: the `first` factor or `all`; unknown if None."""

    @property
    def angles(self) -> str | None:
        r"""The unit of 90 in `\cos(90 + \psi)`: `degrees`, or rad if None."""


@dataclass(frozen=True)
class Conventions:
    """The conventions of one formula."""

    functions: Mapping[str, str] = field(default_factory=dict)
    slash: str | None = None
    angles: str | None = None


@dataclass(frozen=True)
class Names:
    """Canonical names of the declared symbols, and of those that may take or do take arguments."""

    declared: frozenset[str] = frozenset()
    quantities: frozenset[str] = frozenset()
    functions: frozenset[str] = frozenset()
    alone: bool = False
    """Whether nobody declares symbols: `f(x)` is read as applied, and to be refused later."""
    shown: bool = False
    """Whether a formula is only shown, not judged: then every name is a symbol."""


ALONE = Names(alone=True)
"""What is known of a formula that stands alone."""
