"""One slip in a verdict by hand neither accuses nor acquits."""

from __future__ import annotations

from pathlib import Path

import pytest
import tiny_paper

from omniproof.audit import readings, run
from omniproof.audit.ledger import Verdict
from omniproof.audit.readings import Read, load_readings
from omniproof.transcription.faults import BadInput

GOOD = """eq:1/name:
  verdict: verified
  reason: 'the title says so'
eq:2/word:
  verdict: editorial
  reason: misspelt
  correction: novel
"""
FILE = "readings.yaml"
BELONGS = "`correction` belongs to the verdicts erratum and editorial"
SLIPS = [
    pytest.param("verified", "verfied", [
        f"{FILE}:2:12: eq:1/name.verdict: expected one of verified, conditional, erratum, "
        "misrounded, inconsistent, model-gap, editorial, uncheckable, undecided, found 'verfied'",
        "    did you mean `verified`?"], id="misspelt"),
    pytest.param("verified", "erratum", [f"{FILE}:2:3: eq:1/name: {BELONGS}"], id="accused"),
    pytest.param("editorial", "verified", [
        f"{FILE}:7:15: eq:2/word.correction: {BELONGS}"], id="acquitted"),
    pytest.param("  correction: novel\n", "", [f"{FILE}:5:3: eq:2/word: {BELONGS}"],
                 id="without the right word"),
    pytest.param("  reason: misspelt\n", "", [
        f"{FILE}:5:3: eq:2/word: expected the key `reason`, found none", "    add `reason: …`"],
        id="without a reason"),
    pytest.param("correction: novel", "corection: novel", [
        f"{FILE}:7:3: eq:2/word: expected one of correction, reason, verdict, found 'corection'",
        "    did you mean `correction`?"], id="a key misspelt"),
]  # fmt: skip


@pytest.mark.parametrize(("old", "new", "said"), SLIPS)
def test_the_file_is_refused_with_its_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, old: str, new: str, said: list[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(readings, "files", lambda package: tmp_path)
    Path(FILE).write_text(GOOD.replace(old, new), encoding="utf-8")
    with pytest.raises(BadInput) as bad:
        load_readings("ballbot")
    assert str(bad.value).splitlines()[:-1] == said


HAND = Read(verdict=Verdict.VERIFIED, reason="looked at")
AS_PRINTED = Read(verdict=Verdict.EDITORIAL, reason="misspelt", correction="noble")
UNFIT = [
    pytest.param("eq:1", HAND, "claims[eq:1]: expected no reading of this identity, found one",
                 id="computed"),
    pytest.param("sec:3/noble", HAND, "claims[sec:3/noble]: expected a reading with one of "
                 "editorial, found verified", id="no matter of wording"),
    pytest.param("sec:3/noble", AS_PRINTED,
                 "claims[sec:3/noble]: expected a correction, found what is printed: noble",
                 id="what is printed"),
]  # fmt: skip


@pytest.mark.parametrize(("claim", "reading", "said"), UNFIT)
def test_a_verdict_that_the_claim_cannot_take(
    tiny_folder: Path, monkeypatch: pytest.MonkeyPatch, claim: str, reading: Read, said: str
) -> None:
    by_hand = {**tiny_paper.READINGS, claim: reading}
    monkeypatch.setattr(run, "load_readings", lambda paper: by_hand)
    with pytest.raises(BadInput) as bad:
        run.prepare(tiny_folder)
    assert [fault.path + ": " + fault.message for fault in bad.value.faults] == [said]
