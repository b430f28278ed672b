"""Rollers on a sphere and wheels under a platform: one matrix, written three times."""

from __future__ import annotations

from collections.abc import Sequence

from sympy import Expr, ImmutableMatrix, Symbol, cos, diag, pi, sin, symbols

from omniproof.kinematics import ballbot, frames, omni, sphere
from omniproof.papers.one_mechanics.statements import (
    ARRANGEMENT,
    BALLBOT,
    RADIUS,
    REGULAR,
    SPIN,
    THREE,
    TRAJECTORY,
    TWO,
    UP,
    equal,
    joined,
    same,
)
from omniproof.registry import Obligation, Step, Theorem

AZIMUTHS = symbols("a_1:4", real=True)
TILT = Symbol("psi", real=True)
SPEEDS = ImmutableMatrix(symbols("nu_1:4", real=True))
WEIGHTS = diag(cos(TILT), cos(TILT), sin(TILT))
ZENITH = Symbol("phi", real=True)
INNER, OUTER = symbols("L rho", positive=True)
TURN = 5 * pi / 6
"""The ballbot's azimuths are those of the other papers, turned by 150 degrees."""


# Rollers on the equator


def _on_equator(azimuths: Sequence[Expr], tilt: Expr = TILT) -> list[tuple[ImmutableMatrix, ...]]:
    """Contact and axis of rollers on the equator that share the angle psi."""
    return [
        (
            sphere.contact_direction(azimuth, 0),
            sphere.roller_axis(*sphere.tangent_base(azimuth, 0), tilt),
        )
        for azimuth in azimuths
    ]


def _rows_of_the_wheel_matrix() -> Sequence[Obligation]:
    """Speeds without slip along the driven directions, for any spin and any three azimuths."""
    rollers = _on_equator(AZIMUTHS)
    asked = [
        -sphere.slip_velocity(SPIN, p, eta, 0, RADIUS).dot(sphere.driven_direction(p, eta))
        for p, eta in rollers
    ]
    twist = RADIUS * WEIGHTS * SPIN
    return same(omni.velocity_matrix(AZIMUTHS) * twist, ImmutableMatrix(asked))


def _sideways() -> Sequence[Obligation]:
    """Determinant of the driven directions."""
    driven = [sphere.driven_direction(p, eta) for p, eta in _on_equator(AZIMUTHS)]
    determinant = ImmutableMatrix.hstack(*driven).det(method="berkowitz")
    return [equal(determinant, cos(TILT) * sin(TILT) ** 2 * omni.singular(AZIMUTHS))]


def _regular_spin(tilt: Expr = TILT) -> tuple[list[tuple[ImmutableMatrix, ...]], ImmutableMatrix]:
    rollers = _on_equator(REGULAR, tilt)
    contacts, axes = ([roller[k] for roller in rollers] for k in (0, 1))
    return rollers, sphere.least_squares_spin(contacts, axes, list(SPEEDS), RADIUS)


def _forward() -> Sequence[Obligation]:
    _, spin = _regular_spin()
    twist = omni.twist_matrix(omni.velocity_matrix(REGULAR)) * SPEEDS
    return same(-RADIUS * spin, WEIGHTS * twist)


def _slip_is_the_yaw() -> Sequence[Obligation]:
    rollers, spin = _regular_spin(ImmutableMatrix([0])[0])
    mean = sum(SPEEDS) / 3
    slips = [
        sphere.slip_velocity(spin, p, eta, speed, RADIUS)
        for (p, eta), speed in zip(rollers, SPEEDS, strict=True)
    ]
    yaw = (omni.twist_matrix(omni.velocity_matrix(REGULAR)) * SPEEDS)[2]
    return joined([equal(yaw, mean)], *(same(slip, -mean * UP) for slip in slips))


# Three papers, one wheel matrix


def _turned() -> ImmutableMatrix:
    """A planar turn of the platform's axes, on (V_x, V_y, yaw rate)."""
    return frames.axes(frames.rotation("z", -TURN))


