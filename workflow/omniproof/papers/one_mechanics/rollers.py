"""Rollers on a sphere: one best spin, two rollers as a case of it, and when nothing slips."""

from __future__ import annotations

from collections.abc import Sequence

from sympy import Expr, ImmutableMatrix, Integer, Symbol, cos, pi, sin, symbols

from omniproof.kinematics import sphere
from omniproof.papers.one_mechanics.statements import (
    RADIUS,
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

SPEEDS = symbols("nu_1 nu_2", real=True)
TILTS = symbols("alpha_1 alpha_2", real=True)
BETWEEN = Symbol("beta", real=True)
"""Angle between two contacts."""


# One best spin


def _one_square() -> Sequence[Obligation]:
    """For one roller: the square about any spin; those of N rollers add up."""
    (p, eta), speed = roller("1"), SPEEDS[0]
    moved = ImmutableMatrix(symbols("x_x:z", real=True))
    setting = ([p], [eta], [speed], RADIUS)
    (before,) = sphere.squared_distances(SPIN, *setting)
    (after,) = sphere.squared_distances(SPIN + moved, *setting)
    matrix, feet = sphere.normal_matrix([p]), sphere.right_side(*setting)
    slope = matrix * SPIN - feet
    return [equal(after, before + 2 * moved.dot(slope) + moved.dot(matrix * moved))]


def _sum_of_squares() -> Sequence[Obligation]:
    p, _ = roller("1")
    across = SPIN.cross(p)
    return [equal(SPIN.dot(sphere.normal_matrix([p]) * SPIN), across.dot(across))]


def _determinants() -> Sequence[Obligation]:
    contacts = [roller(name)[0] for name in "123"]
    p, q, s = contacts
    one, two, three = p.dot(q), q.dot(s), s.dot(p)
    squares = one**2 + two**2 + three**2
    pair, triple = sphere.normal_matrix(contacts[:2]), sphere.normal_matrix(contacts)
    return [
        equal(pair.det(method="berkowitz"), 2 * (1 - one**2)),
        equal(triple.det(method="berkowitz"), 2 * (3 - squares) + 2 * (1 - one * two * three)),
    ]


# Two rollers


def _base_of_two(p: ImmutableMatrix, q: ImmutableMatrix) -> tuple[ImmutableMatrix, ...]:
    """The two-roller paper's X_1, X_2 and e, each times |p x q|, which spares a root."""
    normal = p.cross(q)
    return ImmutableMatrix(normal.cross(p)), ImmutableMatrix(normal.cross(q)), normal


def _closed_form() -> Sequence[Obligation]:
    """Normal equations times |p x q|, for contacts anywhere."""
    (p, _), (q, _) = roller("1"), roller("2")
    first, second, normal = _base_of_two(p, q)
    (mu, lam), (alpha, gamma) = SPEEDS, TILTS
    lifted = (mu * sin(alpha) + lam * sin(gamma)) / 2 * normal
    spin = (lam * cos(gamma) * p - mu * cos(alpha) * q - lifted) / RADIUS
    axes = [sphere.roller_axis(first, normal, alpha), sphere.roller_axis(second, normal, gamma)]
    feet = -(mu * axes[0] + lam * axes[1]) / RADIUS
    return same(sphere.normal_matrix([p, q]) * spin, feet)


def level_pair() -> tuple[list[ImmutableMatrix], list[ImmutableMatrix]]:
    """Two contacts on the equator, beta apart, with the angles of the two-roller paper.

    There its base {X_i, e} is that of the three-roller paper, {X_i, Y_i}: alpha_i = psi_i.
    """
    azimuths = (Integer(0), BETWEEN)
    contacts = [sphere.contact_direction(azimuth, 0) for azimuth in azimuths]
    bases = [sphere.tangent_base(azimuth, 0) for azimuth in azimuths]
    axes = [sphere.roller_axis(*base, tilt) for base, tilt in zip(bases, TILTS, strict=True)]
    return contacts, axes


def _heights() -> tuple[Expr, Expr]:
    """Heights of both lines over the plane of the contacts."""
    mu, lam = (-speed / RADIUS * sin(tilt) for speed, tilt in zip(SPEEDS, TILTS, strict=True))
    return mu, lam


def _midpoint() -> Sequence[Obligation]:
    """The spin lies half-way between two points, one on each line, one above the other."""
    contacts, axes = level_pair()
    spin = sphere.least_squares_spin(contacts, axes, SPEEDS, RADIUS)
    heights = _heights()
    ends = [spin + (height - sum(heights) / 2) * UP for height in heights]
    lines = [
        sphere.constraint_line(p, eta, speed, RADIUS)
        for p, eta, speed in zip(contacts, axes, SPEEDS, strict=True)
    ]
    on_lines = [
        vanish((end - foot).cross(direction))
        for end, (foot, direction) in zip(ends, lines, strict=True)
    ]
    return joined(*on_lines, same((ends[0] + ends[1]) / 2, spin))


def _opposite_slips() -> Sequence[Obligation]:
    contacts, axes = level_pair()
    spin = sphere.least_squares_spin(contacts, axes, SPEEDS, RADIUS)
    first, second = _heights()
    half = RADIUS * (second - first) / 2
    checks = []
    for sign, azimuth, p, eta, speed in zip(
        (1, -1), (0, BETWEEN), contacts, axes, SPEEDS, strict=True
    ):
        east, _ = sphere.tangent_base(azimuth, 0)
        slip = sphere.slip_velocity(spin, p, eta, speed, RADIUS)
        checks.append(same(slip, sign * half * east))
    return joined(*checks)


def _bearings() -> Sequence[Obligation]:
    """X_1 of the two-roller paper in the base of the three-roller paper, times sin(beta)."""
    (p, _), (q, _) = roller("1"), roller("2")
    first, second, normal = _base_of_two(p, q)
    checks = []
    for own, other, sign, tangent in ((p, q, 1, first), (q, p, -1, second)):
        names = "12" if own is p else "21"
        (a, b), (c, d) = (symbols(f"a_{name} b_{name}", real=True) for name in names)
        east, north = sphere.tangent_base(a, b)
        along_east = cos(d) * sin(c - a)
        along_north = cos(b) * sin(d) - sin(b) * cos(d) * cos(c - a)
        checks.append(same(tangent, sign * (along_east * east + along_north * north)))
        checks.append([equal(along_east**2 + along_north**2, 1 - own.dot(other) ** 2)])
        checks.append([equal(normal.dot(normal), 1 - own.dot(other) ** 2)])
    return joined(*checks)


# When nothing slips


def _components_of_slip() -> Sequence[Obligation]:
    (p, eta), speed = roller("1"), SPEEDS[0]
    driven = sphere.driven_direction(p, eta)
    slip = sphere.slip_velocity(SPIN, p, eta, speed, RADIUS)
    return [
        equal(slip.dot(eta), RADIUS * SPIN.dot(driven)),
        equal(slip.dot(driven), -RADIUS * SPIN.dot(eta) - speed),
        equal(slip.dot(p), Integer(0)),
    ]


def _only_along_the_contact() -> Sequence[Obligation]:
    p, eta = roller("1")
    driven = sphere.driven_direction(p, eta)
    parts = SPIN.dot(eta) ** 2 + SPIN.dot(driven) ** 2 + SPIN.dot(p) ** 2
    return [equal(SPIN.dot(SPIN), parts)]


def _driven_pair() -> tuple[list[ImmutableMatrix], ImmutableMatrix]:
    contacts, axes = level_pair()
    driven = [sphere.driven_direction(p, eta) for p, eta in zip(contacts, axes, strict=True)]
    return axes, ImmutableMatrix(driven[0].cross(driven[1]))


def _parallel_pair() -> Sequence[Obligation]:
    contacts, _ = level_pair()
    _, across = _driven_pair()
    alpha, gamma = TILTS
    in_plane = -sin(alpha) * cos(gamma) * contacts[0] + cos(alpha) * sin(gamma) * contacts[1]
    return same(across, sin(alpha) * sin(gamma) * sin(BETWEEN) * UP + in_plane)


def _free_inputs_of_a_pair() -> Sequence[Obligation]:
    axes, across = _driven_pair()
    found = [eta.dot(across) for eta in axes]
    return [
        equal(speed, sin(tilt) * sin(BETWEEN))
        for speed, tilt in zip(found, reversed(TILTS), strict=True)
    ]


def _positive_between() -> Sequence[Obligation]:
    return [Obligation(Form.POSITIVE, Family(sin(BETWEEN), {BETWEEN: (Integer(0), pi)}))]


THEOREMS = (
    Theorem(
        "thm:one-best-spin",
        "One best spin for any number of rollers",
        r"For $N$ rollers with contacts $\mathbf{p}_i$ (unit vectors) the sum of the squared "
        r"distances of a spin $\boldsymbol\omega$ to the lines $l_i$ is a quadratic function with "
        r"the matrix $M = \sum_i (I - \mathbf{p}_i\mathbf{p}_i^T)$. It has a minimum for all axes "
        r"and speeds, at the solution of $M\boldsymbol\omega = -\frac1r\sum_i\nu_i"
        r"\boldsymbol\eta_i$, and this is the only one unless all contacts lie on one line through "
        r"the centre; then any spin about that line may be added. For two contacts $\det M = "
        r"2\sin^2\beta$, $\beta$ being the angle between them; for three, with the cosines $c_k$ "
        r"of the angles between them, $\det M$ is the sum of $2(3 - c_1^2 - c_2^2 - c_3^2)$ and "
        r"$2(1 - c_1c_2c_3)$.",
        (TWO, THREE),
        (
            Step(
                "The squared distance to one line, about any spin: slope and matrix. Those of "
                "$N$ lines add up, and where the slope is zero, the matrix remains.",
                _one_square,
            ),
            Step(
                r"The matrix of one roller gives $|\mathbf{x}\times\mathbf{p}|^2$. A sum of such "
                r"squares is zero only for $\mathbf{x}$ parallel to all contacts. There the right "
                r"side has no part along $\mathbf{x}$, since axes are perpendicular to contacts.",
                _sum_of_squares,
            ),
            Step("The determinants for two and for three contacts.", _determinants),
        ),
    ),
    Theorem(
        "thm:two-rollers",
        "Two rollers are the case N = 2",
        r"The spin of the two-roller paper, the midpoint of the common perpendicular of two lines, "
        r"is the least-squares spin of the three-roller paper for $N = 2$. The angles of the two "
        r"papers differ by a bearing: $\alpha_i = \psi_i - \delta_i$, where $\delta_1$ is the "
        r"direction at $P_1$ of the great circle that leads to $P_2$, counter-clockwise from east "
        r"($X_1$ of the three-roller paper), and $\delta_2$ that of the same circle at $P_2$. "
        r"The components $S_i$ of the slips are equal and opposite: $S_1 = -S_2$ is half of "
        r"$\nu_1\sin\alpha_1 - \nu_2\sin\alpha_2$.",
        (TWO, THREE),
        (
            Step(
                r"$\boldsymbol\omega_t = (\nu_2\cos\alpha_2\,\mathbf{p}_1 - \nu_1\cos\alpha_1\,"
                r"\mathbf{p}_2)/(r\sin\beta)$ and $\boldsymbol\omega_s = -(\nu_1\sin\alpha_1 + "
                r"\nu_2\sin\alpha_2)\,\mathbf{e}/(2r)$ add up to the solution of the normal "
                r"equations, wherever the contacts are.",
                _closed_form,
            ),
            Step(
                "In axes with both contacts on the equator: the points of both lines that stand "
                "one above the other have it as their midpoint.",
                _midpoint,
            ),
            Step(
                r"$\sin\beta\,X_1$ of the two-roller paper has in the other paper's base the "
                r"components $\cos\theta_{2,2}\sin(\theta_{1,2} - \theta_{1,1})$ and "
                r"$\cos\theta_{2,1}\sin\theta_{2,2} - \sin\theta_{2,1}\cos\theta_{2,2}"
                r"\cos(\theta_{1,2} - \theta_{1,1})$; for $X_2$, change indices and sign.",
                _bearings,
            ),
            Step("The slips at both contacts.", _opposite_slips),
        ),
    ),
    Theorem(
        "thm:no-slip",
        "When nothing slips: for all inputs, for some, for none",
        r"Let the contacts not all lie on one line through the centre. The sphere can turn without "
        r"any slip by exactly the spins that are perpendicular to all driven directions "
        r"$\mathbf{e}_i$; the rollers then have the speeds $\nu_i = "
        r"-r\langle\boldsymbol\eta_i, \boldsymbol\omega\rangle$. So the inputs without slip are a "
        r"space of dimension $3 - \operatorname{rank}(\mathbf{e}_1, \ldots, \mathbf{e}_N)$. "
        r"*For all inputs:* of two rollers if and only if "
        r"$\alpha_1$ and $\alpha_2$ are $0°$ (or $180°$); of three or more never. *For some:* two "
        r"rollers with other angles, exactly where $\nu_1\sin\alpha_1 = \nu_2\sin\alpha_2$; "
        r"three, where $\det(\mathbf{e}_1, \mathbf{e}_2, \mathbf{e}_3) = 0$. *For none* but rest: "
        r"all other arrangements of three rollers.",
        (TWO, THREE),
        (
            Step(
                "Slip along the axis, along the driven direction, and across the surface.",
                _components_of_slip,
            ),
            Step(
                "No two spins without slip have the same speeds: their difference would be "
                "perpendicular to all axes and driven directions, and so parallel to all contacts.",
                _only_along_the_contact,
            ),
            Step(
                r"Two rollers: $\mathbf{e}_1\times\mathbf{e}_2$ has the components $\sin\alpha_1"
                r"\sin\alpha_2\sin\beta$ along $\mathbf{e}$, $-\sin\alpha_1\cos\alpha_2$ along "
                r"$\mathbf{p}_1$ and $\cos\alpha_1\sin\alpha_2$ along $\mathbf{p}_2$: all are zero "
                r"only if both sines are.",
                _parallel_pair,
            ),
            Step(
                r"Else the spins are parallel to $\mathbf{e}_1\times\mathbf{e}_2$, and the speeds "
                r"are as $\sin\alpha_2$ to $\sin\alpha_1$.",
                _free_inputs_of_a_pair,
            ),
            Step(r"$\sin\beta$ is positive for two contacts apart.", _positive_between),
        ),
    ),
)
