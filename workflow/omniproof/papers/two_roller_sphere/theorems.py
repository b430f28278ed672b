"""What follows for the symmetric arrangement of the simulation and the paper does not print."""

from __future__ import annotations

from collections.abc import Sequence

from sympy import (
    Expr,
    ImmutableMatrix,
    Integer,
    MatrixBase,
    Rational,
    atan,
    cos,
    diff,
    pi,
    rad,
    sin,
    sqrt,
    symbols,
    tan,
)

from omniproof.kinematics.sphere import contact_direction
from omniproof.papers.two_roller_sphere import closed_forms, symmetric
from omniproof.papers.two_roller_sphere.arrangement import SPEED, spin_of
from omniproof.papers.two_roller_sphere.symbols import DIRECTION, RADIUS
from omniproof.papers.two_roller_sphere.symmetric import ANGLE, HALF, TILT
from omniproof.registry import Family, Obligation, Step, Theorem
from omniproof.transcription.model import Form

PAPER = ("two-roller-sphere",)
ROLLERS = (1, 2)
RIM_SPEEDS = symbols("nu_1 nu_2", real=True)
TURNED = sin(HALF) * tan(ANGLE)
"""tan(delta): how much the angle of the rollers turns the plane of spins."""


def _equal(*values: Expr) -> Obligation:
    return Obligation(Form.EQUAL, values)


def _same(first: MatrixBase, second: MatrixBase) -> list[Obligation]:
    return [_equal(*pair) for pair in zip(first, second, strict=True)]


# Closed forms


def _rolls_and_is_driven() -> Sequence[Obligation]:
    """The closed form of the spin is that of the rollers with the closed forms of the speeds."""
    driven = spin_of(symmetric.rollers(*(closed_forms.rim_speed(i) for i in ROLLERS)))
    return _same(symmetric.frame() * driven, closed_forms.spin())


def _closed_slips() -> Sequence[Obligation]:
    speeds = [closed_forms.rim_speed(i) for i in ROLLERS]
    spin, both = symmetric.frame().T * closed_forms.spin(), symmetric.rollers(*speeds)
    checks = []
    for i, roller in zip(ROLLERS, both, strict=True):
        slip = roller.slip(ImmutableMatrix(spin))
        checks += _same(slip, closed_forms.slip(i) * roller.tangent)
    return checks


def _one_solution() -> Sequence[Obligation]:
    """Determinant of the level part of the spin by the rim speeds."""
    driven = symmetric.frame() * spin_of(symmetric.rollers(*RIM_SPEEDS))
    determinant = driven[:2, :].jacobian(RIM_SPEEDS).det()
    sides = 2 * RADIUS**2 * sin(HALF) * cos(HALF)
    return [_equal(sides * determinant, cos(ANGLE) * closed_forms.UPRIGHT)]


def _level_part() -> Sequence[Obligation]:
    w_x, w_y, _ = closed_forms.spin()
    return [_equal(w_x**2 + w_y**2, (SPEED / RADIUS) ** 2)]


# The plane of spins


def _lean() -> Sequence[Obligation]:
    """The tangent of a sum of angles."""
    added = (tan(TILT) + TURNED) / (1 - tan(TILT) * TURNED)
    return [_equal(closed_forms.LEAN, added)]


def _ellipse() -> Sequence[Obligation]:
    """Half axes along x and along the line of greatest slope."""
    steepest = ImmutableMatrix([0, 1, -closed_forms.LEAN])
    flat = ImmutableMatrix([-1, 0, 0])
    path = SPEED / RADIUS * (flat * sin(DIRECTION) + steepest * cos(DIRECTION))
    return [*_same(closed_forms.spin(), path), _equal(steepest.dot(flat), Integer(0))]


def _grows() -> Sequence[Obligation]:
    """Slope of the tangent by the angle of the rollers: a square under a positive sine."""
    slope = sin(HALF) / closed_forms.UPRIGHT**2
    return [
        _equal(diff(closed_forms.LEAN, ANGLE), slope),
        Obligation(Form.POSITIVE, Family(sin(HALF), {HALF: (Integer(0), pi)})),
    ]


# Speeds and slips


def _slip_of_speeds() -> Sequence[Obligation]:
    first, second = (closed_forms.rim_speed(i) for i in ROLLERS)
    return [_equal(closed_forms.slip(1), sin(ANGLE) * (first + second) / 2)]


