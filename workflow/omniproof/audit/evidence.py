"""What speaks for a verdict: records in the JSON ledgers, one line of text each in the CSV.

A record is written as text by the last who shows it; nobody reads such a text back.
"""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict


class Record(BaseModel):
    """A part of a row; nothing that is not declared, and never changed."""

    model_config = ConfigDict(frozen=True, extra="forbid")


class Counterexample(Record):
    """Values at which a printed cell fails, with what is printed and what is true there.

    `point`: exact coordinates by the symbol's name (`20/9`, `pi/2`), empty where no symbol is free.
    """

    point: dict[str, str] = {}
    printed: str
    derived: str

    def __str__(self) -> str:
        """Write `alpha_1=2/7; printed=0.84; derived=-0.31`, the form of the CSV."""
        values = [*self.point.items(), ("printed", self.printed), ("derived", self.derived)]
        return "; ".join(f"{name}={value}" for name, value in values)

    def __hash__(self) -> int:
        """Let rows be members of sets, although a mapping is none."""
        return hash(str(self))


class Range(Record):
    """The numbers between two ends, as decimals; an end that belongs to them is closed."""

    lower: str
    upper: str
    lower_closed: bool = True
    upper_closed: bool = True

    @property
    def bounds(self) -> str:
        """Write `[3.075, 3.085)`."""
        left, right = "[" if self.lower_closed else "(", "]" if self.upper_closed else ")"
        return f"{left}{self.lower}, {self.upper}{right}"

    def around(self, name: str) -> str:
        """Write `3.075 ≤ name < 3.085`; `name = 3` for a single number."""
        if self.lower == self.upper:
            return f"{name} = {self.lower}"
        left, right = ("≤" if closed else "<" for closed in (self.lower_closed, self.upper_closed))
        return f"{self.lower} {left} {name} {right} {self.upper}"


class Setup(Record):
    """Which values of an unstated quantity give the cells of a table.

    `ranges`: none where the cells contradict each other, of which `contradicting` are an example.
    """

    unknown: str
    ranges: tuple[Range, ...]
    contradicting: tuple[str, ...] = ()

    def __str__(self) -> str:
        """Write `0.0499 ≤ V < 0.0501`, or which cells contradict each other."""
        if not self.ranges:
            return f"none: {', '.join(self.contradicting)} contradict each other"
        return " or ".join(piece.around(self.unknown) for piece in self.ranges)


class Interval(Range):
    """What a printed decimal stands for, beside the exact `value` to six digits.

    Where the set-up of a table has to be found, `setup` is all that gives the cells, the decimal
    `included` among them or not, and `value` belongs to the set-up that the derivation names.
    """

    value: str
    setup: Setup | None = None
    included: bool = True

    def __str__(self) -> str:
        """Write `3.07920; [3.075, 3.085]`, the form of the CSV."""
        if self.setup is None:
            return f"{self.value}; {self.bounds}"
        cells = "with all cells" if self.included else "by the cells"
        return f"{self.around('x')} by its digits; {self.setup} {cells}"


class Rival(Record):
    """Another edit of the printed text, as small as the correction, that would make it true."""

    correction: str
