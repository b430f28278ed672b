"""The friction that leads a sphere between rollers to the papers' least-squares point.

A sphere free to turn about its centre is let go between two or three constraint rollers until its
spin is steady. With a creep far above all slips the contacts are viscous, with a small one dry; in
between a ladder of creeps shows where one theory ends, and that the other is approached.

Before any conclusion, what else could decide: the steady state of these contacts depends on no
step, since forces at rest balance whatever the step was, and a run whose spin still moves, or whose
contacts do not bear their loads, raises `ImplausibleRunError`. What is left is the depth of the
contacts, 0.016 mm: the middle of the overlap drives, which turns the sphere 3e-5 slower.

Only steady states count. On the way there MuJoCo takes off slip at the rate b at most, more gently
than dry friction of this load would a sphere of this inertia.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import product
from types import MappingProxyType

import mujoco
import numpy as np

from omniproof.simulation.case import Case, Model
from omniproof.simulation.engine import ImplausibleRunError, Limits, Parameters, Recording, run
from omniproof.simulation.sphere_model import FRICTION, commands, xml
from omniproof.simulation.sphere_rollers import set_up

VISCOUS, DRY = 1.0, 0.001
"""Creeps of the laws, m/s.

In the end no roller slips as fast as the first, and all but one slip faster than the second.
"""

LADDER = (0.3, 0.1, 0.03, 0.01, 0.003)
"""Creeps between both, m/s."""

ELEVATIONS_DEG = (10, 20, 30)
PHASES_DEG = (17, 55)
TILTS_DEG = (0, 10, 20, 30)
"""Patterns II to IV at two phases of the inputs, and angles of roller 1 of the two-roller paper."""

STEPS = (0.0005, 0.00025)
STEP = 0.001
DURATION = 8.0
EVERY = 0.1
"""Steps of the convergence study and of all others; time, and time between rows (s)."""

ASIDE, FAR = 0.25, 1.0
"""Spins about the normal of the rollers' plane at the start, rad/s.

Dry friction leaves the sphere between the lines of two rollers, or stops it at the first.
"""

EQUATOR_SPEEDS = "0.2 0.5 1"
"""Rollers on the equator whose speeds (m/s) do not add up to zero, as those of the paper do."""

LEVEL_FAR, LEVEL_STARTS_DEG = 4.0, (0, 60, 180)
"""Level spins at the start, far out of the triangle of steady ones: size in rad/s, azimuths.

The first is beyond a corner, the others are beyond sides.
"""

HEAVIER = 1.3
"""Load of roller 1 in units of that of roller 2."""

STEADY = 1e-4
"""Most that a spin may change in the last second, rad/s: a tenth of what the creep leaves.

Two rollers under dry friction hold no spin between their lines against even the least torque. With
unlike slips they are pressed in unlike depths, and so the spin wanders, by 3e-5 rad/s in a second.
"""

BORNE = 1e-6
"""Most that a contact's force may differ from the load, as a part of it."""

DECIMALS = 6
"""Of the numbers read off a run: what is less than that is round-off where theory says zero."""

LIMITS = Limits(energy=1000.0, spin=50.0)
"""Three flywheels at 1 m/s hold 125 J each, and turn at 5 rad/s."""

UNITS: Mapping[str, str] = MappingProxyType(
    {
        "error_least_squares": "rad/s",
        "error_dry": "rad/s",
        "apart": "rad/s",
        "circle_radius": "rad/s",
        "sum_of_slips": "m/s",
        "least_sum_of_slips": "m/s",
        "share": "1",
        **{f"slip_{number}": "m/s" for number in (1, 2, 3)},
        **{f"grip_{number}": "1" for number in (1, 2, 3)},
    }
)


