"""The data model of a paper file: one claim is one thing that a paper asserts at one place.

Every scalar arrives as the text that stands in the file, so that `4.00` keeps its zeros.
Cross-field rules live here; what needs the reader (LaTeX) or the derivations lives elsewhere.
"""

from __future__ import annotations

import re
from enum import StrEnum
from typing import Annotated, Self

from pydantic import (
    BaseModel,
    ConfigDict,
    Field,
    StringConstraints,
    field_validator,
    model_validator,
)

ID = re.compile(
    r"(?P<object>eq|tab|fig|sec|app|xref):(?P<number>[A-Za-z0-9.-]+)(?P<again>#\d+)?"
    r"(?:/(?P<part>[a-z0-9]+(?:-[a-z0-9]+)*))?"
    r"(?:\[(?P<index>[A-Za-z0-9_]+(?:,[A-Za-z0-9_]+)*)\])?"
)

ClaimId = Annotated[str, StringConstraints(pattern=f"^{ID.pattern}$")]
Text = Annotated[str, StringConstraints(min_length=1, max_length=2_000)]
Latex = Annotated[str, StringConstraints(min_length=1, max_length=10_000)]
Name = Annotated[str, StringConstraints(pattern=r"^[A-Za-z][A-Za-z0-9_]*$", max_length=40)]


class Record(BaseModel):
    """Frozen, and closed against unknown keys."""

    model_config = ConfigDict(frozen=True, extra="forbid")


class Kind(StrEnum):
    """What a claim asserts; it fixes which verdicts the claim can take."""

    IDENTITY = "identity"
    VALUE = "value"
    RELATION = "relation"
    CONSISTENCY = "consistency"
    REFERENCE = "reference"
    EDITORIAL = "editorial"


class Source(StrEnum):
    """How well the source text can be trusted at this place."""

    CLEAR = "clear"
    DOUBTFUL = "doubtful"
    LOST = "lost"


class Reading(StrEnum):
    """How the printed form was read where the source text is damaged."""

    PLAIN = ""
    GLYPHS = "glyphs"
    RECONSTRUCTED = "reconstructed"


class Uncheckable(StrEnum):
    """Why nobody can decide a claim from the paper's text and mechanics alone."""

    FIGURE_NOT_SEEN = "figure-not-seen"
    SOURCE_LOST = "source-lost"
    EXTERNAL_DATA = "external-data"
    EXTERNAL_REFERENCE = "external-reference"
    OPINION = "opinion"


class Role(StrEnum):
    """What a printed symbol stands for."""

    VARIABLE = "variable"  # a real number, free in a formula
    QUANTITY = "quantity"  # defined by the paper: the derivations give its meaning
    UNDEFINED = "undefined"  # printed, but never introduced: free, and no variable of the mechanics


class Form(StrEnum):
    """How a relation is to be judged against what its derivation returns."""

    INCREASING = "increasing"  # derivation: sequence of exact values
    DECREASING = "decreasing"
    EQUAL = "equal"  # all values of the sequence agree
    LARGEST = "largest"  # derivation: named values; `member` is the largest
    SMALLEST = "smallest"
    MINIMUM = "minimum"  # derivation: a family on a box; `at` is its only global minimum
    MAXIMUM = "maximum"
    NEGATIVE = "negative"  # derivation: a family; its value has this sign everywhere
    POSITIVE = "positive"
    CONCAVE = "concave"  # derivation: a family of one variable
    EQUIVALENT = "equivalent"  # derivation: a condition; the printed one holds in the same cases
    INSTANCE = "instance"  # derivation: a family of angles; the printed ones are a member of it
    LINE = "line"  # derivation: a curve; it lies on one
    CIRCLE = "circle"
    ELLIPSE = "ellipse"
    CHAIN = "chain"  # derivation: ordered expressions on a box; each is less than the next


class Asserts(Record):
    """The checkable form of a relation.

    `for_all`: the sentence says that it holds for all values of its variables.
    """

    form: Form
    member: Text | None = None
    at: tuple[Latex, ...] = ()
    for_all: bool = False

    @model_validator(mode="after")
    def _complete(self) -> Self:
        if (self.form in {Form.LARGEST, Form.SMALLEST}) != (self.member is not None):
            raise ValueError("`member` belongs to the forms largest and smallest, and only there")
        if (self.form in {Form.MINIMUM, Form.MAXIMUM}) != bool(self.at):
            raise ValueError("`at` belongs to the forms minimum and maximum, and only there")
        return self


class Symbol(Record):
    r"""A symbol as the paper prints it, and the name that it has in the derivations.

    `range` is an open interval such as `(0, 90^\circ)`, in every claim. `of` makes a quantity a
    function: the variables whose place its printed arguments take.
    """

    latex: Latex
    name: Name
    role: Role = Role.VARIABLE
    positive: bool = False
    range: Latex | None = None
    of: tuple[Latex, ...] = ()
    means: Text

    @field_validator("of", mode="before")
    @classmethod
    def _one_or_many(cls, value: object) -> object:
        return (value,) if isinstance(value, str) else value

    @model_validator(mode="after")
    def _complete(self) -> Self:
        if self.of and self.role is not Role.QUANTITY:
            raise ValueError("`of` belongs to role quantity")
        for key in ("positive", "range"):
            if getattr(self, key) and self.role is not Role.VARIABLE:
                raise ValueError(f"`{key}` belongs to role variable")
        return self


