"""The same model stepped by Drake, whose contact mechanics is another one than MuJoCo's.

One description for both: MuJoCo only reads the XML and makes numbers of it (masses, frames, shapes,
gains). From these a Drake plant is built body by body, and after each step its places and speeds
are written back as MuJoCo's. Drake's own are the dynamics of the bodies, the search for contacts,
contact forces, friction, and the solver. Drake reads MJCF as well, but it leaves out what decides
here: which geoms may touch, how soft contacts are, speed servos.

The mathematics differs. MuJoCo asks for accelerations under constraints that give way. Drake, with
its approximation "lagged", solves a convex problem for the speeds at the end of a step; its contact
force is Hunt and Crossley's k x (1 + d v), and friction is Coulomb's, rounded off below a slip of
`STICTION`, with the normal force of the step before. Source: A. Castro, X. Han, J. Masterjohn,
Irrotational contact fields, arXiv:2312.03908.

How soft: a contact of MuJoCo (with elliptic cones) at rest under gravity sinks by the depth
x = g (1 - d0) / d0 (d1 T)^2, with the time constant T of its `solref` and d0, d1 of its `solimp`
(MuJoCo's documentation, "Solver parameters"). Drake's stiffness is that under which the driven
wheels, each with its share of the weight, sink as deep; and d = 2 / sqrt(g x) damps critically
about that depth.
"""

from __future__ import annotations

import logging
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import sqrt
from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np
from pydrake.common.eigen_geometry import Quaternion
from pydrake.geometry import (
    AddContactMaterial,
    CollisionFilterDeclaration,
    Ellipsoid,
    GeometrySet,
    HalfSpace,
    ProximityProperties,
    Sphere,
)
from pydrake.math import RigidTransform
from pydrake.multibody.plant import AddMultibodyPlant, CoulombFriction, MultibodyPlantConfig
from pydrake.multibody.tree import (
    FixedOffsetFrame,
    QuaternionFloatingJoint,
    RevoluteJoint,
    RotationalInertia,
    SpatialInertia,
    UnitInertia,
)
from pydrake.systems.analysis import Simulator
from pydrake.systems.framework import DiagramBuilder

if TYPE_CHECKING:
    from omniproof.simulation.engine import Advance, Control

STICTION = 1e-4
"""Slip (m/s) at which friction is near its limit: 1/500 of the speed that the robot drives at."""

FREE, HINGE = int(mujoco.mjtJoint.mjJNT_FREE), int(mujoco.mjtJoint.mjJNT_HINGE)

# Drake says on every start that half-spaces cannot touch soft bodies; there are none.
logging.getLogger("drake").setLevel(logging.ERROR)


def stepper(model: mujoco.MjModel, data: mujoco.MjData) -> Advance:
    """Return what takes `data` some steps on by Drake, from the state it has.

    What it returns are warnings, at most one: Drake gave up. Raises `ValueError` for a model with
    what is not translated here.
    """
    twin = _twin(model)
    twin.start(data)

    def advance(control: Control, steps: int) -> Sequence[str]:
        for _ in range(steps):
            control(model, data)
            try:
                twin.step(data)
            except RuntimeError as error:
                return [str(error)]
        return ()

    return advance


@dataclass(frozen=True)
class _Twin:
    """A Drake plant for a model, and where its numbers are in MuJoCo's order.

    `context` is the plant's state. `places` and `rates` index Drake's positions and velocities;
    `free` are MuJoCo's addresses of the joints that turn freely, place and rate. `motors` are the
    inputs of the actuators.
    """

    model: mujoco.MjModel
    plant: Any
    simulator: Any
    context: Any
    places: np.ndarray
    rates: np.ndarray
    free: tuple[tuple[int, int], ...]
    motors: np.ndarray

    def start(self, data: mujoco.MjData) -> None:
        """Take over places and speeds."""
        places, rates = np.empty(self.model.nq), np.empty(self.model.nv)
        places[self.places] = data.qpos
        rates[self.rates] = self._turned(data.qpos, data.qvel, to_world=True)
        self.plant.SetPositions(self.context, places)
        self.plant.SetVelocities(self.context, rates)
        self.simulator.Initialize()

    def step(self, data: mujoco.MjData) -> None:
        """Make one step under the inputs of `data`, and write the new state there."""
        model, step = self.model, self.model.opt.timestep
        driven = model.jnt_dofadr[model.actuator_trnid[:, 0]]
        torques = np.zeros(self.plant.num_actuators())
        torques[self.motors] = (
            model.actuator_gainprm[:, 0] * data.ctrl
            + model.actuator_biasprm[:, 2] * data.qvel[driven]
        )
        self.plant.get_actuation_input_port().FixValue(self.context, torques)
        # Counted in steps, as sums of steps would drift off the clock that Drake keeps.
        done = round(self.simulator.get_context().get_time() / step)
        self.simulator.AdvanceTo((done + 1) * step)
        data.time += step
        data.qpos[:] = self.plant.GetPositions(self.context)[self.places]
        rates = self.plant.GetVelocities(self.context)[self.rates]
        data.qvel[:] = self._turned(data.qpos, rates, to_world=False)

    def _turned(self, qpos: np.ndarray, qvel: np.ndarray, *, to_world: bool) -> np.ndarray:
        """Give spins in the world's frame, as Drake has them, for the body's, or back."""
        turned = np.array(qvel)
        for place, rate in self.free:
            quaternion = qpos[place + 3 : place + 7] * (
                [1, 1, 1, 1] if to_world else [1, -1, -1, -1]
            )
            mujoco.mju_rotVecQuat(
                turned[rate + 3 : rate + 6], qvel[rate + 3 : rate + 6], quaternion
            )
        return turned


