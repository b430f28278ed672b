"""Simulations as files: which digits are kept, and what is joined."""

from types import MappingProxyType

import numpy as np
import pytest

from omniproof.simulation import files
from omniproof.simulation.case import Case, Model
from omniproof.simulation.engine import Recording
from omniproof.simulation.names import UnknownNameError

RUN = Recording(0.01 * np.arange(3), MappingProxyType({"x": np.array([0, 1 / 3, -2e-7 / 3])}))
TOY = Model(
    (Case("toy", "still", {}), Case("toy", "fast", {})),
    lambda case: RUN,
    lambda case, recording: {"length": 2 / 3, "error": 1e-9 / 3},
    {"length": "m", "error": "1"},
)


@pytest.fixture
def toy(monkeypatch):
    monkeypatch.setattr(files, "model", {"toy": TOY}.__getitem__)


def test_a_recording_has_exact_times_and_six_digits():
    assert files.recording_csv(RUN) == "time,x\n0,0\n0.01,0.333333\n0.02,-6.66667e-08\n"


def test_numbers_have_three_digits_and_units(toy, tmp_path):
    numbers, times = tmp_path / "numbers.csv", tmp_path / "times.csv"
    files.write_model("toy", {"fast": tmp_path / "fast.csv"}, numbers, times)
    head = "model,case,quantity,value,unit\n"
    rows = "toy,fast,length,0.667,m\ntoy,fast,error,3.33e-10,1\n"
    assert numbers.read_text() == head + rows
    assert (tmp_path / "fast.csv").read_text() == files.recording_csv(RUN)
    assert [line.split(",")[0] for line in times.read_text().splitlines()] == ["case", "fast"]
    files.write_summary([numbers, numbers], tmp_path / "summary.csv")
    assert (tmp_path / "summary.csv").read_text() == head + rows + rows


def test_a_case_that_there_is_none_of(toy, tmp_path):
    with pytest.raises(UnknownNameError, match="did you mean `fast`"):
        files.write_model("toy", {"fasst": tmp_path / "x"}, tmp_path / "y", tmp_path / "z")
