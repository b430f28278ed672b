"""Another mechanics: slips in the rolling constraint, for what has to change with it."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from types import ModuleType
from typing import Any

import pytest
from at_points import Point, digits, random_point
from sympy import Expr, MatrixBase

from omniproof.decide.in_sympy.integrals import without_integrals
from omniproof.kinematics import rolling
from omniproof.registry import Curve, Family, Fit, Modelled, Obligation, Ordered, Registry, Relation

Law = Callable[..., Any]


def broken_speed(direction: Any, position: Any, velocity: Any, yaw_rate: Any) -> Any:
    """A slip in the cross product: one lever counts twice."""
    (n_x, n_y), (q_x, q_y), (v_x, v_y) = direction, position, velocity
    return n_x * (v_x - 2 * yaw_rate * q_y) + n_y * (v_y + yaw_rate * q_x)


def swapped_speed(direction: Any, position: Any, velocity: Any, yaw_rate: Any) -> Any:
    """The components of the velocity change places."""
    (n_x, n_y), (q_x, q_y), (v_x, v_y) = direction, position, velocity
    return n_x * (v_y - yaw_rate * q_y) + n_y * (2 * v_x + yaw_rate * q_x)


def longer_lever(direction: Any, position: Any, body: Any, surface: Any = rolling.REST) -> Any:
    """The body's lever counts twice."""
    return direction.dot(body.at(2 * position) - surface.at(position))


def changed(
    registry: Registry,
    build: Callable[[str], Any],
    laws: Iterable[Law],
    monkeypatch: pytest.MonkeyPatch,
    *,
    home: ModuleType = rolling,
    point: Callable[[int], Point] = random_point,
) -> set[str]:
    """Claims whose derivation gives something else under one of the laws at least.

    `build` derives a claim; each law takes the place of `rolling_speed` in the module `home`.
    """
    package = f"omniproof.papers.{registry.paper.replace('-', '_')}"
    _clear_caches(package)
    before = {claim: _values(build(claim), point(5)) for claim in registry.derivations}
    same = set(before)
    for law in laws:
        with _mechanics(law, home, package, monkeypatch):
            same -= {claim for claim in same if _values(build(claim), point(5)) != before[claim]}
    return set(before) - same


def functions(registry: Registry, claims: Iterable[str]) -> set[str]:
    """Names of the functions that derive these claims."""
    return {registry.derivations[claim].build.__name__ for claim in claims}


@contextmanager
def _mechanics(
    law: Law, home: ModuleType, package: str, monkeypatch: pytest.MonkeyPatch
) -> Iterator[None]:
    with monkeypatch.context() as patch:
        patch.setattr(home, "rolling_speed", law)
        _clear_caches(package)
        yield
    _clear_caches(package)


def _clear_caches(package: str) -> None:
    """Forget what the modules of a package have derived."""
    for name, module in list(sys.modules.items()):
        if name.startswith(package):
            for value in vars(module).values():
                getattr(value, "cache_clear", lambda: None)()


def _values(derived: Any, point: Point) -> list[str]:
    """Numbers at a point; of unknown functions of time, in symbols for them."""
    found = (without_integrals(leaf, leaf)[0] for leaf in _leaves(derived))
    return [digits(leaf, point) if isinstance(leaf, Expr) else str(leaf) for leaf in found]


def _leaves(derived: Any) -> Iterator[Any]:
    """All expressions of a derived side, premises and proof of a correction included."""
    match derived:
        case Modelled():
            yield from _leaves((derived.mechanics, derived.premises))
        case Relation():
            yield from _leaves((derived.subject, derived.premises or (), derived.proof))
        case Obligation():
            yield from _leaves(derived.subject)
        case Family():
            yield derived.expression
        case Curve():
            yield from derived.coordinates
        case Ordered():
            yield from derived.terms
        case Fit():
            yield derived.value
        case Mapping():
            yield from _leaves(list(derived.values()))
        case MatrixBase() | tuple() | list():
            yield from (leaf for value in derived for leaf in _leaves(value))
        case _:
            yield derived
