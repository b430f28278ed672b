"""The physics engines by name, and which of them are installed; nothing here loads one.

MuJoCo comes with the project. Drake has no package for every platform, so it may be missing: then
the build leaves out the cases that name it, and the chapter says so.
"""

from __future__ import annotations

from collections.abc import Mapping
from importlib.util import find_spec
from types import MappingProxyType

from omniproof.simulation.names import unknown

PACKAGES: Mapping[str, str] = MappingProxyType({"mujoco": "mujoco", "drake": "pydrake"})
"""Engines by the names that cases and the command line have for them, and what is imported."""

USUAL = "mujoco"


class MissingEngineError(Exception):
    """An engine that is known, and not installed."""


def is_installed(engine: str) -> bool:
    """Whether the package of a known engine can be imported."""
    return find_spec(PACKAGES[engine]) is not None


def require(engine: str) -> None:
    """Raise `UnknownNameError` or `MissingEngineError` unless an engine can be used."""
    if engine not in PACKAGES:
        raise unknown("physics engine", engine, PACKAGES)
    if not is_installed(engine):
        raise MissingEngineError(
            f"expected the physics engine {engine!r} to be installed, found no package"
            f" {PACKAGES[engine]!r}\n    `make` installs it where there is one: for Linux on x86-64"
            " with glibc 2.34 or newer, and for macOS on Arm"
        )


def can_run(case_name: str) -> bool:
    """Whether the engine that the name of a case ends with is there; the usual one has no name."""
    engine = case_name.rpartition("-")[2]
    return engine not in PACKAGES or is_installed(engine)