def _rows_by_angles() -> Sequence[Obligation]:
    lever = INNER * sin(ZENITH)
    rows = ImmutableMatrix([[-sin(a), cos(a), lever] for a in ballbot.AZIMUTHS])
    return joined(
        same(omni.wheel_matrix(ballbot.AZIMUTHS, lever), rows),
        same(ballbot.law_over_surface_at_rest(ZENITH, INNER), rows),
    )


def _same_matrix() -> Sequence[Obligation]:
    printed = ballbot.law_over_surface_at_rest(ZENITH, INNER)
    regular = omni.wheel_matrix(REGULAR, INNER * sin(ZENITH))
    return same(printed, regular * _turned())


def _rolling_matrix() -> Sequence[Obligation]:
    scale = INNER / OUTER * cos(ZENITH)
    regular = omni.wheel_matrix(REGULAR, INNER * sin(ZENITH))
    law = ballbot.relative_law(ZENITH, INNER, OUTER)
    return same(law, regular * _turned() * diag(scale, scale, 1))


def _ballbot_wheels_are_rollers() -> Sequence[Obligation]:
    """One wheel at any azimuth: contact and axis as a roller's, and the law from the sphere."""
    azimuth = AZIMUTHS[0]
    elevation = ZENITH - pi / 2
    frame = ballbot.contact_frame(azimuth, ZENITH, INNER)
    p = sphere.contact_direction(azimuth, elevation)
    eta = sphere.roller_axis(*sphere.tangent_base(azimuth, elevation), -pi / 2)
    ball = ballbot.ball_twist(SPIN[0], SPIN[1], SPIN[2], OUTER)
    over = -sphere.slip_velocity(ball.rotation, p, eta, 0, INNER)
    law = ballbot.wheel_law(ZENITH, INNER, OUTER, azimuths=[azimuth])
    driven = sphere.driven_direction(p, eta)
    return joined(
        same(frames.origin(frame), INNER * p),
        same(frames.axes(frame)[:, 1], driven),
        [equal(over.dot(driven), law[0, 0] * SPIN[0] + law[0, 1] * SPIN[1] + law[0, 3] * SPIN[2])],
    )


def _no_loss() -> Sequence[Obligation]:
    """Rolling about level axes moves the surface along the axes too, where wheels let it pass."""
    azimuth = AZIMUTHS[0]
    p = sphere.contact_direction(azimuth, ZENITH - pi / 2)
    eta = sphere.roller_axis(*sphere.tangent_base(azimuth, ZENITH - pi / 2), -pi / 2)
    ball = ballbot.ball_twist(SPIN[0], SPIN[1], SPIN[2], OUTER)
    across = sphere.slip_velocity(ball.rotation, p, eta, 0, INNER).dot(eta)
    level = INNER / OUTER * (cos(azimuth) * SPIN[0] + sin(azimuth) * SPIN[1])
    return [equal(across, level)]


# What the two simulations draw


def _motion_prescribed() -> Sequence[Obligation]:
    ball = ballbot.ball_twist(SPIN[0], SPIN[1], SPIN[2], RADIUS)
    w_x, w_y, _ = ball.rotation
    square = (SPIN[0] ** 2 + SPIN[1] ** 2) / RADIUS**2
    return [equal(w_x**2 + w_y**2, square)]


ELEVATION = Symbol("theta", real=True)
VELOCITY = ImmutableMatrix([*symbols("V_x V_y", real=True), 0])
SHRUNK = 1 + sin(ELEVATION) ** 2


def raised_triangle() -> list[tuple[ImmutableMatrix, ImmutableMatrix, Expr]]:
    """Contact, axis (psi = 0) and speed of three rollers at one elevation.

    The speeds are those that V gives the wheels of a platform that does not yaw.
    """
    rollers = []
    for azimuth in REGULAR:
        east, north = sphere.tangent_base(azimuth, ELEVATION)
        axis = sphere.roller_axis(east, north, 0)
        contact = sphere.contact_direction(azimuth, ELEVATION)
        rollers.append((contact, axis, axis.dot(VELOCITY)))
    return rollers