def simulate(case: Case) -> Recording:
    """Let a sphere go and record its spin (rad/s, in the world) until it is steady.

    Columns besides `spin_x` to `spin_z`, of each roller: `slip_1` (m/s), `load_1` (N) and `grip_1`,
    friction over its limit; not a number where a roller has lost contact. Raises
    `ImplausibleRunError`.
    """
    parameters = case.parameters
    rollers = set_up(parameters).rollers
    asked = commands(rollers)
    released = float(parameters["start"]) * direction_of_start(parameters)

    def control(_: mujoco.MjModel, data: mujoco.MjData) -> None:
        if data.time == 0:
            data.qvel[:3] = released
        data.ctrl[:] = asked

    recording = run(
        xml(rollers, float(parameters["creep"])),
        duration=DURATION,
        step=float(parameters["step"]),
        every=EVERY,
        control=control,
        observe=observe,
        limits=LIMITS,
        parameters=parameters,
    )
    for fault in _faults(recording, [roller.load for roller in rollers]):
        raise ImplausibleRunError(fault, parameters)
    return recording


def direction_of_start(parameters: Parameters) -> np.ndarray:
    """Direction (3,) of the spin at the start: the normal of two rollers' plane, or a level one.

    Steady spins lie along the one for two rollers, and are level for three on the equator.
    """
    if "start_azimuth_deg" in parameters:
        azimuth = np.radians(float(parameters["start_azimuth_deg"]))
        return np.array([np.cos(azimuth), np.sin(azimuth), 0.0])
    first, second, *_ = (roller.contact for roller in set_up(parameters).rollers)
    normal = np.cross(first, second)
    return np.asarray(normal / np.linalg.norm(normal))


