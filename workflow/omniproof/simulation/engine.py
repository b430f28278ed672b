"""One run of a model: headless, deterministic, and loud where it left physics behind.

Models are MuJoCo's. Who steps them is a switch: MuJoCo itself, or Drake (`drake_engine`), whose
states come back as MuJoCo's, so that one control, one observation and one check serve both.

MuJoCo does not stop at nonsense: a diverged state is reset in silence, a stiff servo makes a robot
jump, a hard push drives bodies into each other. All of them end in numbers that look like results.
So every instant that is recorded is looked at first, and a run that is not plausible raises
`ImplausibleRunError` with the parameters that bring it about again.

A run may begin before time 0, to come to rest on the floor or to gather speed; it is recorded from
time 0 on. Bits are equal from run to run for one release of an engine on one machine, not beyond.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from functools import partial
from types import MappingProxyType

import mujoco
import numpy as np

from omniproof.simulation.engines import USUAL, require

Parameters = Mapping[str, float | str]
Control = Callable[[mujoco.MjModel, mujoco.MjData], None]
"""Sets actuators (`data.ctrl`) or forces (`data.qfrc_applied`) before each step."""
Observe = Callable[[mujoco.MjModel, mujoco.MjData], Mapping[str, float]]
"""Reads the columns of a recording off the state, in SI units."""
Advance = Callable[[Control, int], Sequence[str]]
"""Takes the state so many steps on; returns the warnings of an engine that has no other way."""

Progress = Callable[[float], None]
"""Takes the share of a run that is done, from 0 to 1."""
_PROGRESS: ContextVar[Progress | None] = ContextVar("progress", default=None)

NO_PARAMETERS: Parameters = MappingProxyType({})


@dataclass(frozen=True)
class Limits:
    """What a plausible run stays below; a model that knows better says so."""

    speed: float = 10.0
    """Speed of any body's centre (m/s)."""
    penetration: float = 1e-3
    """Depth of any contact (m)."""
    energy: float = 100.0
    """Kinetic energy (J)."""
    spin: float = 100.0
    """Rate at which any body turns, rollers too (rad/s)."""


DEFAULT_LIMITS = Limits()


@dataclass(frozen=True)
class Recording:
    """What was observed: `time` (n,) in s from 0, and columns (n,) by name."""

    time: np.ndarray
    columns: Mapping[str, np.ndarray]


class ImplausibleRunError(Exception):
    """A run that left physics behind: why, and the parameters that bring it about again."""

    def __init__(self, reason: str, parameters: Parameters) -> None:
        self.reason = reason
        self.parameters = parameters
        listed = ", ".join(f"{name}={value}" for name, value in parameters.items())
        super().__init__(f"{reason}\n    to reproduce: {listed}")


def run(  # noqa: PLR0913 - all by name
    xml: str,
    *,
    duration: float,
    step: float,
    control: Control,
    observe: Observe,
    every: float,
    start: float = 0.0,
    limits: Limits = DEFAULT_LIMITS,
    parameters: Parameters = NO_PARAMETERS,
    engine: str = USUAL,
) -> Recording:
    """Step the model `xml` from time `start` (<= 0) to `duration`; record each `every` from 0 on.

    All times in s; `start` and `duration` are whole multiples of `every`, and `every` of `step`.
    `parameters` are what the model was built from, for the message of a run that fails. Raises
    `ImplausibleRunError`; `ValueError` for times that do not fit and a model that is rejected;
    `UnknownNameError` or `MissingEngineError` for an `engine` that is not there.
    """
    require(engine)
    stride = _whole("every", every, "step", step)
    first, last = (
        _whole("start", start, "every", every),
        _whole("duration", duration, "every", every),
    )
    model, data = _at_start(xml, step, start)
    advance = _stepper(engine, model, data)
    rows, report = [], _PROGRESS.get()
    with _warnings() as warned:
        for instant in range(first, last + 1):
            # A step leaves places and contacts of its beginning beside the state of its end.
            mujoco.mj_forward(model, data)
            for fault in _faults(model, data, limits, warned):
                shown = {**parameters, "step": step}
                raise ImplausibleRunError(f"at t = {instant * every:.4g} s {fault}", shown)
            if instant >= 0:
                rows.append(observe(model, data))
            if report:
                report((instant - first) / max(1, last - first))
            if instant < last:
                warned.extend(advance(control, stride))
    columns = {name: np.array([row[name] for row in rows]) for name in rows[0]}
    return Recording(every * np.arange(len(rows)), MappingProxyType(columns))


