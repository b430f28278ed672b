"""The sensitivity study: its rows are what is asked, and what a row says."""

import csv
from collections import Counter
from dataclasses import replace

import pytest

from omniproof.simulation import sensitivity
from omniproof.simulation.engines import is_installed
from omniproof.simulation.omni_robot import MODEL, STARTS
from omniproof.simulation.sensitivity import PATHS, VARIED, measured, study, write

KNOWN = {case.name: case.parameters for case in MODEL.cases}


def differing(case):
    """What a case has that its path in the tables has not."""
    usual = KNOWN[case.name]
    return tuple(name for name in VARIED if case.parameters[name] != usual[name])


def test_each_path_and_start_is_varied_one_thing_at_a_time():
    changes = Counter((case.name, differing(case)) for case in study())
    assert {name for name, _ in changes} == {
        f"{path}-{start}" for path in PATHS for start in STARTS
    }
    per_path = {what: count for (name, what), count in changes.items() if name == "line-0-flying"}
    by_hand = {(): 1, ("step",): 3, ("contact_time",): 5, ("friction",): 6, ("mass",): 4}
    by_hand |= {("rollers",): 3, ("rows",): 1, ("rollers", "rows"): 3}
    if is_installed("drake"):
        by_hand |= {("engine",): 1, ("engine", "step"): 1}
    assert per_path == by_hand
    assert sum(changes.values()) == 8 * sum(by_hand.values())


def test_no_case_is_run_twice():
    cases = [(case.name, *case.parameters.values()) for case in study()]
    assert len(set(cases)) == len(cases)


def test_the_study_goes_both_ways_and_has_all_that_make_varies():
    for name, values in sensitivity.RANGES.items():
        assert min(values) < KNOWN["line-0-flying"][name] < max(values)
    asked = {tuple(case.parameters[name] for name in VARIED) for case in study()}
    small = [name for name in KNOWN if name.startswith("circle-clockwise-")]
    for name in small:
        if "body" not in name and "speed" not in name:
            assert tuple(KNOWN[name][parameter] for parameter in VARIED) in asked


def test_without_the_other_engine_its_rows_are_left_out(monkeypatch):
    monkeypatch.setattr(sensitivity, "is_installed", lambda engine: engine == "mujoco")
    assert {case.parameters["engine"] for case in study()} == {"mujoco"}


def short(**changed):
    case = MODEL.case("line-30-standing")
    return replace(case, parameters={**case.parameters, "duration": 0.1, **changed})


def test_a_row_has_parameters_errors_and_the_time(tmp_path, capsys, monkeypatch, root):
    monkeypatch.chdir(root)
    cases = [short(friction=0.1), short(armature=0.0, servo_gain=50.0)]
    write(tmp_path / "new" / "table.csv", cases)
    with (tmp_path / "new" / "table.csv").open(newline="") as stream:
        plausible, wild = csv.DictReader(stream)
    assert (plausible["path"], plausible["start"]) == ("line-30", "standing")
    assert float(plausible["friction"]) == 0.1
    recorded = MODEL.summarise(cases[0], MODEL.simulate(cases[0]))
    for error in ("length_error", "mean_error"):
        assert float(plausible[error]) == pytest.approx(recorded[error], rel=0.01)
        assert wild[error] == ""
    assert plausible["fault"] == ""
    assert "more than" in wild["fault"]
    assert float(wild["seconds"]) > 0
    assert capsys.readouterr().err.endswith("\rsensitivity: 2 of 2 runs\n")


@pytest.mark.slow
def test_from_a_flying_start_no_error_exceeds_what_the_paper_prints(monkeypatch, root):
    """Over the whole study. The least error that it prints is 0.01, the greatest 0.03, rounded."""
    monkeypatch.chdir(root)
    for case in study():
        if case.parameters["start"] == "flying":
            errors = measured(case)
            assert float(errors["length_error"]) < 0.015
            assert float(errors["mean_error"]) < 0.035
