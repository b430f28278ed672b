"""No character of an input acts on a terminal, whichever door it comes in by."""

from __future__ import annotations

import json
import logging
import re
import unicodedata
from pathlib import Path
from types import SimpleNamespace

import pytest
from snakemake_interface_logger_plugins.common import LogEvent

from omniproof import cli
from omniproof.audit.ledger import Ledger
from omniproof.transcription.faults import Fault
from omniproof.visible import one_line, visible, visible_json
from snakemake_logger_plugin_steps import LogHandler

ACTING = [
    pytest.param("\x1b", r"\x1b", id="escape"),
    pytest.param("\x07", r"\x07", id="bell"),
    pytest.param("\r", r"\r", id="carriage return"),
    pytest.param("\x7f", r"\x7f", id="delete"),
    pytest.param("\x9b", r"\x9b", id="C1: one-byte escape sequence"),
    pytest.param("\x85", r"\x85", id="C1: next line"),
    pytest.param("\u202e", r"\u202e", id="right-to-left override"),
    pytest.param("\u2066", r"\u2066", id="isolate"),
    pytest.param("\u200e", r"\u200e", id="left-to-right mark"),
    pytest.param("\u061c", r"\u061c", id="Arabic letter mark"),
    pytest.param("\u200b", r"\u200b", id="zero width space"),
    pytest.param("\ufeff", r"\ufeff", id="byte order mark"),
    pytest.param("\u00ad", r"\xad", id="soft hyphen"),
    pytest.param("\u2028", r"\u2028", id="line separator"),
    pytest.param("\U000e0041", r"\U000e0041", id="tag"),
    pytest.param("\ufe0f", r"\ufe0f", id="variation selector"),
    pytest.param("\u3164", r"\u3164", id="Hangul filler"),
    pytest.param("\ue000", r"\ue000", id="private use"),
    pytest.param("\ud800", r"\ud800", id="half a character"),
    pytest.param("\U0010ffff", r"\U0010ffff", id="no character"),
]
SHOWN = "a \\alpha \N{GREEK SMALL LETTER THETA} 30\N{DEGREE SIGN} ✓ 漢字 é\N{NO-BREAK SPACE}"


def raw(text: str) -> set[str]:
    """Return the characters of a text that a terminal would act on."""
    return {c for c in text if c != "\n" and unicodedata.category(c) in {"Cc", "Cf", "Cs", "Zl"}}


@pytest.mark.parametrize(("character", "escape"), ACTING)
def test_escapes(character: str, escape: str) -> None:
    assert visible(f"a{character}b\n\tc") == f"a{escape}b\n\tc"
    assert one_line(f"a{character}\n") == rf"a{escape}\n"
    written = json.dumps({"key": f"a{character}b"}, ensure_ascii=False, indent=1)
    assert json.loads(visible_json(written)) == {"key": f"a{character}b"}
    assert raw(visible_json(written)) == set()


def test_what_has_a_glyph_stays() -> None:
    assert visible(SHOWN) == one_line(SHOWN) == visible_json(SHOWN) == SHOWN


HOSTILE = "\x1b]0;x\x07\x9b31m\u202e\u2066\u200b\U000e0041\x7f"
RUN = ["simulate", "omni-robot", "line-0-flying"]
WAYS = [
    pytest.param(["check", f"x {HOSTILE} = 1"], id="a formula"),
    pytest.param(["check", rf"x = x \text{{ {HOSTILE} }}"], id="text in a formula"),
    pytest.param(["check", "--json", f"x {HOSTILE} = 1"], id="a formula, to JSON"),
    pytest.param(["check", "x = 1", "--positive", HOSTILE], id="a symbol"),
    pytest.param(["check", "x = 1", "--between", f"0 < {HOSTILE}"], id="a range"),
    pytest.param(["check", "x = 1", "--slash", HOSTILE], id="a choice"),
    pytest.param(["check", "x = 1", "--limit", HOSTILE], id="a number"),
    pytest.param(["check", "x = 1", "--function", f"c={HOSTILE}"], id="a function"),
    pytest.param(["check", "x = 1", f"more\n{HOSTILE}"], id="one word too many"),
    pytest.param(["check", "x = 1", f"--{HOSTILE}"], id="an option"),
    pytest.param([HOSTILE], id="a command"),
    pytest.param(["audit", HOSTILE], id="a folder"),
    pytest.param(["simulate", HOSTILE, "x"], id="a model"),
    pytest.param(["simulate", "omni-robot", HOSTILE], id="a case"),
    pytest.param([*RUN, "--set", HOSTILE], id="a parameter"),
    pytest.param([*RUN, "--set", f"mass={HOSTILE}"], id="a value"),
    pytest.param([*RUN, "--engine", HOSTILE], id="an engine"),
    pytest.param([*RUN, "--output", f"{HOSTILE}/x"], id="an output"),
]  # fmt: skip


@pytest.mark.parametrize("arguments", WAYS)
def test_what_is_typed(
    arguments: list[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    try:
        status = cli.main(arguments)
    except SystemExit as stop:
        status = int(stop.code or 0)
    out, err = capsys.readouterr()
    assert (status in {0, 1, 2}, raw(out + err)) == (True, set())
    assert re.search(r"\\x1b|\\u001b", out + err), "escaped, not dropped"


@pytest.mark.parametrize("arguments", [[], ["--json"]])
def test_what_a_ledger_says(
    arguments: list[str],
    root: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    example = root / "tests/report/fixtures/results/ledger/omni-arrangement.json"
    ledger = Ledger.model_validate_json(example.read_bytes())
    rows = tuple(row.model_copy(update={"note": HOSTILE}) for row in ledger.rows)
    hostile = ledger.model_copy(update={"rows": rows})
    monkeypatch.setattr("omniproof.audit.run.audit_paper", lambda folder: hostile)
    assert cli.main(["audit", "anywhere", *arguments]) == 0
    out, err = capsys.readouterr()
    assert (raw(out + err), "\\u202e" in out) == (set(), True)
    if arguments:
        assert Ledger.model_validate_json(out) == hostile


@pytest.mark.parametrize("kind", [ValueError, KeyError, OSError])
def test_what_an_exception_says(
    kind: type[Exception], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def fail(folder: Path) -> Ledger:
        raise kind(HOSTILE)

    monkeypatch.setattr("omniproof.audit.run.audit_paper", fail)
    assert cli.main(["audit", "anywhere"]) in {2, 4}
    assert raw("".join(capsys.readouterr())) == set()


def test_the_display_of_a_build(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log = tmp_path / "audit.log"
    log.write_text(f"---- message ----\npaper.yaml:1:1: {HOSTILE}\n", encoding="utf-8")
    handler = LogHandler(SimpleNamespace(dryrun=False), None)
    for fields in (
        {"event": LogEvent.JOB_INFO, "jobid": 1, "rule_name": "audit", "rule_msg": HOSTILE},
        {"event": LogEvent.JOB_ERROR, "jobid": 1, "rule_name": "audit", "log": [str(log)]},
    ):
        record = logging.LogRecord("snakemake", logging.INFO, "", 0, HOSTILE, None, None)
        record.__dict__.update(fields)
        handler.emit(record)
    handler.close()
    assert raw(capsys.readouterr().err) == set()


def test_a_fault_keeps_to_its_line() -> None:
    """A name with a line break in it cannot forge a message."""
    fault = Fault("a\nb", 1, 1, "claims[x\ny]", "expected a key", "add it")
    assert str(fault) == "a\\nb:1:1: claims[x\\ny]: expected a key\n    add it"
