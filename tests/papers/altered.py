"""Another mechanics: two slips in the rolling constraint, for what has to change with it."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import pytest

from omniproof.kinematics import omni


def broken_speed(direction: Any, position: Any, velocity: Any, yaw_rate: Any) -> Any:
    """A slip in the cross product: one lever counts twice."""
    (n_x, n_y), (q_x, q_y), (v_x, v_y) = direction, position, velocity
    return n_x * (v_x - 2 * yaw_rate * q_y) + n_y * (v_y + yaw_rate * q_x)


def swapped_speed(direction: Any, position: Any, velocity: Any, yaw_rate: Any) -> Any:
    """The components of the velocity change places."""
    (n_x, n_y), (q_x, q_y), (v_x, v_y) = direction, position, velocity
    return n_x * (v_y - yaw_rate * q_y) + n_y * (2 * v_x + yaw_rate * q_x)


def clear_caches(package: str) -> None:
    """Forget what the modules of a package have derived."""
    for name, module in list(sys.modules.items()):
        if name.startswith(package):
            for value in vars(module).values():
                getattr(value, "cache_clear", lambda: None)()


@contextmanager
def mechanics(
    speed: Callable[..., Any], package: str, monkeypatch: pytest.MonkeyPatch
) -> Iterator[None]:
    """Derive with another rolling constraint."""
    with monkeypatch.context() as patch:
        patch.setattr(omni, "rolling_speed", speed)
        clear_caches(package)
        yield
    clear_caches(package)
