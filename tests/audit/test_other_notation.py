"""A setting of ours that makes a formula false is asked for, not charged to the paper."""

from __future__ import annotations

from pathlib import Path

import pytest
import tiny_paper
from sympy import cos, sin

from omniproof.audit import run
from omniproof.audit.ledger import Ledger
from omniproof.registry import Registry
from omniproof.transcription.faults import BadInput

HEAD = tiny_paper.PAPER.lstrip().partition("tables:")[0].partition("  - {latex: 'f'")[0]
CLAIMS = r"""claims:
  - {id: 'eq:1', kind: identity, line: 1, says: a part, latex: 'x / 3 L'}
  - {id: 'eq:2', kind: identity, line: 2, says: turned, latex: '\cos(90 + x)'}
  - {id: 'eq:3', kind: identity, line: 3, says: short, latex: 'c y'}
"""
MORE = CLAIMS + "  - {id: 'eq:4', kind: identity, line: 4, says: half, latex: '1 / 2 x'}\n"
GOOD = "notation: {slash: all, angles: degrees, functions: {c: cos}}\n"


def audited(folder: Path, patch: pytest.MonkeyPatch, notation: str, claims: str = CLAIMS) -> Ledger:
    registry = Registry("tiny-paper")
    registry.derives("eq:1")(lambda: tiny_paper.x / (3 * tiny_paper.L))
    registry.derives("eq:2")(lambda: -sin(tiny_paper.x))
    registry.derives("eq:3")(lambda: cos(tiny_paper.y))
    if claims == MORE:
        registry.derives("eq:4")(lambda: tiny_paper.x / 2)
    patch.setattr(run, "load_registry", lambda paper: registry)
    patch.chdir(folder)
    Path("paper.yaml").write_text(HEAD + notation + claims, encoding="utf-8")
    return run.audit_paper(Path())


def test_the_right_settings(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    rows = audited(tmp_path, monkeypatch, GOOD).rows
    assert [row.verdict.value for row in rows] == ["verified"] * 3


@pytest.mark.parametrize(
    ("old", "new", "claim", "wanted", "found"),
    [
        pytest.param("slash: all", "slash: first", "eq:1", "slash: all", "slash: first",
                     id="slash"),
        pytest.param("angles: degrees, ", "", "eq:2", "angles: degrees", "angles: none",
                     id="angles"),
        pytest.param("c: cos", "c: tan", "eq:3", "c: cos", "c: tan", id="shorthand"),
    ],
)  # fmt: skip
def test_a_wrong_setting_is_asked_for(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    old: str, new: str, claim: str, wanted: str, found: str,
) -> None:  # fmt: skip
    with pytest.raises(BadInput) as bad:
        audited(tmp_path, monkeypatch, GOOD.replace(old, new))
    (fault,) = bad.value.faults
    assert (fault.file, fault.path) == ("paper.yaml", f"claims[{claim}].latex")
    assert fault.message == f"expected `{wanted}`, under which more of it is true, found `{found}`"


def test_a_setting_that_other_formulas_need_is_believed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = GOOD.replace("slash: all", "slash: first")
    rows = audited(tmp_path, monkeypatch, text, MORE).rows
    assert [row.verdict.value for row in rows] == ["erratum", *["verified"] * 3]
