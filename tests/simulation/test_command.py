"""The command line of the simulations: CSV to stdout, talk to stderr, a status that tells."""

import csv
import io

import pytest

from omniproof import cli
from omniproof.simulation.case import MODELS, models

CASE = ("simulate", "omni-robot", "line-30-flying")
SHORT = ("--set", "duration=0.1")


def table(text):
    return list(csv.DictReader(io.StringIO(text)))


def test_a_case_is_run_and_written_as_csv(capsys):
    assert cli.main([*CASE, *SHORT]) == 0
    out, err = capsys.readouterr()
    rows = table(out)
    assert list(rows[0]) == ["time", "x", "y", "heading", "height"]
    assert [row["time"] for row in rows] == [f"{k / 100:g}" for k in range(11)]
    assert err == "omni-robot line-30-flying: done\n"


def test_output_goes_to_a_file(capsys, tmp_path):
    assert cli.main([*CASE, *SHORT]) == 0
    printed = capsys.readouterr().out
    assert cli.main([*CASE, *SHORT, "--output", str(tmp_path / "run.csv")]) == 0
    assert capsys.readouterr().out == ""
    assert (tmp_path / "run.csv").read_text() == printed


def test_summary(capsys, monkeypatch, root):
    monkeypatch.chdir(root)
    assert cli.main([*CASE, *SHORT, "--summary"]) == 0
    rows = {row["quantity"]: row for row in table(capsys.readouterr().out)}
    assert rows["length"]["unit"] == "m"
    assert float(rows["length"]["value"]) == pytest.approx(0.005, rel=0.02)


def test_progress_is_shown_on_a_terminal(capsys, monkeypatch):
    monkeypatch.setattr("sys.stderr.isatty", lambda: True)
    assert cli.main([*CASE, *SHORT]) == 0
    shown = capsys.readouterr().err.split("\r")[1:]
    assert shown[0] == f"omni-robot line-30-flying [{' ' * 30}]   0 %"
    assert shown[-1] == f"omni-robot line-30-flying [{'#' * 30}] 100 %\n"


@pytest.mark.parametrize(
    "arguments", [("simulate",), ("simulate", "--list"), ("simulate", "omni-robot", "--list")]
)
def test_list(capsys, arguments):
    assert cli.main([*arguments]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert "omni-robot line-30-flying" in lines
    own = "omni-robot" in arguments
    listed = ["omni-robot"] if own else MODELS
    assert len(lines) == sum(len(models()[name].cases) for name in listed)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        pytest.param(
            ("omni-robt", "line-30-flying"),
            "expected a model, found 'omni-robt'\n    did you mean `omni-robot`?\n",
            id="model",
        ),
        pytest.param(
            ("omni-robot", "line-30-fyling"),
            "expected a case, found 'line-30-fyling'\n    did you mean `line-30-flying`?\n",
            id="case",
        ),
        pytest.param(
            (*CASE[1:], "--set", "fricton=0.1"),
            "expected a parameter as name=value, found 'fricton'\n    did you mean `friction`?\n",
            id="parameter",
        ),
        pytest.param(
            (*CASE[1:], "--set", "friction=much"),
            "expected a number for friction, found 'much'\n",
            id="no number",
        ),
    ],
)
def test_bad_input(capsys, arguments, message):
    assert cli.main(["simulate", *arguments]) == 2
    assert capsys.readouterr() == ("", message)


def test_an_implausible_run_fails(capsys):
    wild = ("--set", "armature=0", "--set", "servo_gain=50")
    assert cli.main(["simulate", "omni-robot", "line-30-standing", *wild]) == 1
    out, err = capsys.readouterr()
    assert out == ""
    assert "to reproduce: case=line-30-standing" in err
    assert "servo_gain=50.0, armature=0.0" in err
