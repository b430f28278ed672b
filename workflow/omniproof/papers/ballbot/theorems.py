"""What follows for this paper's quantities and the paper does not print."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from sympy import (
    Expr,
    ImmutableMatrix,
    Integer,
    MatrixBase,
    Rational,
    Symbol,
    cos,
    diag,
    eye,
    pi,
    sin,
    sqrt,
    symbols,
    zeros,
)

from omniproof.kinematics import ballbot, frames, omni
from omniproof.papers.ballbot.laws import BALL_RADIUS, ISOTROPIC, at_rest, gram, rolling
from omniproof.papers.ballbot.symbols import PHI, RUNNING_RADIUS
from omniproof.registry import Family, Obligation, Step, Theorem
from omniproof.transcription.model import Form

PAPER = ("ballbot",)
AZIMUTH = Symbol("beta", real=True)
SCALE = RUNNING_RADIUS / BALL_RADIUS * cos(PHI)
LEVER = RUNNING_RADIUS * sin(PHI)
"""What stands before the velocity and before the yaw rate in the law of the rolling ball."""

EQUATOR = pi / 2
DETERMINANT = 3 * sqrt(3) / 2 * LEVER


def _equal(*values: Expr) -> Obligation:
    return Obligation(Form.EQUAL, values)


def _same(first: MatrixBase, second: MatrixBase) -> list[Obligation]:
    """Entry by entry."""
    return [_equal(*pair) for pair in zip(first, second, strict=True)]


def _expected_rows(azimuths: Iterable[Expr], scale: Expr) -> ImmutableMatrix:
    rows = [[-scale * sin(a), scale * cos(a), LEVER] for a in azimuths]
    return ImmutableMatrix(rows)


def _rolled() -> Sequence[Obligation]:
    v_x, v_y, spin = symbols("v_x v_y omega_b", real=True)
    ball = ballbot.ball_twist(v_x, v_y, spin, BALL_RADIUS)
    return _same(ball.rotation, ImmutableMatrix([-v_y / BALL_RADIUS, v_x / BALL_RADIUS, spin]))


def _rows_of_rolling_ball() -> Sequence[Obligation]:
    law = ballbot.wheel_law(PHI, RUNNING_RADIUS, BALL_RADIUS, azimuths=[AZIMUTH])
    expected = _expected_rows([AZIMUTH], SCALE).row_join(ImmutableMatrix([-LEVER]))
    return _same(law, expected)


def _planar_robot() -> Sequence[Obligation]:
    return _same(at_rest(), omni.wheel_matrix(ballbot.AZIMUTHS, LEVER))


def _columns_of_both() -> Sequence[Obligation]:
    return _same(rolling(), at_rest() * diag(SCALE, SCALE, 1))


def _difference() -> Sequence[Obligation]:
    """Both laws on (v_x, v_y, yaw rate, spin): the printed one takes no notice of the spin."""
    printed = at_rest().row_join(zeros(3, 1))
    right = ballbot.wheel_law(PHI, RUNNING_RADIUS, BALL_RADIUS)
    expected = at_rest() * diag(1 - SCALE, 1 - SCALE, 1)
    difference = printed - right
    return [
        *_same(difference[:, [0, 1, 3]], expected),
        *_same(difference[:, 2], zeros(3, 1)),
        _equal(expected.det(method="berkowitz"), DETERMINANT * (1 - SCALE) ** 2),
    ]


def _gap_is_positive() -> Sequence[Obligation]:
    ratio = Symbol("kappa", positive=True)
    below = {PHI: (Integer(0), pi)}
    return [
        _equal(1 - ratio * cos(PHI), (1 - ratio) + ratio * (1 - cos(PHI))),
        Obligation(Form.POSITIVE, Family(1 - cos(PHI), below)),
        Obligation(Form.POSITIVE, Family(1 - ratio, {ratio: (Integer(0), Integer(1))})),
    ]


def _predicted() -> Sequence[Obligation]:
    prediction = omni.twist_matrix(at_rest()) * rolling()
    return _same(prediction, diag(SCALE, SCALE, 1))


def _opposite_yaws() -> Sequence[Obligation]:
    law = ballbot.wheel_law(PHI, RUNNING_RADIUS, BALL_RADIUS)
    return _same(law[:, 2], -law[:, 3])


def _common_yaw() -> Sequence[Obligation]:
    law = ballbot.wheel_law(PHI, RUNNING_RADIUS, BALL_RADIUS)
    return _same(law * ImmutableMatrix([0, 0, 1, 1]), zeros(3, 1))


def _ball_turns_instead() -> Sequence[Obligation]:
    yaw = Symbol("omega", real=True)
    law = ballbot.wheel_law(PHI, RUNNING_RADIUS, BALL_RADIUS)
    return _same(law * ImmutableMatrix([0, 0, yaw, 0]), law * ImmutableMatrix([0, 0, 0, -yaw]))


def inverse_in_closed_form(scale: Expr) -> ImmutableMatrix:
    """Inverse of a law with `scale` before the velocity: thirds of the tangents and of ones."""
    columns = [[-2 * sin(a) / scale, 2 * cos(a) / scale, 1 / LEVER] for a in ballbot.AZIMUTHS]
    return ImmutableMatrix(columns).T / 3


def _printed_inverse() -> Sequence[Obligation]:
    return _same(inverse_in_closed_form(Integer(1)) * at_rest(), eye(3))


def _right_inverse() -> Sequence[Obligation]:
    return _same(inverse_in_closed_form(SCALE) * rolling(), eye(3))


def _determinants() -> Sequence[Obligation]:
    return [
        _equal(at_rest().det(method="berkowitz"), DETERMINANT),
        _equal(rolling().det(method="berkowitz"), DETERMINANT * SCALE**2),
    ]


def _grams() -> Sequence[Obligation]:
    """In the unknowns (v_x, v_y, rho times yaw rate)."""
    lever = 3 * (LEVER / BALL_RADIUS) ** 2
    half = Rational(3, 2)
    return [
        *_same(gram(at_rest(), BALL_RADIUS), diag(half, half, lever)),
        *_same(gram(rolling(), BALL_RADIUS), diag(half * SCALE**2, half * SCALE**2, lever)),
    ]


def _isotropic_angles() -> Sequence[Obligation]:
    thin = {RUNNING_RADIUS: BALL_RADIUS}
    printed = gram(at_rest(), BALL_RADIUS).subs(thin).subs(PHI, pi / 4)
    right = gram(rolling(), BALL_RADIUS).subs(PHI, ISOTROPIC)
    return [_equal(printed[0, 0], printed[2, 2]), _equal(right[0, 0], right[2, 2])]


def _perpendicular_axes() -> Sequence[Obligation]:
    """Turning axes of the ball under each wheel: position x driven direction."""
    contacts = [ballbot.contact_frame(a, ISOTROPIC, RUNNING_RADIUS) for a in ballbot.AZIMUTHS]
    levers = [frames.origin(c).cross(frames.axes(c)[:, 1]) for c in contacts]
    return [_equal(levers[i].dot(levers[j]), Integer(0)) for i, j in ((0, 1), (0, 2), (1, 2))]


def _largest_determinants() -> Sequence[Obligation]:
    """For L = rho = 1 m: other radii only put a positive factor before the determinants."""
    unit = {RUNNING_RADIUS: Integer(1), BALL_RADIUS: Integer(1)}
    right, printed = (law.det(method="berkowitz").subs(unit) for law in (rolling(), at_rest()))
    lower, whole = {PHI: (Integer(0), EQUATOR)}, {PHI: (Integer(0), pi)}
    return [
        Obligation(Form.MAXIMUM, Family(right, lower), at=((ISOTROPIC,),)),
        Obligation(Form.MAXIMUM, Family(printed, whole), at=((EQUATOR,),)),
    ]


def _at_the_equator() -> Sequence[Obligation]:
    law = rolling().subs(PHI, EQUATOR)
    return _same(law[:, :2], zeros(3, 2))


def _on_top() -> Sequence[Obligation]:
    above = rolling().subs(PHI, pi - PHI)
    return _same(above, rolling() * diag(-1, -1, 1))


def _any_frame() -> tuple[ImmutableMatrix, ImmutableMatrix]:
    """Shift of any small motion in a frame of any sixteen entries, and the columns n and a."""
    names = [f"{column}_{axis}" for axis in "xyz" for column in "noap"]
    last_row = ImmutableMatrix([[0, 0, 0, 1]])
    frame = ImmutableMatrix(3, 4, symbols(names, real=True)).col_join(last_row)
    turn = ImmutableMatrix(symbols("delta_x:z", real=True))
    shift = ImmutableMatrix(symbols("d_x:z", real=True))
    motion = frames.differential_motion(turn, shift)
    _, moved = frames.components(frames.change_frame(motion, frame))
    return moved, ImmutableMatrix.hstack(frame[:3, 0], frame[:3, 2])


def _driven_component() -> Sequence[Obligation]:
    moved, others = _any_frame()
    return [_equal(moved[1].diff(entry), Integer(0)) for entry in others]


def _third_component() -> Sequence[Obligation]:
    moved, others = _any_frame()
    d_x = Symbol("d_x", real=True)
    return [_equal(moved[2].diff(others[0, 1]).diff(d_x), Integer(1))]


THEOREMS = (
    Theorem(
        "thm:rolling-ball",
        "Wheel speeds inside a ball that rolls",
        r"A wheel at the azimuth $\beta_k$ and the zenith angle $\phi$ of the inner surface of "
        r"radius $L$, in a ball of radius $\rho$ that rolls without slip, has the speed"
        "\n\n"
        r"$$v_k = \frac{L}{\rho}\cos\phi\,\mathbf{e}_k\cdot\mathbf{v} "
        r"+ L\sin\phi\,(\omega_p - \omega_b),$$"
        "\n\n"
        r"where $\mathbf{e}_k = (-\sin\beta_k, \cos\beta_k)$ is its driven direction, $\mathbf{v}$ "
        r"the velocity of the centre, $\omega_p$ the yaw rate of the platform and $\omega_b$ the "
        r"spin of the ball. It is positive where the platform moves over the surface along "
        r"$\mathbf{e}_k$.",
        PAPER,
        (
            Step(
                r"No slip at the ground: the ball turns by $(-v_y, v_x)/\rho$ about level axes.",
                _rolled,
            ),
            Step("The platform over the moving surface, for any azimuth.", _rows_of_rolling_ball),
        ),
    ),
    Theorem(
        "thm:surface-at-rest",
        "The printed law is that of a ball held fast",
        r"The matrix of (10) is the wheel matrix of a planar robot with the body radius "
        r"$L\sin\phi$: the platform moves over a surface at rest. Inside a rolling ball, (10) "
        r"gives the wheel speeds of exactly those motions in which the ball stands still and only "
        r"the platform turns; for every other motion at least one of the three is wrong, whatever "
        r"$\phi$ in $(0, \pi)$ and $L \le \rho$.",
        PAPER,
        (
            Step("Entry by entry, the law over a surface at rest.", _planar_robot),
            Step(
                r"On $(v_x, v_y, \omega_b)$, printed minus right is the matrix of (10) with its "
                r"first two columns times $1 - \frac{L}{\rho}\cos\phi$; the yaw rate cancels.",
                _difference,
            ),
            Step(
                r"With $\kappa = L/\rho \le 1$, factor and determinant are positive.",
                _gap_is_positive,
            ),
        ),
    ),
    Theorem(
        "thm:speed-of-ball",
        "The direction is right, the speed is not",
        r"Fed with the wheel speeds of a rolling ball, the inverse in (10) returns "
        r"$\frac{L}{\rho}\cos\phi\,\mathbf{v}$ and $\omega_p - \omega_b$. The direction of travel "
        r"is right for wheels on the lower half and reversed for wheels on the upper half; the "
        r"ball moves $\rho/(L|\cos\phi|)$ times as fast as (10) says.",
        PAPER,
        (
            Step(
                "The columns of translation differ by one factor; the yaw column agrees.",
                _columns_of_both,
            ),
            Step("The printed inverse after the right law.", _predicted),
        ),
    ),
    Theorem(
        "thm:two-yaws",
        "The wheels feel one yaw rate, and there are two",
        r"Only the difference $\omega_p - \omega_b$ turns wheels. If platform and ball had one yaw "
        r"rate, no wheel would turn at all; and wheels that are all driven at one speed turn the "
        r"platform one way as well as the ball the other way. Which of the two turns is decided "
        r"by forces, friction on the ground and inertia, and not by kinematics. The yaw rate of "
        r"(10) is that of the platform where the ball does not spin.",
        PAPER,
        (
            Step("The column of the spin is minus that of the yaw rate.", _opposite_yaws),
            Step("A common yaw rate turns no wheel.", _common_yaw),
            Step("The ball turns instead of the platform.", _ball_turns_instead),
        ),
    ),
    Theorem(
        "thm:ballbot-inverse",
        "The inverse that (10) leaves to the reader",
        r"Both laws have the inverse $\mathbf{v} = \frac{2}{3c}\sum_k v_k\mathbf{e}_k$, "
        r"$\omega = \frac{1}{3L\sin\phi}\sum_k v_k$, with $c = 1$ in (10) and "
        r"$c = \frac{L}{\rho}\cos\phi$ for the rolling ball. The determinants are "
        r"$\frac{3\sqrt3}{2}L\sin\phi$ and "
        r"$\frac{3\sqrt3}{2}\frac{L^3}{\rho^2}\sin\phi\cos^2\phi$: (10) is singular at "
        r"$\phi = 0$ and $\pi$ only, the law of the rolling ball also at $\phi = \pi/2$, where "
        r"no wheel moves the ball.",
        PAPER,
        (
            Step("The inverse of (10), multiplied out.", _printed_inverse),
            Step("The inverse of the right law.", _right_inverse),
            Step("Both determinants.", _determinants),
            Step(r"At $\phi = \pi/2$ the columns of translation vanish.", _at_the_equator),
        ),
    ),
    Theorem(
        "thm:zenith-angle",
        "Where to put the wheels",
        r"On $(v_x, v_y, \rho\,\omega)$ the law of the rolling ball is isotropic at "
        r"$\tan\phi = 1/\sqrt2$, that is, $\phi = 35.26°$, whatever $L$ and $\rho$: there the "
        r"three axes about which the wheels turn the ball are perpendicular, and the determinant "
        r"is greatest. The printed law is isotropic at $\sin\phi = \rho/(\sqrt2 L)$ if "
        r"$L \ge \rho/\sqrt2$, which is 45° for a thin wall; its determinant is greatest at "
        r"$\phi = 90°$, the angle at which "
        r"the wheels cannot move the ball.",
        PAPER,
        (
            Step("Both matrices $A^T A$ are diagonal.", _grams),
            Step(r"Equal diagonals at 45° (for $L = \rho$) and at 35.26°.", _isotropic_angles),
            Step("The levers of the three wheels are perpendicular.", _perpendicular_axes),
            Step("The greatest determinants.", _largest_determinants),
        ),
    ),
    Theorem(
        "thm:on-top",
        "Wheels on top of the ball",
        r"A wheel at $\pi - \phi$ has the law of a wheel at $\phi$ with the sign of the velocity "
        r"changed. The robot on top of a ball (Fig. 1a) is therefore the same theory, with the "
        r"radius of the ball for $L$: wheels inside at $\phi$ and wheels on top at $\phi$ from the "
        r"upper pole drive the ball in opposite directions.",
        PAPER,
        (Step(r"The law at $\pi - \phi$.", _on_top),),
    ),
    Theorem(
        "thm:misprinted-columns",
        "Why the misprints of (5) do not reach the wheels",
        r"By (4-2) the driven component is $\bar{\mathbf{o}}\cdot(\bar\delta\times\bar{\mathbf{p}} "
        r"+ \bar{\mathbf{d}})$: it takes the second and the fourth column of a transform only. "
        r"A misprint in the columns $\bar{\mathbf{n}}$ or $\bar{\mathbf{a}}$ cannot reach "
        r"(7)–(10). One in the first entry of $\bar{\mathbf{a}}$ reaches the third component of "
        r"(6-2).",
        PAPER,
        (
            Step("The driven component has no derivative by those columns.", _driven_component),
            Step(r"The third component has the derivative $d_x$ by $a_x$.", _third_component),
        ),
    ),
)