def _ahead() -> Sequence[Obligation]:
    along_y = {DIRECTION: pi / 2}
    slip, speed = (f(1).subs(along_y) for f in (closed_forms.slip, closed_forms.rim_speed))
    level = speed.subs(ANGLE, 0)
    return [_equal(slip, sin(ANGLE) * speed), _equal(cos(ANGLE) * speed, level)]


def _printed_speeds() -> Sequence[Obligation]:
    """Upper end of the interval of 1.03, carried to 0 degrees, against the lower end of 0.91's."""
    return [Obligation(Form.POSITIVE, (Rational(905, 1000) - Rational(1035, 1000) * cos(pi / 6),))]


# The upright plane

AZIMUTH, ELEVATION = symbols("a theta", real=True)
WIDTH = sqrt(cos(AZIMUTH) ** 2 + (sin(ELEVATION) * sin(AZIMUTH)) ** 2)
PLACED = {
    cos(HALF): WIDTH,
    sin(HALF): cos(ELEVATION) * sin(AZIMUTH),
    sin(TILT): sin(ELEVATION) / WIDTH,
    cos(TILT): cos(ELEVATION) * cos(AZIMUTH) / WIDTH,
}
"""Half angle and tilt for contacts at one elevation, `AZIMUTH` to either side of the y-axis."""

SINE, COSINE = cos(AZIMUTH) / WIDTH, sin(ELEVATION) * sin(AZIMUTH) / WIDTH
"""Sine and cosine of the singular angle."""


def _contacts() -> Sequence[Obligation]:
    """Contacts in the frame of their plane are those at the given azimuths and elevation."""
    checks = [_equal(PLACED[sin(HALF)] ** 2 + WIDTH**2, Integer(1))]
    for side, roller in zip((-1, 1), symmetric.rollers(*RIM_SPEEDS), strict=True):
        placed = (symmetric.frame() * roller.direction).subs(PLACED)
        checks += _same(placed, contact_direction(3 * pi / 2 + side * AZIMUTH, ELEVATION))
    return checks


def _upright() -> Sequence[Obligation]:
    """The divisor is cos(theta) times the sine of the singular angle less that of the rollers."""
    placed = closed_forms.UPRIGHT.subs(PLACED)
    return [
        _equal(SINE**2 + COSINE**2, Integer(1)),
        _equal(placed, cos(ELEVATION) * (SINE * cos(ANGLE) - COSINE * sin(ANGLE))),
        _equal(PLACED[sin(HALF)], cos(ELEVATION) * sin(AZIMUTH)),
    ]


def _pivots() -> Sequence[Obligation]:
    """Opposite speeds turn the sphere about an axis across x; its y-part is the divisor."""
    opposite = symmetric.rollers(Integer(1), Integer(-1))
    spin = RADIUS * sin(HALF) * symmetric.frame() * spin_of(opposite)
    return _same(spin, ImmutableMatrix([0, closed_forms.UPRIGHT, -closed_forms.LYING]))


def _in_the_simulation() -> Sequence[Obligation]:
    """Tangent of the singular angle for 55 and 60 degrees, by the printed contacts."""
    tangent = symmetric.in_simulation(cos(TILT) / (sin(TILT) * sin(HALF)))
    placed = {AZIMUTH: rad(55), ELEVATION: rad(60)}
    speed = symmetric.in_simulation(closed_forms.ASIDE, 3)
    return [
        _equal(tangent, (SINE / COSINE).subs(placed)),
        *_between(rad(Rational("38.955")), atan(tangent), rad(Rational("38.965"))),
        *_between(Rational("5.255"), speed, Rational("5.265")),
    ]


def _between(low: Expr, value: Expr, high: Expr) -> list[Obligation]:
    return [Obligation(Form.POSITIVE, (value - low, high - value))]