def raised_spin() -> ImmutableMatrix:
    """Least-squares spin of `raised_triangle`."""
    contacts, axes, speeds = (list(column) for column in zip(*raised_triangle(), strict=True))
    return sphere.least_squares_spin(contacts, axes, speeds, RADIUS)


def _printed_inputs() -> Sequence[Obligation]:
    """The paper's inputs are those of a V of size 1 that turns."""
    time = Symbol("varphi", real=True)
    moving = {VELOCITY[0]: sin(time), VELOCITY[1]: -cos(time)}
    inputs = (sin(time + 4 * pi / 3), sin(time + 2 * pi / 3), sin(time))
    return [
        equal(speed.subs(moving), given)
        for (_, _, speed), given in zip(raised_triangle(), inputs, strict=True)
    ]


def _speeds_prescribed() -> Sequence[Obligation]:
    return same(raised_spin(), -VELOCITY / (RADIUS * SHRUNK))


def _slips_of_the_triangle() -> Sequence[Obligation]:
    """Squared slips, from the size of V and the speed of the roller."""
    size, spin = VELOCITY.dot(VELOCITY), raised_spin()
    gain = (sin(ELEVATION) / SHRUNK) ** 2
    checks = []
    for contact, axis, speed in raised_triangle():
        slip = sphere.slip_velocity(spin, contact, axis, speed, RADIUS)
        checks.append(equal(slip.dot(slip), gain * (size - cos(ELEVATION) ** 2 * speed**2)))
    return checks


def _speed_below_size() -> Sequence[Obligation]:
    """The speed of a roller takes all values from 0 to the size of V."""
    (_, axis, speed), *_ = raised_triangle()
    outward = axis.cross(UP)
    square = VELOCITY.dot(VELOCITY)
    return [equal(square - speed**2, VELOCITY.dot(outward) ** 2)]