def observe(model: mujoco.MjModel, data: mujoco.MjData) -> Mapping[str, float]:
    """Read spin, slips and forces off a state; the columns of `simulate`."""
    spin = np.zeros(3)
    # A ball joint turns at rates in its own frame.
    mujoco.mju_rotVecQuat(spin, data.qvel[:3], data.qpos[:4])
    columns = dict(zip(("spin_x", "spin_y", "spin_z"), map(float, spin), strict=True))
    for number in range(1, model.nu // 2 + 1):
        slip, load, grip = _contact(model, data, model.geom(f"roller {number}").id)
        columns |= {f"slip_{number}": slip, f"load_{number}": load, f"grip_{number}": grip}
    return columns


def _contact(model: mujoco.MjModel, data: mujoco.MjData, geom: int) -> tuple[float, float, float]:
    """Return slip, load and grip of the contact of a roller."""
    for index in np.flatnonzero((data.contact.geom == geom).any(axis=1)):
        force = np.zeros(6)
        mujoco.mj_contactForce(model, data, index, force)
        first = data.contact.efc_address[index]
        slip = float(np.hypot(*data.efc_vel[first + 1 : first + 3]))
        limit = FRICTION * force[0]
        return slip, float(force[0]), float(np.hypot(*force[1:3]) / limit) if limit else 0.0
    return np.nan, np.nan, np.nan


def _faults(recording: Recording, loads: list[float]) -> Iterator[str]:
    """Yield what shows that the end of a run is no steady state."""
    columns = recording.columns
    spins = np.array([columns[f"spin_{axis}"] for axis in "xyz"])
    last_second = spins[:, -1 - round(1 / EVERY) :]
    moved = np.ptp(last_second, axis=1).max()
    if not moved <= STEADY:
        yield f"the spin changes by {moved:.3g} rad/s in the last second, more than {STEADY}"
    for number, load in enumerate(loads, 1):
        borne = columns[f"load_{number}"][-1]
        if not abs(borne - load) <= BORNE * load:
            yield f"roller {number} bears {borne:.6g} N at last instead of {load:.6g} N"


def summarise(case: Case, recording: Recording) -> Mapping[str, float]:
    """Compare the last instant with both theories.

    `error_least_squares` and `error_dry` are distances of spins, the latter to the nearest steady
    spin of dry friction, which lies at `share` between the lines of two rollers; `apart` is the
    distance of the least-squares point to it. `circle_radius` is the level part of the spin.
    Units: `UNITS`.
    """
    theory = set_up(case.parameters)
    last = {name: float(column[-1]) for name, column in recording.columns.items()}
    spin = np.array([last[f"spin_{axis}"] for axis in "xyz"])
    dry, shares = theory.nearest_dry(spin)
    numbers = range(1, len(theory.rollers) + 1)
    found = {
        "error_least_squares": _distance(spin, theory.least_squares),
        "error_dry": _distance(spin, dry),
        "apart": _distance(theory.least_squares, dry),
        "circle_radius": float(np.hypot(spin[0], spin[1])),
        "sum_of_slips": sum(last[f"slip_{number}"] for number in numbers),
        "least_sum_of_slips": float(theory.slips(dry).sum()),
        **{
            f"{name}_{number}": last[f"{name}_{number}"]
            for name, number in product(("slip", "grip"), numbers)
        },
    }
    if len(shares) < 3:
        found["share"] = shares[-1] if len(shares) > 1 else 0.0
    return {name: round(value, DECIMALS) for name, value in found.items()}


def _distance(one: np.ndarray, other: np.ndarray) -> float:
    return float(np.linalg.norm(one - other))


# Cases


def three(elevation: int, phase: int, name: str, creep: float, step: float = STEP) -> Case:
    """Case of three rollers: elevation of the contacts and phase of the inputs in degrees."""
    angles = {"elevation_deg": float(elevation), "phase_deg": float(phase)}
    return _case(f"three-{elevation}-{phase}-{name}", {**angles, "creep": creep, "step": step})


def two(tilt: int, name: str, creep: float, start: float = 0.0, heavier: float = 1.0) -> Case:
    """Case of two rollers: angle of roller 1 (degrees), spin at the start, ratio of the loads."""
    pair = {"tilt_deg": float(tilt), "heavier": heavier}
    return _case(f"two-{tilt}-{name}", {**pair, "creep": creep, "start": start, "step": STEP})


def equator(name: str, creep: float, start: float = 0.0, azimuth: int = 0) -> Case:
    """Case of three level rollers on the equator: size (rad/s) and azimuth of the first spin."""
    released = {"start": start, "start_azimuth_deg": float(azimuth)}
    return _case(
        f"three-equator-{name}",
        {"speeds": EQUATOR_SPEEDS, **released, "creep": creep, "step": STEP},
    )


def _case(name: str, parameters: Parameters) -> Case:
    return Case("sphere", name, MappingProxyType({"start": 0.0, **parameters}))


def _cases() -> Iterator[Case]:
    laws = (("viscous", VISCOUS), ("dry", DRY))
    for elevation, phase, law in product(ELEVATIONS_DEG, PHASES_DEG, laws):
        yield three(elevation, phase, *law)
    for tilt in TILTS_DEG:
        for law in laws:
            yield two(tilt, *law)
        yield two(tilt, "dry-from-far", DRY, start=FAR)
    yield two(TILTS_DEG[-1], "dry-from-aside", DRY, start=ASIDE)
    yield two(TILTS_DEG[-1], "dry-heavier", DRY, start=FAR, heavier=HEAVIER)
    yield equator("viscous", VISCOUS)
    yield equator("dry", DRY)
    yield equator("dry-from-aside", DRY, ASIDE, LEVEL_STARTS_DEG[0])
    for azimuth in LEVEL_STARTS_DEG:
        yield equator(f"dry-from-far-{azimuth}", DRY, LEVEL_FAR, azimuth)
    steepest, phase = ELEVATIONS_DEG[-1], PHASES_DEG[0]
    for creep in LADDER:
        yield three(steepest, phase, f"creep-{round(1000 * creep)}-mm", creep)
    for step in STEPS:
        yield three(steepest, phase, f"dry-step-{round(1e6 * step)}-us", DRY, step)


MODEL = Model(tuple(_cases()), simulate, summarise, UNITS)