# Translation -------------------------------------------------------------------------------------


def _twin(model: mujoco.MjModel) -> _Twin:
    """Build the plant of a model, and what steps it."""
    for fault in _untranslated(model):
        raise ValueError(f"expected a model that Drake can run too, found {fault}")
    builder = DiagramBuilder()
    plant, joints, motors = _plant(model, builder)
    simulator = Simulator(builder.Build())
    return _Twin(
        model,
        plant,
        simulator,
        plant.GetMyMutableContextFromRoot(simulator.get_mutable_context()),
        np.concatenate([_places(model, joint, drake) for joint, drake in joints.items()]),
        np.concatenate([_rates(model, joint, drake) for joint, drake in joints.items()]),
        tuple((model.jnt_qposadr[one], model.jnt_dofadr[one]) for one in _free(model)),
        motors,
    )


def _plant(model: mujoco.MjModel, builder: Any) -> tuple[Any, dict[int, Any], np.ndarray]:
    """Add a plant; return it, its joints by MuJoCo's numbers, and the inputs of the motors."""
    config = MultibodyPlantConfig(
        time_step=model.opt.timestep,
        contact_model="point",
        discrete_contact_approximation="lagged",
        stiction_tolerance=STICTION,
    )
    plant, scene = AddMultibodyPlant(config, builder)
    plant.mutable_gravity_field().set_gravity_vector(model.opt.gravity)
    bodies = _bodies(model, plant)
    joints = {joint: _joint(model, plant, bodies, joint) for joint in range(model.njnt)}
    actuators = {joint: _actuator(model, plant, joints[joint], joint) for joint in _hinges(model)}
    geoms = _geoms(model, plant, bodies)
    plant.Finalize()
    _keep_apart(model, scene, geoms)
    motors = [actuators[joint].input_start() for joint in model.actuator_trnid[:, 0]]
    return plant, joints, np.array(motors, dtype=int)


SHAPES = {
    int(mujoco.mjtGeom.mjGEOM_PLANE): lambda size: HalfSpace(),
    int(mujoco.mjtGeom.mjGEOM_ELLIPSOID): lambda size: Ellipsoid(*size),
    int(mujoco.mjtGeom.mjGEOM_SPHERE): lambda size: Sphere(size[0]),
}


def _untranslated(model: mujoco.MjModel) -> Iterator[str]:
    """Yield what a model has that the plant would not have."""
    joints = set(model.jnt_type) - {FREE, HINGE}
    if joints or (model.body_jntnum[1:] != 1).any() or model.jnt_pos.any():
        yield "joints that are no hinges through the middle of a body, nor free"
    if {*model.geom_type[_colliding(model)]} - {*SHAPES}:
        yield "contacts of other shapes than planes, spheres and ellipsoids"
    if model.opt.cone != mujoco.mjtCone.mjCONE_ELLIPTIC:
        yield "friction cones with edges"
    if model.neq or model.ntendon or model.jnt_limited.any() or model.jnt_stiffness.any():
        yield "equalities, tendons, limits or springs"
    for name in ("friction", "solref", "solimp", "condim"):
        # Of two unlike numbers the engines would make different ones.
        if len(np.unique(getattr(model, f"geom_{name}")[_colliding(model)], axis=0)) > 1:
            yield f"contacts that differ in {name}"


def _colliding(model: mujoco.MjModel) -> np.ndarray:
    return np.flatnonzero(model.geom_contype | model.geom_conaffinity)


def _hinges(model: mujoco.MjModel) -> np.ndarray:
    return np.flatnonzero(model.jnt_type == HINGE)


def _free(model: mujoco.MjModel) -> np.ndarray:
    return np.flatnonzero(model.jnt_type == FREE)


def _pose(place: np.ndarray, quaternion: np.ndarray) -> RigidTransform:
    return RigidTransform(Quaternion(quaternion / np.linalg.norm(quaternion)), place)


