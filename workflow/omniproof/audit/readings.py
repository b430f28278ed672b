"""Verdicts by hand, allowed for references and editorial claims only, each with its reason."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from importlib.resources import files
from importlib.util import find_spec
from pathlib import Path
from typing import Annotated, Self

from pydantic import (
    BaseModel,
    ConfigDict,
    StringConstraints,
    TypeAdapter,
    ValidationError,
    model_validator,
)

from omniproof.audit.ledger import Verdict
from omniproof.transcription.faults import BadInput, Fault
from omniproof.transcription.loader import LoadedPaper
from omniproof.transcription.messages import model_fault
from omniproof.transcription.model import Claim, Kind
from omniproof.transcription.paperfile import load_document

ALLOWED = {
    Kind.EDITORIAL: frozenset({Verdict.EDITORIAL}),
    Kind.REFERENCE: frozenset({Verdict.VERIFIED, Verdict.ERRATUM, Verdict.UNCHECKABLE}),
}
"""The verdicts that a person may give, by the kind of the claim."""


class Read(BaseModel):
    """What a person found at one place."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    verdict: Verdict
    reason: Annotated[str, StringConstraints(min_length=1)]
    correction: str = ""

    @model_validator(mode="after")
    def _corrects_what_is_wrong(self) -> Self:
        # One slip in `verdict` must not be enough to accuse somebody, or to acquit.
        if bool(self.correction) != self.verdict.is_fault:
            raise ValueError("`correction` belongs to the verdicts erratum and editorial")
        return self


def load_readings(paper: str) -> dict[str, Read]:
    """Return the readings of a paper by claim id; none where the paper has no such file.

    Raises `BadInput` with all faults of the file.
    """
    package = f"omniproof.papers.{paper.replace('-', '_')}"
    if find_spec(package) is None:
        return {}
    path = Path(str(files(package).joinpath("readings.yaml")))
    if not path.exists():
        return {}
    document = load_document(path)
    try:
        return TypeAdapter(dict[str, Read]).validate_python(document.values)
    except ValidationError as error:
        known = sorted(Read.model_fields)
        items = (dict(item, known=known) for item in error.errors(include_url=False))
        raise BadInput(model_fault(item, document) for item in items) from None


def unfit(readings: Mapping[str, Read], loaded: LoadedPaper) -> Iterator[Fault]:
    """Find verdicts that a claim cannot take, and corrections to what is printed."""
    for claim in loaded.claims:
        if claim.id in readings:
            for said in _unfit(readings[claim.id], claim):
                yield loaded.fault(claim.id, *said)


def _unfit(reading: Read, claim: Claim) -> Iterator[tuple[str, str]]:
    allowed = sorted(ALLOWED.get(claim.kind, ()))
    if not allowed:
        yield f"expected no reading of this {claim.kind}, found one", "it is computed: leave it out"
    elif reading.verdict not in allowed:
        message = f"expected a reading with one of {', '.join(allowed)}, found {reading.verdict}"
        yield message, f"mend `verdict` in readings.yaml, or the claim's kind ({claim.kind})"
    if reading.correction and reading.correction.split() == (claim.quote or "").split():
        message = f"expected a correction, found what is printed: {reading.correction}"
        yield message, "mend `correction` in readings.yaml"
