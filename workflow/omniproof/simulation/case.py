"""What is simulated: models by name, each with its cases and what is read off a recording.

A model is a module of this package that defines `MODEL`; its name in files and on the command line
has hyphens (`omni-robot` is `omni_robot.py`). Modules are imported when they are asked for: the
physics engine takes a while to load.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib import import_module
from types import MappingProxyType

from omniproof.simulation.engine import Parameters, Recording
from omniproof.simulation.names import unknown

MODELS: tuple[str, ...] = ("omni-robot", "ballbot", "sphere")
"""The models, in the order of the report."""


@dataclass(frozen=True)
class Case:
    """One experiment: the model, its own name (lower-case words joined by hyphens), parameters."""

    model: str
    name: str
    parameters: Parameters


@dataclass(frozen=True)
class Model:
    """What can be done with a model: its `cases`, a run of one, the numbers read off a run.

    `units` names the unit of every quantity that `summarise` returns ("1" for a ratio).
    """

    cases: tuple[Case, ...]
    simulate: Callable[[Case], Recording]
    summarise: Callable[[Case, Recording], Mapping[str, float]]
    units: Mapping[str, str]

    def case(self, name: str) -> Case:
        """Return the case of a name; raises `UnknownNameError` with the nearest one."""
        cases = {case.name: case for case in self.cases}
        if name not in cases:
            raise unknown("case", name, cases)
        return cases[name]


def model(name: str) -> Model:
    """Return a model by its name, such as `omni-robot`; raises `UnknownNameError`."""
    if name not in MODELS:
        raise unknown("model", name, MODELS)
    found: Model = import_module(f"omniproof.simulation.{name.replace('-', '_')}").MODEL
    return found


def models() -> Mapping[str, Model]:
    """Return all models by name."""
    return MappingProxyType({name: model(name) for name in MODELS})