def _bodies(model: mujoco.MjModel, plant: Any) -> list[Any]:
    """Add all bodies; the world is the first of them."""
    bodies = [plant.world_body()]
    for body in range(1, model.nbody):
        mass, centre = model.body_mass[body], model.body_ipos[body]
        axes = _pose(centre, model.body_iquat[body]).rotation()
        about_axes = RotationalInertia(*model.body_inertia[body])
        unit = UnitInertia.SetFromRotationalInertia(
            UnitInertia(), about_axes.ReExpress(axes), mass
        ).ShiftFromCenterOfMass(centre)
        name = model.body(body).name or f"body {body}"
        bodies.append(plant.AddRigidBody(name, SpatialInertia(mass, centre, unit)))
    return bodies


def _joint(model: mujoco.MjModel, plant: Any, bodies: list[Any], joint: int) -> Any:
    """Add a joint: free, or a hinge where its body hangs on the parent."""
    number = model.jnt_bodyid[joint]
    body, parent = bodies[number], bodies[model.body_parentid[number]]
    if model.jnt_type[joint] == FREE:
        frames = (plant.world_frame(), body.body_frame())
        return plant.AddJoint(QuaternionFloatingJoint(f"joint {joint}", *frames))
    pose = _pose(model.body_pos[number], model.body_quat[number])
    hung = plant.AddFrame(FixedOffsetFrame(f"hinge {joint}", parent.body_frame(), pose))
    damping = model.dof_damping[model.jnt_dofadr[joint]]
    axis = model.jnt_axis[joint]
    return plant.AddJoint(
        RevoluteJoint(f"joint {joint}", hung, body.body_frame(), axis, damping=damping)
    )


def _actuator(model: mujoco.MjModel, plant: Any, drake: Any, joint: int) -> Any:
    """Add an actuator to a hinge; Drake has armature nowhere else."""
    actuator = plant.AddJointActuator(f"actuator {joint}", drake)
    actuator.set_default_rotor_inertia(model.dof_armature[model.jnt_dofadr[joint]])
    actuator.set_default_gear_ratio(1.0)
    return actuator


def _geoms(model: mujoco.MjModel, plant: Any, bodies: list[Any]) -> dict[int, Any]:
    """Add the shapes that may touch others, with what decides their contacts."""
    colliding = _colliding(model)
    if not colliding.size:
        return {}
    depth, stiffness = contact_depth(model), contact_stiffness(model)
    gravity = float(np.linalg.norm(model.opt.gravity))
    added = {}
    for geom in colliding:
        friction = model.geom_friction[geom, 0]
        properties = ProximityProperties()
        AddContactMaterial(
            properties=properties,
            dissipation=2 / sqrt(gravity * depth),
            # Two geoms give way one behind the other.
            point_stiffness=2 * stiffness,
            friction=CoulombFriction(friction, friction),
        )
        pose = _pose(model.geom_pos[geom], model.geom_quat[geom])
        shape = SHAPES[model.geom_type[geom]](model.geom_size[geom])
        added[geom] = plant.RegisterCollisionGeometry(
            bodies[model.geom_bodyid[geom]], pose, shape, f"geom {geom}", properties
        )
    return added


def contact_depth(model: mujoco.MjModel) -> float:
    """Depth (m) of a contact at rest under gravity, as MuJoCo has it; see the top of the module."""
    geom = _colliding(model)[0]
    time_constant, damping = model.geom_solref[geom]
    first, last = model.geom_solimp[geom, :2]
    gravity = np.linalg.norm(model.opt.gravity)
    return float(gravity * (1 - first) / first * (last * time_constant * damping) ** 2)


def contact_stiffness(model: mujoco.MjModel) -> float:
    """Stiffness (N/m) of a contact under which the driven wheels sink as deep, or the one body."""
    weight = model.body_mass.sum() * np.linalg.norm(model.opt.gravity)
    return float(weight / max(1, model.nu) / contact_depth(model))


def _keep_apart(model: mujoco.MjModel, scene: Any, geoms: dict[int, Any]) -> None:
    """Let only those geoms touch whose bits say so."""
    filters = scene.collision_filter_manager()
    for one, added in geoms.items():
        met = model.geom_contype[one] & model.geom_conaffinity
        met |= model.geom_contype & model.geom_conaffinity[one]
        apart = [other for geom, other in geoms.items() if not met[geom] and other != added]
        filters.Apply(
            CollisionFilterDeclaration().ExcludeBetween(GeometrySet(added), GeometrySet(apart))
        )


def _places(model: mujoco.MjModel, joint: int, drake: Any) -> np.ndarray:
    """Where the place of a joint is in Drake's positions; of a free one, the turn stands first."""
    free = model.jnt_type[joint] == FREE
    return drake.position_start() + np.array([4, 5, 6, 0, 1, 2, 3] if free else [0])


def _rates(model: mujoco.MjModel, joint: int, drake: Any) -> np.ndarray:
    """Where the speed of a joint is in Drake's velocities; of a free one, the spin stands first."""
    free = model.jnt_type[joint] == FREE
    return drake.velocity_start() + np.array([3, 4, 5, 0, 1, 2] if free else [0])
