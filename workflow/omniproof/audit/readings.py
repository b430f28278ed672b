"""Verdicts by hand, allowed for references and editorial claims only, each with its reason."""

from __future__ import annotations

from importlib.resources import files
from importlib.util import find_spec
from pathlib import Path

from pydantic import BaseModel, ConfigDict, TypeAdapter, ValidationError

from omniproof.audit.ledger import Verdict
from omniproof.transcription.faults import BadInput
from omniproof.transcription.messages import model_fault
from omniproof.transcription.paperfile import load_document


class Read(BaseModel):
    """What a person found at one place."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    verdict: Verdict
    reason: str
    correction: str = ""


def load_readings(paper: str) -> dict[str, Read]:
    """Return the readings of a paper by claim id; none where the paper has no such file."""
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
        raise BadInput(
            model_fault(dict(item), document) for item in error.errors(include_url=False)
        ) from None