KEY = r"^[a-z][a-z0-9-]*$"
"""The key of a paper."""


class Notation(Record):
    """The paper's conventions of writing, for what would otherwise be ambiguous."""

    functions: dict[str, str] = Field(default_factory=dict)  # shorthand letter -> function: c: cos
    slash: str | None = Field(default=None, pattern="^(first|all)$")  # what 1/3L divides by
    angles: str | None = Field(default=None, pattern="^degrees$")  # what 90 is in cos(90 + a)
    glyphs: dict[str, tuple[str, ...]] = Field(default_factory=dict)  # decoding; see `glyphs`


class Claim(Record):
    """One thing the paper asserts.

    `line` is the line of the source text (the first line is 1). `latex` and `quote` are verbatim;
    several fragments stand for a display that the source interrupts. `printed` is a decimal for
    kind `value`, and the verbatim wording or symbol to compare for kind `consistency`. `assumes`
    are inequalities that the paper states for this claim, in LaTeX. Where the source is re-encoded,
    `latex` and `quote` are decoded from the piece `glyphs` of the source, with the glyphs that are
    `lost` there; where a display is gone, `argument` says why it is reconstructed like this.
    """

    id: ClaimId
    kind: Kind
    line: int = Field(ge=1)
    says: Text
    latex: tuple[Latex, ...] = ()
    quote: Text | None = None
    printed: Text | None = None
    unit: Text | None = None
    asserts: Asserts | None = None
    assumes: tuple[Latex, ...] = ()
    agrees_with: tuple[ClaimId, ...] = ()
    target: ClaimId | None = None
    about: Text | None = None
    source: Source = Source.CLEAR
    reading: Reading = Reading.PLAIN
    glyphs: Text | None = None
    lost: Text | None = None
    uncheckable: Uncheckable | None = None
    decided_by: Text | None = None
    argument: Text | None = None

    @field_validator("latex", "agrees_with", "assumes", mode="before")
    @classmethod
    def _one_or_many(cls, value: object) -> object:
        return (value,) if isinstance(value, str) else value

    @model_validator(mode="after")
    def _evidence_is_whole(self) -> Self:
        if (self.uncheckable is None) != (self.decided_by is None):
            raise ValueError("`uncheckable` and `decided_by` (what would decide it) go together")
        if self.argument and self.reading is not Reading.RECONSTRUCTED:
            raise ValueError("only what is reconstructed (`reading: reconstructed`) has `argument`")
        decoded = self.reading is Reading.GLYPHS and bool(self.latex or self.quote)
        if (self.glyphs and not decoded) or (self.lost and not self.glyphs):
            raise ValueError("only what is decoded (`reading: glyphs`) has `glyphs` and `lost`")
        return self

    @model_validator(mode="after")
    def _has_what_its_kind_needs(self) -> Self:
        if self.uncheckable is not None:
            return self
        needs = _NEEDS.get(self.kind)
        if needs and not getattr(self, needs):
            raise ValueError(f"a claim of kind {self.kind} needs `{needs}`")
        if self.kind is Kind.VALUE:
            _check_decimal(str(self.printed))
        if (
            self.asserts
            and self.asserts.form in {Form.EQUIVALENT, Form.INSTANCE}
            and not self.latex
        ):
            raise ValueError(f"a relation of form {self.asserts.form} needs `latex`")
        return self

    @model_validator(mode="after")
    def _has_nothing_of_other_kinds(self) -> Self:
        if self.asserts and self.kind is not Kind.RELATION:
            raise ValueError("`asserts` belongs to kind relation")
        if self.assumes and self.kind not in {Kind.IDENTITY, Kind.RELATION}:
            raise ValueError("`assumes` belongs to the kinds identity and relation")
        return self


_NEEDS = {
    Kind.IDENTITY: "latex",
    Kind.VALUE: "printed",
    Kind.RELATION: "asserts",
    Kind.CONSISTENCY: "agrees_with",
}


def _check_decimal(text: str) -> None:
    if not re.fullmatch(r"[+-]?\d+(\.\d*)?", text) or len(text) > 40:
        raise ValueError(f"`printed` should be a decimal such as 4.00, found {text!r}")


class Table(Record):
    """A printed table whose cells are claims of kind `value`: first column row names, a header."""

    id: ClaimId
    file: Annotated[str, StringConstraints(pattern=r"^[a-z0-9-]+\.csv$")]
    line: int = Field(ge=1)
    says: Text
    units: dict[str, Text]


class Edition(Record):
    """Which text was audited; `year` is left out where the text does not say it."""

    title: Text
    authors: tuple[Text, ...] = Field(min_length=1)
    year: int | None = None
    venue: Text
    source: Annotated[str, StringConstraints(pattern=r"^[a-z0-9-]+\.txt$")]
    sha256: Annotated[str, StringConstraints(pattern=r"^[0-9a-f]{64}$")]


class Paper(Record):
    """One paper: its edition, its symbols, its conventions, its claims in reading order."""

    key: Annotated[str, StringConstraints(pattern=KEY)]
    edition: Edition
    notation: Notation = Notation()
    symbols: tuple[Symbol, ...] = ()
    tables: tuple[Table, ...] = ()
    claims: tuple[Claim, ...] = Field(min_length=1)
