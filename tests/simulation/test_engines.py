"""Which physics engines there are, and what is said of one that is not."""

import pytest

from omniproof import cli
from omniproof.simulation import engines
from omniproof.simulation.case import MODELS, models
from omniproof.simulation.engines import MissingEngineError, can_run, require
from omniproof.simulation.names import UnknownNameError

CASE = ("simulate", "omni-robot", "circle-left-flying", "--set", "duration=0.1")
MISSING = (
    "expected the physics engine 'drake' to be installed, found no package 'pydrake'\n"
    "    `make` installs it where there is one: for Linux on x86-64 with glibc 2.34 or newer,"
    " and for macOS on Arm"
)


@pytest.fixture
def without_drake(monkeypatch):
    monkeypatch.setattr(engines, "find_spec", lambda name: None if name == "pydrake" else object())


def test_the_usual_engine_is_there():
    require("mujoco")


def test_an_engine_that_there_is_none_of():
    with pytest.raises(UnknownNameError, match=r"found 'darke'\n.*did you mean `drake`"):
        require("darke")


@pytest.mark.usefixtures("without_drake")
def test_an_engine_that_is_not_installed():
    with pytest.raises(MissingEngineError) as caught:
        require("drake")
    assert str(caught.value) == MISSING


@pytest.mark.usefixtures("without_drake")
def test_its_cases_are_left_out_and_no_others():
    names = [case.name for name in MODELS for case in models()[name].cases]
    assert [name for name in names if not can_run(name)] == [
        "circle-left-flying-drake",
        "circle-left-standing-drake",
    ]


def test_a_case_that_is_named_after_an_engine_runs_on_it():
    for case in (case for name in MODELS for case in models()[name].cases):
        engine = case.name.rpartition("-")[2]
        if engine in engines.PACKAGES:
            assert case.parameters["engine"] == engine
        else:
            assert case.parameters.get("engine", engines.USUAL) == engines.USUAL


@pytest.mark.usefixtures("without_drake")
@pytest.mark.parametrize(
    "arguments",
    [
        pytest.param((*CASE, "--engine", "drake"), id="option"),
        pytest.param((*CASE, "--set", "engine=drake"), id="parameter"),
        pytest.param(("simulate", "omni-robot", "circle-left-flying-drake"), id="case"),
    ],
)
def test_a_missing_engine_is_bad_input(capsys, arguments):
    assert cli.main(arguments) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.endswith(f"{MISSING}\n")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        pytest.param(
            (*CASE, "--engine", "mujocco"),
            "expected a physics engine, found 'mujocco'\n    did you mean `mujoco`?\n",
            id="unknown",
        ),
        pytest.param(
            ("simulate", "sphere", "two-0-dry", "--engine", "drake"),
            "expected the engine 'mujoco' for sphere, found 'drake'\n    its contacts are those of"
            " mujoco alone; omni-robot runs on mujoco and drake\n",
            id="a model that only one engine can run",
        ),
    ],
)
@pytest.mark.skipif(not engines.is_installed("drake"), reason="Drake has no package here")
def test_bad_engines(capsys, arguments, message):
    assert cli.main(arguments) == 2
    assert capsys.readouterr() == ("", message)


@pytest.mark.skipif(not engines.is_installed("drake"), reason="Drake has no package here")
def test_another_engine_by_the_command_line(capsys):
    assert cli.main([*CASE, "--set", "step=0.001", "--engine", "drake"]) == 0
    other = capsys.readouterr().out
    assert cli.main([*CASE, "--set", "step=0.001", "--engine", "mujoco"]) == 0
    usual = capsys.readouterr().out
    assert usual.splitlines()[0] == other.splitlines()[0]
    assert usual != other