@contextmanager
def reporting(progress: Progress) -> Iterator[None]:
    """Tell `progress` how far the runs inside are: models need not pass it on."""
    token = _PROGRESS.set(progress)
    try:
        yield
    finally:
        _PROGRESS.reset(token)


def _at_start(xml: str, step: float, start: float) -> tuple[mujoco.MjModel, mujoco.MjData]:
    model = mujoco.MjModel.from_xml_string(xml)
    model.opt.timestep = step
    model.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
    data = mujoco.MjData(model)
    data.time = start
    return model, data


@contextmanager
def _warnings() -> Iterator[list[str]]:
    """Collect MuJoCo's warnings, which it would else write to a file in the current folder."""
    warned: list[str] = []
    before = mujoco.get_mju_user_warning()
    mujoco.set_mju_user_warning(warned.append)
    try:
        yield warned
    finally:
        mujoco.set_mju_user_warning(before)


def _stepper(engine: str, model: mujoco.MjModel, data: mujoco.MjData) -> Advance:
    """Return what takes `data` some steps on, under a control, and says what went wrong."""
    if engine == USUAL:
        return partial(_advance, model, data)
    from omniproof.simulation.drake_engine import stepper

    return stepper(model, data)


def _advance(
    model: mujoco.MjModel, data: mujoco.MjData, control: Control, steps: int
) -> Sequence[str]:
    for _ in range(steps):
        control(model, data)
        mujoco.mj_step(model, data)
    return ()


def _whole(long: str, dividend: float, short: str, divisor: float) -> int:
    """Return the quotient of two times, which has to be whole: steps would drift off the clock."""
    quotient = round(dividend / divisor)
    if abs(quotient * divisor - dividend) > 1e-9 * max(divisor, abs(dividend)):
        raise ValueError(f"expected {long} to be a multiple of {short} = {divisor}, got {dividend}")
    return quotient


def _faults(
    model: mujoco.MjModel, data: mujoco.MjData, limits: Limits, warned: Sequence[str]
) -> Iterator[str]:
    """Yield what is not plausible about a state; MuJoCo warns of a divergence, and goes on."""
    yield from (f"the engine warned: {warning}" for warning in warned)
    if not (np.isfinite(data.qpos).all() and np.isfinite(data.qvel).all()):
        yield "the state is not finite"
    speed = np.linalg.norm(_velocities(model, data), axis=1).max()
    if speed > limits.speed:
        yield f"a body moves at {speed:.3g} m/s, more than {limits.speed:g}"
    spin = np.linalg.norm(data.cvel[:, :3], axis=1).max()
    if spin > limits.spin:
        yield f"a body turns at {spin:.3g} rad/s, more than {limits.spin:g}"
    depth = -data.contact.dist.min(initial=0.0)
    if depth > limits.penetration:
        yield f"a contact is {depth:.3g} m deep, more than {limits.penetration:g}"
    if data.energy[1] > limits.energy:
        yield f"the kinetic energy is {data.energy[1]:.3g} J, more than {limits.energy:g}"


def _velocities(model: mujoco.MjModel, data: mujoco.MjData) -> np.ndarray:
    """Return the velocities (m/s) of the centres of all bodies: (n, 3)."""
    # MuJoCo's spatial velocities refer to the centre of the whole tree that a body hangs on.
    arms = data.xipos - data.subtree_com[model.body_rootid]
    return data.cvel[:, 3:] + np.cross(data.cvel[:, :3], arms)
