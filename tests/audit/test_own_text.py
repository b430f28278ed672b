"""No row says that a place should read what it reads, whatever slip of ours is behind it."""

from __future__ import annotations

from pathlib import Path

import pytest
from sympy import Dummy, Symbol, cos, sin
from tiny_paper import registry

from omniproof import cli
from omniproof.audit import run
from omniproof.audit.ledger import Row, Verdict
from omniproof.audit.own_text import OwnTextError, refuse_own_text
from omniproof.registry import Registry
from omniproof.transcription.model import Kind


@pytest.fixture
def unchecked(tiny_folder: Path, monkeypatch: pytest.MonkeyPatch) -> Registry:
    """Return derivations that nobody holds against the paper file, as if a rule were missing."""
    found = registry()
    monkeypatch.setattr(run, "load_registry", lambda paper: found)
    monkeypatch.setattr(run, "disagreements", lambda context: [])
    return found


X, Y = Symbol("x", positive=True), Dummy("y", real=True)


@pytest.mark.parametrize(
    ("claim", "value", "name"),
    [
        pytest.param("eq:8", X, "x", id="another sign"),
        pytest.param("eq:11", Y, "y", id="a symbol of its own"),
        pytest.param("eq:7", cos(X) + sin(Y), "x, y", id="two symbols"),
        pytest.param("eq:7", sin(Y) + cos(X), "x, y", id="in another order"),
    ],
)
def test_the_stop_names_the_claim_and_the_symbol(
    tiny_folder: Path, unchecked: Registry, claim: str, value: object, name: str,
    capsys: pytest.CaptureFixture[str],
) -> None:  # fmt: skip
    del unchecked.derivations[claim]
    unchecked.derives(claim)(lambda: value)
    assert cli.main(["audit", str(tiny_folder)]) == 4
    told = capsys.readouterr()
    assert told.out == ""
    found = f"two symbols have one name; its derivation has another symbol named {name}\n"
    assert told.err.endswith(f"DisagreementError: tiny-paper, {claim}: {found}")


def row(printed: str, correction: str, **fields: object) -> Row:
    known = {"paper": "p", "id": "sec:3/noble", "where": "", "kind": Kind.EDITORIAL}
    known |= {"verdict": Verdict.EDITORIAL, "printed": printed, "correction": correction}
    return Row.model_validate(known | fields)


def test_a_correction_by_hand(tiny_folder: Path) -> None:
    context = run.prepare(tiny_folder)
    assert refuse_own_text(row("noble", "novel"), context).correction == "novel"
    with pytest.raises(OwnTextError, match="its correction is written by hand"):
        refuse_own_text(row("so  noble", "so noble"), context)


IDENTITY = {"id": "eq:1", "kind": Kind.IDENTITY, "verdict": Verdict.ERRATUM}


@pytest.mark.parametrize(
    ("printed", "correction"),
    [
        pytest.param("x y", "y x", id="order of factors"),
        pytest.param(r"\sin x + 1", r"1 + \sin{\left(x\right)}", id="order of terms and brackets"),
    ],
)
def test_another_spelling_of_the_same(tiny_folder: Path, printed: str, correction: str) -> None:
    with pytest.raises(OwnTextError):
        refuse_own_text(row(printed, correction, **IDENTITY), run.prepare(tiny_folder))


def test_what_can_mean_something_else_is_another_text(tiny_folder: Path) -> None:
    mended = row("x - y", "y - x", **IDENTITY)
    assert refuse_own_text(mended, run.prepare(tiny_folder)) is mended