THEOREMS = (
    Theorem(
        "thm:rollers-on-equator",
        "Rollers on the equator are an omni platform",
        r"Three rollers on the equator that share the angle $\psi$ have the wheel matrix of a "
        r"platform: without slip along the driven directions, the row of each is "
        r"$(-\sin\theta_{1,i}, \cos\theta_{1,i}, 1)$ on $-r(\cos\psi\,\omega_x, \cos\psi\,"
        r"\omega_y, \sin\psi\,\omega_z)$ in place of $(V_x, V_y, L\dot\phi)$. What differs is the "
        r"other direction. An omni wheel lets it go, a constraint roller holds it, which makes six "
        r"equations for three unknowns: the determinant of the driven directions $\mathbf{e}_i$ is "
        r"$\cos\psi\sin^2\psi\det A$, and for $0° < \psi < 90°$ and three contacts no motion is "
        r"without slip. In the "
        r"regular triangle the least-squares spin is the forward kinematics of the platform times "
        r"these weights: $-r\omega_x = \cos\psi\,V_x$, $-r\omega_y = \cos\psi\,V_y$, $-r\omega_z = "
        r"\sin\psi\,L\dot\phi$. At $\psi = 0°$ all slip is the yaw of the platform: each roller "
        r"slips by $-(\nu_1 + \nu_2 + \nu_3)/3$ along the $z$-axis. So the “nonslip case” of the "
        r"paper needs inputs that add up to zero, as its own do.",
        (THREE, ARRANGEMENT, TRAJECTORY),
        (
            Step("The rows, for any azimuths, any spin.", _rows_of_the_wheel_matrix),
            Step("The determinant of the driven directions.", _sideways),
            Step("The spin in the regular triangle.", _forward),
            Step(r"The slips at $\psi = 0°$.", _slip_is_the_yaw),
        ),
    ),
    Theorem(
        "thm:one-wheel-matrix",
        "One wheel matrix in three papers",
        r"The matrix of the ballbot's Eq. (10) is that of Eq. (5) of the arrangement paper with "
        r"$(\alpha_1, \alpha_2, \alpha_3) = (180°, -60°, 60°)$ and the body radius $L\sin\phi$: "
        r"row $k$ is $(-\sin\alpha_k, \cos\alpha_k, L\sin\phi)$ on velocity and yaw rate. It is "
        r"also Eq. (3) of the trajectory paper, with the same radius, after a turn of the "
        r"platform's axes by 150°: $30° + 150° = 180°$, and so on, in the same order of the "
        r"wheels. The law of the ball that rolls has the factor $\frac{L}{\rho}\cos\phi$ before "
        r"both columns of translation.",
        (BALLBOT, ARRANGEMENT, TRAJECTORY),
        (
            Step(
                "Both matrices have these rows.",
                _rows_by_angles,
            ),
            Step("The matrix of the regular triangle after the turn.", _same_matrix),
            Step("The law of the rolling ball.", _rolling_matrix),
        ),
    ),
    Theorem(
        "thm:ballbot-rollers",
        "The ballbot's wheels are rollers that slide along their axes",
        r"A wheel of the ballbot at the zenith angle $\phi$ touches the ball where a roller of the "
        r"three-roller paper with $\theta_2 = \phi - 90°$ does, and drives it as that roller does "
        r"with $\psi = -90°$ (axis along the meridian). Its law is the speed of that roller "
        r"without slip, with the sign of platform over ball instead of ball over platform. With "
        r"constraint rollers in place of the wheels the ball could not roll at all without slip: "
        r"along their axes its surface moves by $\frac{L}{\rho}(\cos\beta_k\,v_x + \sin\beta_k\,"
        r"v_y)$, whatever $\phi$ is, and no $\mathbf{v}$ but zero makes all three vanish.",
        (BALLBOT, THREE),
        (
            Step(
                "Contact, driven direction and law of one wheel at any azimuth.",
                _ballbot_wheels_are_rollers,
            ),
            Step("The motion along the axis.", _no_loss),
        ),
    ),
    Theorem(
        "thm:two-simulations",
        "What the two simulations draw",
        r"The two-roller paper prescribes the motion, the three-roller paper the speeds. Where "
        r"$\mathbf{V}$ is prescribed, $(\omega_x, \omega_y)$ runs on the circle of radius "
        r"$\|\mathbf{V}\|/r$ whatever the rollers are: all its ellipses lie above one circle. "
        r"The speeds of the three-roller paper are those of a platform with $\|\mathbf{V}\| = 1$ "
        r"m/s that does not yaw; three rollers at the elevation $\theta$ with $\psi = 0$ turn them "
        r"into $\boldsymbol\omega = -\mathbf{V}/(r(1 + \sin^2\theta))$. Its circles shrink by "
        r"$1 + \sin^2\theta$, and roller $i$ slips by $\frac{\sin\theta}{1 + \sin^2\theta}"
        r"\sqrt{\|\mathbf{V}\|^2 - \nu_i^2\cos^2\theta}$: between $\frac{\sin^2\theta}"
        r"{1 + \sin^2\theta}\|\mathbf{V}\|$, at $\nu_i = \pm\|\mathbf{V}\|$, and "
        r"$\frac{\sin\theta}{1 + \sin^2\theta}\|\mathbf{V}\|$, at $\nu_i = 0$.",
        (TWO, THREE, TRAJECTORY),
        (
            Step(r"A ball that rolls with the velocity $\mathbf{V}$.", _motion_prescribed),
            Step(
                r"The printed inputs come from $\mathbf{V} = (\sin\varphi, -\cos\varphi)$.",
                _printed_inputs,
            ),
            Step("The least-squares spin.", _speeds_prescribed),
            Step("The squared slip of each roller.", _slips_of_the_triangle),
            Step(
                r"$\|\mathbf{V}\|^2 - \nu_i^2$ is a square: $|\nu_i| \le \|\mathbf{V}\|$.",
                _speed_below_size,
            ),
        ),
    ),
)
