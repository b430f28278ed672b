"""What the least-squares point is physically, and where dry friction leads instead.

A friction law turns slips into forces; a sphere whose centre is held comes to a steady spin where
these have no torque about it. The torque of forces -f(|s|) s/|s| is minus the gradient of a sum
over the rollers, so that steady spins are its minima: of the sum of squares for viscous friction,
of the sum of sizes for dry friction under equal loads. Both are the power lost in the contacts.

The sum of sizes is convex, but has kinks where a roller sticks. There friction is any tangent force
up to its limit, and a balanced set of such forces is what proves a minimum: see `_certificate`.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import permutations

from sympy import (
    ImmutableMatrix,
    Integer,
    Rational,
    Symbol,
    asin,
    cos,
    pi,
    sin,
    sqrt,
    symbols,
    tan,
    zeros,
)

from omniproof.kinematics import sphere
from omniproof.papers.one_mechanics.platforms import (
    ELEVATION,
    VELOCITY,
    raised_spin,
    raised_triangle,
)
from omniproof.papers.one_mechanics.rollers import BETWEEN, SPEEDS, TILTS, level_pair
from omniproof.papers.one_mechanics.statements import (
    RADIUS,
    REGULAR,
    SPIN,
    THREE,
    TWO,
    UP,
    equal,
    joined,
    roller,
    same,
    vanish,
)
from omniproof.registry import Family, Obligation, Step, Theorem
from omniproof.transcription.model import Form

SHARE = Symbol("t", real=True)
STICKS_BELOW = asin(1 / sqrt(3))
"""35.26 degrees: up to here friction can hold the middle roller of the raised triangle."""


# Viscous friction


def _torque_is_the_slope() -> Sequence[Obligation]:
    """For one roller: gradient of the squared slip, torque of the slip, normal equations."""
    (p, eta), speed = roller("1"), SPEEDS[0]
    slip = sphere.slip_velocity(SPIN, p, eta, speed, RADIUS)
    torque = RADIUS * p.cross(slip)
    square = slip.dot(slip)
    gradient = ImmutableMatrix([square.diff(component) for component in SPIN])
    residual = sphere.normal_matrix([p]) * SPIN - sphere.right_side([p], [eta], [speed], RADIUS)
    return joined(same(gradient, 2 * torque), same(torque, RADIUS**2 * residual))


# Any friction, equal drive


def _equal_drive() -> Sequence[Obligation]:
    """Slip of each of three regular rollers at a spin about z, and torque of equal slips."""
    tilt, speed, rate = symbols("psi nu w", real=True)
    spin = rate * UP
    free = speed * sin(tilt) / (RADIUS * cos(ELEVATION))
    torque, checks = zeros(3, 1), []
    for azimuth in REGULAR:
        east, north = sphere.tangent_base(azimuth, ELEVATION)
        p = sphere.contact_direction(azimuth, ELEVATION)
        axis = sphere.roller_axis(east, north, tilt)
        slip = sphere.slip_velocity(spin, p, axis, speed, RADIUS)
        across = RADIUS * cos(ELEVATION) * (rate + free) * east
        checks.append(same(slip, across - speed * cos(tilt) * north))
        torque += p.cross(north)
    return joined(*checks, vanish(torque))


# Dry friction, two rollers


def _on_the_segment() -> Sequence[Obligation]:
    """Slips at the share t of the way from line 1 to line 2."""
    contacts, axes = level_pair()
    spin = sphere.least_squares_spin(contacts, axes, SPEEDS, RADIUS)
    (mu, lam), (alpha, gamma) = SPEEDS, TILTS
    gap = mu * sin(alpha) - lam * sin(gamma)
    moved = spin + (2 * SHARE - 1) * gap / (2 * RADIUS) * UP
    easts = [sphere.tangent_base(azimuth, 0)[0] for azimuth in (Integer(0), BETWEEN)]
    slips = [
        sphere.slip_velocity(moved, p, eta, speed, RADIUS)
        for p, eta, speed in zip(contacts, axes, SPEEDS, strict=True)
    ]
    return joined(
        same(slips[0], SHARE * gap * easts[0]), same(slips[1], (SHARE - 1) * gap * easts[1])
    )


def _balanced_pair() -> Sequence[Obligation]:
    contacts, _ = level_pair()
    easts = [sphere.tangent_base(azimuth, 0)[0] for azimuth in (Integer(0), BETWEEN)]
    torques = [p.cross(east) for p, east in zip(contacts, easts, strict=True)]
    return joined(same(torques[0], UP), same(torques[1], UP))


def _equal_in_the_middle() -> Sequence[Obligation]:
    """Difference of the squared shares of the slip: it is zero half-way only."""
    return [equal(SHARE**2 - (1 - SHARE) ** 2, 2 * (SHARE - Rational(1, 2)))]


def _only_along_the_normal() -> Sequence[Obligation]:
    """A torque p x u of a unit tangent u is perpendicular to p: of both contacts, up or down."""
    contacts, _ = level_pair()
    normal = ImmutableMatrix(contacts[0].cross(contacts[1]))
    return same(normal, sin(BETWEEN) * UP)


# Dry friction, three rollers on the equator


def _triangle_on_the_equator() -> Sequence[Obligation]:
    """Slips for any level spin: along z, with one sum for all spins."""
    speeds = ImmutableMatrix(symbols("nu_1:4", real=True))
    level = ImmutableMatrix([SPIN[0], SPIN[1], 0])
    slips = []
    for azimuth, speed in zip(REGULAR, speeds, strict=True):
        p, (east, _) = sphere.contact_direction(azimuth, 0), sphere.tangent_base(azimuth, 0)
        slips.append(sphere.slip_velocity(level, p, east, speed, RADIUS))
    return joined(
        *(vanish(slip[:2, :]) for slip in slips),
        [equal(sum(slip[2] for slip in slips), -sum(speeds))],
    )


def _torques_on_the_equator() -> Sequence[Obligation]:
    contacts = [sphere.contact_direction(azimuth, 0) for azimuth in REGULAR]
    return vanish(sum((p.cross(UP) for p in contacts), zeros(3, 1)))


# Dry friction, the raised triangle of the three-roller paper


def outward(index: int) -> ImmutableMatrix:
    """Level unit vector h from the z-axis to the contact of a roller."""
    return sphere.contact_direction(REGULAR[index], 0)


def dry_spin(middle: int) -> ImmutableMatrix:
    """Spin under dry friction where the roller `middle` (from 0) sticks."""
    lift = tan(ELEVATION) * VELOCITY.dot(outward(middle))
    return ImmutableMatrix(-(VELOCITY + lift * UP) / RADIUS)


def _dry_slips() -> Sequence[Obligation]:
    """Along X: by how far each V.h differs from the middle one; no slip at the middle one."""
    checks = []
    for middle in range(3):
        for index, (p, axis, speed) in enumerate(raised_triangle()):
            slip = sphere.slip_velocity(dry_spin(middle), p, axis, speed, RADIUS)
            apart = VELOCITY.dot(outward(index) - outward(middle))
            checks.append(same(slip, sin(ELEVATION) * apart * axis))
    return joined(*checks)


def _certificate() -> Sequence[Obligation]:
    """Unit forces along +X and -X at the outer rollers, and one along Y at the middle one."""
    rollers = raised_triangle()
    checks = []
    for high, middle, low in permutations(range(3)):
        turn = 1 if (high - low) % 3 == 1 else -1
        p, axis, _ = rollers[middle]
        held = turn * sqrt(3) * sin(ELEVATION) * sphere.driven_direction(p, axis)
        torques = [
            rollers[high][0].cross(rollers[high][1]),
            -rollers[low][0].cross(rollers[low][1]),
            p.cross(held),
        ]
        checks.append(vanish(sum(torques, zeros(3, 1))))
        checks.append([equal(held.dot(held), 3 * sin(ELEVATION) ** 2)])
    return joined(*checks)


def _friction_suffices() -> Sequence[Obligation]:
    below = {ELEVATION: (-STICKS_BELOW, STICKS_BELOW)}
    return [
        equal(3 * sin(STICKS_BELOW) ** 2, Integer(1)),
        Obligation(Form.POSITIVE, Family(1 - 3 * sin(ELEVATION) ** 2, below)),
    ]


def _printed_elevations() -> Sequence[Obligation]:
    """The raised patterns of the paper, II to IV."""
    return [Obligation(Form.INCREASING, (pi / 18, pi / 9, pi / 6, STICKS_BELOW))]


def _no_second_spin() -> Sequence[Obligation]:
    """Where the middle roller sticks, spin may change along p_m only; that slips at others along Y.

    A second minimum would have its slips where the forces of the certificate are: none at the
    middle roller, whose force is below the limit, and along X at the others.
    """
    rollers = raised_triangle()
    checks = []
    for middle, other in permutations(range(3), 2):
        p, (q, axis, _) = rollers[middle][0], rollers[other]
        turn = 1 if (other - middle) % 3 == 1 else -1
        along = p.cross(q).dot(sphere.driven_direction(q, axis))
        checks.append(equal(along, turn * sqrt(3) / 2 * cos(ELEVATION)))
    return checks


def _another_spin() -> Sequence[Obligation]:
    """Level parts of both spins."""
    shrunk = 1 + sin(ELEVATION) ** 2
    return joined(*(same(dry_spin(k)[:2, :], shrunk * raised_spin()[:2, :]) for k in range(3)))


THEOREMS = (
    Theorem(
        "thm:viscous",
        "The least-squares point is the steady state of viscous friction",
        r"Let each roller act on the sphere with the force $-c\,\boldsymbol\zeta_i$, in proportion "
        r"to the slip $\boldsymbol\zeta_i$ and with one $c$ for all, and let the centre of the "
        r"sphere be held; its mass is spread alike around the centre. Then the torque about the "
        r"centre is $-c\,r^2(M\boldsymbol\omega + \frac1r\sum_i\nu_i\boldsymbol\eta_i)$, and the "
        r"spin tends to the least-squares point from wherever it starts, unless all contacts lie "
        r"on one line through the centre. With different $c_i$ it tends to the point of least "
        r"squares weighted by them. Neither paper names a friction law; under this one their "
        r"optimum is the motion, for any number of rollers.",
        (TWO, THREE),
        (
            Step(
                r"For one roller, any place and spin: the torque $r\,\mathbf{p}\times"
                r"\boldsymbol\zeta$ is half the slope of the squared slip, and $r^2$ times the "
                r"residual of the normal equations. $M$ is positive definite "
                r"([above](one-mechanics.html#thm-one-best-spin)), so that the spin decays to its "
                r"solution.",
                _torque_is_the_slope,
            ),
        ),
    ),
    Theorem(
        "thm:equal-drive",
        "Where all friction laws agree on one steady spin",
        r"Three rollers in a regular triangle at the elevation $\theta$, with one angle $\psi$ and "
        r"one speed $\nu$, have the steady spin $-\frac{\nu\sin\psi}{r\cos\theta}$ about the "
        r"$z$-axis under any friction that depends on the slip in one way for all: the "
        r"least-squares point is steady under dry friction, too. All three slip by $\nu\cos\psi$ "
        r"along the meridian.",
        (THREE,),
        (
            Step(
                r"At the spin $w$ about $z$ the slip of each is $(r\,w\cos\theta + \nu\sin\psi)\,"
                r"X_i - \nu\cos\psi\,Y_i$; where the first part is zero, friction is along all "
                r"$Y_i$ alike and has no torque.",
                _equal_drive,
            ),
        ),
    ),
    Theorem(
        "thm:dry-two",
        "Two rollers under dry friction: a whole segment",
        r"Let friction have one size $\mu N$ at both rollers, against the slip; at a roller that "
        r"sticks, any size up to this. The steady spins are then *all* points of the common "
        r"perpendicular between the two lines, ends included. Its middle, the point of the "
        r"two-roller paper, is one of them; which one is reached depends on the start. The sum of "
        r"the slips is $|\nu_1\sin\alpha_1 - \nu_2\sin\alpha_2|$ at each. With unequal loads only "
        r"one end remains: the more heavily loaded roller sticks, and the other one has all slip. "
        r"Under a friction that grows with the slip, in one way at both, only the middle remains: "
        r"for two rollers the optimum needs no friction in proportion to the slip.",
        (TWO,),
        (
            Step(
                r"At the share $t$ of the way from line 1 to line 2, with $g = \nu_1\sin\alpha_1 - "
                r"\nu_2\sin\alpha_2$, the slips are $t\,g\,X_1$ and $-(1 - t)\,g\,X_2$.",
                _on_the_segment,
            ),
            Step(
                r"Both $\mathbf{p}_i\times X_i$ are $\mathbf{e}$: friction along $-X_1$ and $X_2$ "
                r"is balanced. At an end, the roller that sticks bears what the other one asks "
                r"for, if its limit is as high: with unequal loads, at one end only.",
                _balanced_pair,
            ),
            Step(
                r"No other spin will do: torques $\mathbf{p}_i\times\mathbf{u}_i$ of two unit "
                r"tangents balance only where both are along $\pm\mathbf{p}_1\times\mathbf{p}_2$, "
                r"so that the slips are along the $X_i$, and opposite; where one roller sticks, "
                r"its torque is perpendicular to both contacts as well. This holds for forces of "
                r"any size, and asks for two of one size.",
                _only_along_the_normal,
            ),
            Step(
                r"Where friction grows with the slip, forces of one size are slips of one size: "
                r"$|t\,g| = |(1 - t)\,g|$ at $t = \frac12$ only.",
                _equal_in_the_middle,
            ),
        ),
    ),
    Theorem(
        "thm:dry-equator",
        "Three rollers on the equator under dry friction: a whole triangle",
        r"In the regular triangle on the equator with $\psi = 0°$, under dry friction with equal "
        r"loads, the steady spins are all level spins for which no two rollers slip in opposite "
        r"directions. They fill an equilateral triangle, with sides on the lines $l_i$, "
        r"and its centre is the least-squares point. It shrinks to a point exactly if "
        r"$\nu_1 + \nu_2 + \nu_3 = 0$, as in the paper's Pattern I.",
        (THREE,),
        (
            Step(
                "A level spin slips along $z$ only, and the sum of the three slips is "
                r"$-(\nu_1 + \nu_2 + \nu_3)$ for each: the sum of their sizes is least where they "
                "have one sign. A spin about $z$ would add slip across it at every roller. At the "
                "least-squares point all three are equal "
                "([above](one-mechanics.html#thm-rollers-on-equator)).",
                _triangle_on_the_equator,
            ),
            Step("Equal forces along $z$ at the three contacts balance.", _torques_on_the_equator),
        ),
    ),
    Theorem(
        "thm:dry-raised",
        "The three-roller simulation under dry friction",
        r"For speeds that add up to zero, those of $\mathbf{V}$ say, and $\psi = 0°$, the steady "
        r"spin under dry friction with equal loads is $\boldsymbol\omega = -\frac1r(V_x, V_y, "
        r"\tan\theta\,\mathbf{V}\cdot\mathbf{h}_m)$, for every elevation $|\theta| < 35.26°$: with "
        r"the level unit vectors $\mathbf{h}_i$ towards the contacts, roller $m$ is the one with "
        r"the middle value of $\mathbf{V}\cdot\mathbf{h}_i$. It sticks, and the others slip along "
        r"$X_i$ by $\sin\theta\,\mathbf{V}\cdot(\mathbf{h}_i - \mathbf{h}_m)$. Seen from above, "
        r"the spin runs on one circle of radius $\|\mathbf{V}\|/r$ for all patterns. The "
        r"paper's circles are smaller by the factor $1 + \sin^2\theta$: that tells viscous from "
        r"dry friction, and an experiment could decide.",
        (THREE,),
        (
            Step("Slips at all three rollers, whichever sticks.", _dry_slips),
            Step(
                r"Unit forces against the slips of the outer two, along $X_i$, are balanced by a "
                r"force of size $\sqrt3|\sin\theta|$ along $Y_m$ at the third, for every order of "
                r"the rollers. That proves a minimum of the sum of slips, which is convex.",
                _certificate,
            ),
            Step(r"Friction can hold it: $\sqrt3|\sin\theta| < 1$.", _friction_suffices),
            Step(
                r"No other spin will do: $(\mathbf{p}_m\times\mathbf{p}_i)\cdot Y_i = "
                r"\pm\frac{\sqrt3}{2}\cos\theta$, so that the outer rollers would no longer slip "
                r"along $X_i$.",
                _no_second_spin,
            ),
            Step("The paper's raised patterns are in this range.", _printed_elevations),
            Step("The level part is the least-squares one without its factor.", _another_spin),
        ),
    ),
)