THEOREMS = (
    Theorem(
        "thm:symmetric-pair",
        "Two mirrored rollers: the whole motion in closed form",
        r"Let $2h$ be the angle between the contacts, $\tau$ the tilt of their plane, $\alpha_2 = "
        r"-\alpha_1$, and $\tan\delta = \sin h\tan\alpha_1$. The sphere travels along $\phi$ with "
        r"the speed $V$ if and only if $\nu_{1,2} = V(a\sin\phi \pm b\cos\phi)$, with "
        r"$a = \frac{\cos h}{\cos\alpha_1}$ and $b = \frac{\sin h\cos\delta}"
        r"{\cos\alpha_1\cos(\tau + \delta)}$. Then $\omega_x = -\frac{V}{r}\sin\phi$, "
        r"$\omega_y = \frac{V}{r}\cos\phi$, $\omega_z = -\frac{V}{r}\tan(\tau + \delta)\cos\phi$, "
        r"$\tan\rho = -\tan(\tau + \delta)\cos\phi$, and $S_{1,2} = "
        r"\pm V\cos h\tan\alpha_1\sin\phi$.",
        PAPER,
        (
            Step("The least-squares spin of these rim speeds.", _rolls_and_is_driven),
            Step("No other speeds will do: the determinant from speeds to travel.", _one_solution),
            Step(r"The level part of the spin has the size $V/r$, for $\rho$.", _level_part),
            Step("The slips; they have no part along $\\mathbf{e}$.", _closed_slips),
            Step(r"Without $\delta$: the tangent of a sum.", _lean),
        ),
    ),
    Theorem(
        "thm:leaning-plane",
        "The angle of the rollers turns the plane of spins",
        r"The end points of $\boldsymbol\omega$ run on an ellipse with the half axes "
        r"$V/r$, along $x$, and $V/(r\cos(\tau + \delta))$. Its plane contains the x-axis and "
        r"leans by $\tau + \delta$ from the ground: by the tilt $\tau$ of the contacts, and by "
        r"$\delta$ for the angle of the rollers. The lean grows with $\alpha_1$. Ellipses of "
        r"different $\alpha_1$ meet in $(\pm V/r, 0, 0)$ only, that is, for travel along $y$.",
        PAPER,
        (
            Step("The spin by two perpendicular half axes.", _ellipse),
            Step(r"Both parts of the lean.", _lean),
            Step(
                r"The derivative of $\tan(\tau + \delta)$ by $\alpha_1$ is $\sin h$ over a square.",
                _grows,
            ),
        ),
    ),
    Theorem(
        "thm:sine-of-slip",
        "Straight ahead, slip over rim speed is the sine of the roller angle",
        r"For all directions $S_1 = \frac12\sin\alpha_1(\nu_1 + \nu_2)$. For travel along $y$, "
        r"$|S_i| = |\nu_i|\sin\alpha_1$, and $|\nu_i|\cos\alpha_1$ is the same for all "
        r"$\alpha_1$, wherever the mirrored contacts are. So of the printed speeds 1.03 at 30° "
        r"cannot stand beside 0.91 at 0°: it would have to come from 0.90 or less.",
        PAPER,
        (
            Step("The slip by both rim speeds.", _slip_of_speeds),
            Step("Both relations at 90°.", _ahead),
            Step(r"$0.905 > 1.035\cos 30°$.", _printed_speeds),
        ),
    ),
    Theorem(
        "thm:sideways",
        "An angle at which the rollers cannot push the sphere sideways",
        r"Let the contacts be at the elevation $\theta$ and at the azimuths $270° \mp a$. Travel "
        r"along $x$ needs the rim speeds $\nu_1 = -\nu_2 = V\sin a/\sin(\alpha^* - \alpha_1)$, "
        r"with $\tan\alpha^* = \cot a/\sin\theta$. They grow without bound towards $\alpha_1 = "
        r"\alpha^*$. There the plane of spins is upright, and rollers that run in opposite "
        r"directions turn the sphere about the vertical, on the spot. In the simulation "
        r"$\alpha^* = 38.96°$: at 30° the rollers already need 5.26 m/s for 1 m/s.",
        PAPER,
        (
            Step(r"$h$ and $\tau$ for these contacts.", _contacts),
            Step(
                r"The divisor of $\nu_1$ is $\cos\theta\sin(\alpha^* - \alpha_1)$, and $\sin h = "
                r"\cos\theta\sin a$.",
                _upright,
            ),
            Step("The spin of opposite speeds; its part along $y$ is that divisor.", _pivots),
            Step(r"$a = 55°$ and $\theta = 60°$ in the simulation.", _in_the_simulation),
        ),
    ),
)
