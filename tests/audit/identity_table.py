"""Identities of textbooks and the misprints one makes of them, each with its source.

A&S: Abramowitz and Stegun, Handbook of Mathematical Functions, chapter 4.3 (circular functions).
`expected` is what a mathematician says, not what the engine said: "true" (wherever both sides are
defined), "false", or "branch" (true only where something has a sign).
"""

from dataclasses import dataclass, field

import sympy as sp
from sympy import Abs, Rational, cos, cot, csc, pi, sec, sin, sqrt, tan

from omniproof.decide.in_sympy.domain import Domain

x, y, z = sp.symbols("x y z", real=True)
a, b, c = sp.symbols("a b c", positive=True)
n = sp.Symbol("n", positive=True)
a1, a2, a3 = sp.symbols("alpha_1:4", real=True)


@dataclass(frozen=True)
class Row:
    name: str
    source: str
    left: sp.Expr
    right: sp.Expr
    expected: str = "true"
    domain: Domain = field(default_factory=Domain)


def product(factor, values):
    return sp.Mul(*(factor(k) for k in values), evaluate=False)


def fourth_root_square():
    return 2 + 2 * sqrt(2) * a ** Rational(1, 4) + sqrt(a)


GAUSS_17 = (
    -1
    + sqrt(17)
    + sqrt(34 - 2 * sqrt(17))
    + 2 * sqrt(17 + 3 * sqrt(17) - sqrt(34 - 2 * sqrt(17)) - 2 * sqrt(34 + 2 * sqrt(17)))
)
WHEELS = sp.Matrix([[-sin(k), cos(k), 1] for k in (a1, a2, a3)]).det()
COS_GAMMA = (a**2 + b**2 - c**2) / (2 * a * b)
HERON = (a + b + c) * (-a + b + c) * (a - b + c) * (a + b - c)
UNIT = sp.Matrix([sin(x) * cos(y), sin(x) * sin(y), cos(x)])
TURN = sp.Matrix([[cos(z), -sin(z), 0], [sin(z), cos(z), 0], [0, 0, 1]])
HALF_TURN = Domain({"x": (-pi / 2, pi / 2)})
SIDES = (a, b, sqrt(a**2 + b**2 - 2 * a * b * cos(x)))
HALF = sp.Add(*SIDES) / 2
IN_TRIANGLE = Domain({"x": (0, pi)})
RADIUS = sqrt(x**2 + y**2)

TRUE = (
    Row("pythagoras", "A&S 4.3.10", sin(x) ** 2 + cos(x) ** 2, sp.S.One),
    Row("secant", "A&S 4.3.11", sec(x) ** 2 - tan(x) ** 2, sp.S.One),
    Row("cosecant", "A&S 4.3.12", csc(x) ** 2 - cot(x) ** 2, sp.S.One),
    Row("sine-of-sum", "A&S 4.3.16", sin(x + y), sin(x) * cos(y) + cos(x) * sin(y)),
    Row("cosine-of-sum", "A&S 4.3.17", cos(x + y), cos(x) * cos(y) - sin(x) * sin(y)),
    Row("tangent-of-sum", "A&S 4.3.18", tan(x + y), (tan(x) + tan(y)) / (1 - tan(x) * tan(y))),
    Row("cotangent-of-sum", "A&S 4.3.19", cot(x + y), (cot(x) * cot(y) - 1) / (cot(y) + cot(x))),
    Row("half-sine", "A&S 4.3.20", Abs(sin(x / 2)), sqrt((1 - cos(x)) / 2)),
    Row("half-cosine", "A&S 4.3.21", Abs(cos(x / 2)), sqrt((1 + cos(x)) / 2)),
    Row("half-tangent", "A&S 4.3.22", tan(x / 2), (1 - cos(x)) / sin(x)),
    Row("half-tangent-root", "A&S 4.3.22", Abs(tan(x / 2)), sqrt((1 - cos(x)) / (1 + cos(x)))),
    Row("universal-sine", "A&S 4.3.23", sin(x), 2 * tan(x / 2) / (1 + tan(x / 2) ** 2)),
    Row("double-sine", "A&S 4.3.24", sin(2 * x), 2 * tan(x) / (1 + tan(x) ** 2)),
    Row("double-cosine", "A&S 4.3.25", cos(2 * x), (1 - tan(x) ** 2) / (1 + tan(x) ** 2)),
    Row("double-tangent", "A&S 4.3.26", tan(2 * x), 2 / (cot(x) - tan(x))),
    Row("triple-sine", "A&S 4.3.27", sin(3 * x), 3 * sin(x) - 4 * sin(x) ** 3),
    Row("triple-cosine", "A&S 4.3.28", cos(3 * x), 4 * cos(x) ** 3 - 3 * cos(x)),
    Row("fourfold-sine", "A&S 4.3.29", sin(4 * x), (8 * cos(x) ** 3 - 4 * cos(x)) * sin(x)),
    Row("fourfold-cosine", "A&S 4.3.30", cos(4 * x), 8 * cos(x) ** 4 - 8 * cos(x) ** 2 + 1),
    Row("product-of-sines", "A&S 4.3.31", 2 * sin(x) * sin(y), cos(x - y) - cos(x + y)),
    Row("product-of-cosines", "A&S 4.3.32", 2 * cos(x) * cos(y), cos(x - y) + cos(x + y)),
    Row("sum-of-sines", "A&S 4.3.34", sin(x) + sin(y), 2 * sin((x + y) / 2) * cos((x - y) / 2)),
    Row(
        "difference-of-cosines",
        "A&S 4.3.37",
        cos(x) - cos(y),
        -2 * sin((x + y) / 2) * sin((x - y) / 2),
    ),
    Row("sum-of-tangents", "A&S 4.3.38", tan(x) + tan(y), sin(x + y) / (cos(x) * cos(y))),
    Row("squares-of-sines", "A&S 4.3.40", sin(x) ** 2 - sin(y) ** 2, sin(x + y) * sin(x - y)),
    Row("squares-mixed", "A&S 4.3.42", cos(x) ** 2 - sin(y) ** 2, cos(x + y) * cos(x - y)),
    Row(
        "morrie",
        "Beyer, Elem. Math. 1975",
        product(lambda k: cos(k * pi / 9), (1, 2, 4)),
        Rational(1, 8),
    ),
    Row(
        "morrie-free",
        "Beyer, Elem. Math. 1975",
        8 * sin(x) * product(lambda k: cos(k * x), (1, 2, 4)),
        sin(8 * x),
    ),
    Row(
        "triple-product",
        "Hobson, Plane Trigonometry VII",
        4 * product(lambda k: sin(x + k * pi / 3), (0, 1, 2)),
        sin(3 * x),
    ),
    Row("pentagon", "Euclid XIII.9", cos(pi / 5), (1 + sqrt(5)) / 4),
    Row(
        "pentagon-sine",
        "Hobson, Plane Trigonometry V",
        sin(x + pi / 5),
        sin(x) * (1 + sqrt(5)) / 4 + cos(x) * sqrt(10 - 2 * sqrt(5)) / 4,
    ),
    Row(
        "heptagon-sum",
        "Hardy and Wright 5.8",
        cos(2 * pi / 7) + cos(4 * pi / 7) + cos(6 * pi / 7),
        -Rational(1, 2),
    ),
    Row(
        "heptagon-product",
        "Hobson, Plane Trigonometry VII",
        product(lambda k: sin(k * pi / 7), (1, 2, 3)),
        sqrt(7) / 8,
    ),
    Row(
        "root-of-eleven",
        "Bromwich, Infinite Series 1926",
        tan(3 * pi / 11) + 4 * sin(2 * pi / 11),
        sqrt(11),
    ),
    Row("heptadecagon", "Gauss, Disquisitiones 365", 16 * cos(2 * pi / 17), GAUSS_17),
    Row(
        "three-primes",
        "root of a product",
        sqrt(21) * cos(pi / 21),
        sqrt(3) * sqrt(7) * cos(pi / 21),
    ),
    Row("nested-root", "Euler, Algebra I.2.8", sqrt(5 + 2 * sqrt(6)), sqrt(2) + sqrt(3)),
    Row("viete", "Viete 1593", sqrt(2 + sqrt(2 + sqrt(2))), 2 * cos(pi / 16)),
    Row("ramanujan", "Ramanujan, Q. 1070", sqrt(4 + sqrt(15)), (sqrt(6) + sqrt(10)) / 2),
    Row(
        "triangle-tangents",
        "Hobson, Plane Trigonometry IV",
        tan(x) + tan(y) + tan(pi - x - y),
        tan(x) * tan(y) * tan(pi - x - y),
    ),
    Row(
        "dirichlet-kernel",
        "Zygmund, Trigonometric Series I",
        2 * sin(x / 2) * (1 + 2 * cos(x) + 2 * cos(2 * x)),
        2 * sin(5 * x / 2),
    ),
    Row("chebyshev", "A&S 22.3.15", cos(5 * x), 16 * cos(x) ** 5 - 20 * cos(x) ** 3 + 5 * cos(x)),
    Row(
        "wheels",
        "three wheels on a circle, by half differences",
        WHEELS,
        4 * sin((a2 - a1) / 2) * sin((a3 - a2) / 2) * sin((a3 - a1) / 2),
    ),
    Row("heron", "Heron, Metrica I.8", a * b * sqrt(1 - COS_GAMMA**2) / 2, sqrt(HERON) / 4),
    Row(
        "sophie-germain",
        "Dickson, History I",
        x**4 + 4 * y**4,
        (x**2 + 2 * y**2 + 2 * x * y) * (x**2 + 2 * y**2 - 2 * x * y),
    ),
    Row(
        "euler-lagrange",
        "Lagrange 1773",
        (a**2 + b**2) * (x**2 + y**2),
        (a * x + b * y) ** 2 + (a * y - b * x) ** 2,
    ),
    Row(
        "rotated-length",
        "Goldstein, Classical Mechanics 4.2",
        (TURN * UNIT).dot(TURN * UNIT),
        sp.S.One,
    ),
    Row(
        "angle-and-number",
        "a symbol inside and outside of a sine",
        x * sin(2 * x),
        2 * x * sin(x) * cos(x),
    ),
    Row("degrees", "a right angle is 90 degrees", sin(pi * (x + 90) / 180), cos(pi * x / 180)),
    Row("frequency", "angles that are products", sin(n * x) * cos(n * x), sin(2 * n * x) / 2),
    Row(
        "one-plus-sine",
        "Hobson, Plane Trigonometry IV",
        sqrt(1 + sin(x)),
        Abs(sin(x / 2) + cos(x / 2)),
    ),
    Row("phase", "one sinusoid", Abs(sqrt(3) * cos(x) + sin(x)), 2 * Abs(sin(x + pi / 3))),
    Row("denested", "Euler, Algebra I.2.8, with a symbol", sqrt(a + 1 + 2 * sqrt(a)), 1 + sqrt(a)),
    Row(
        "denested-two",
        "Euler, Algebra I.2.8, with two",
        sqrt(a + b + 2 * sqrt(a * b)),
        sqrt(a) + sqrt(b),
    ),
    Row(
        "fourth-root",
        "binomial formula",
        (sqrt(2) + a ** Rational(1, 4)) ** 2,
        fourth_root_square(),
    ),
    Row("abs-of-abs", "definition", Abs(Abs(sin(x)) * sin(y)), Abs(sin(x) * sin(y))),
    Row(
        "abs-of-number-field",
        "definition",
        Abs((x + sqrt(2)) * (y + sqrt(3))),
        Abs(x + sqrt(2)) * Abs(y + sqrt(3)),
    ),
    Row(
        "triangle-root",
        "law of cosines, right angle",
        sqrt(a**2 + b**2 - 2 * a * b * cos(pi / 2 + x)),
        sqrt((a + b) ** 2 - 2 * a * b * (1 - sin(x))),
    ),
    Row("abs-square", "definition", sqrt(x**2), Abs(x)),
    Row("abs-product", "definition", Abs(x) * Abs(y), Abs(x * y)),
    Row("product-of-roots", "both roots real", sqrt(x) * sqrt(y), sqrt(x * y)),
    Row("positive-root", "lengths are positive", sqrt(a**2 * b), a * sqrt(b)),
    Row(
        "conjugate-roots",
        "difference of squares",
        sqrt(1 - sqrt(a)) * sqrt(1 + sqrt(a)),
        sqrt(1 - a),
    ),
    Row(
        "inradius",
        "Todhunter, Plane Trigonometry XVI: area over half the perimeter",
        sqrt(product(lambda side: HALF - side, SIDES) / HALF),
        a * b * sin(x) / (2 * HALF),
        domain=IN_TRIANGLE,
    ),
    Row(
        "two-sides-are-roots",
        "Heron, Metrica I.8, expanded",
        sqrt(HERON.subs({a: sqrt(a), c: sqrt(c)})),
        sqrt(2 * b**2 * (a + c) + 2 * a * c - a**2 - b**4 - c**2),
    ),
    Row("leg", "Euclid I.47", sqrt(RADIUS - x) * sqrt(RADIUS + x), Abs(y)),
    Row("longer-than-a-leg", "Euclid I.19", Abs(RADIUS - x), RADIUS - x),
    Row("root-sine", "cosine on its half turn", sqrt(1 - sin(x) ** 2), cos(x), domain=HALF_TURN),
)

FALSE = (
    Row("pythagoras-sign", "misprint of A&S 4.3.10", sin(x) ** 2 - cos(x) ** 2, sp.S.One, "false"),
    Row(
        "sine-of-sum-sign",
        "misprint of A&S 4.3.16",
        sin(x + y),
        sin(x) * cos(y) - cos(x) * sin(y),
        "false",
    ),
    Row("double-sine-factor", "misprint of A&S 4.3.24", sin(2 * x), sin(x) * cos(x), "false"),
    Row(
        "triple-sine-swap",
        "misprint of A&S 4.3.27",
        sin(3 * x),
        4 * sin(x) - 3 * sin(x) ** 3,
        "false",
    ),
    Row(
        "half-sine-swap", "misprint of A&S 4.3.20", Abs(sin(x / 2)), sqrt((1 + cos(x)) / 2), "false"
    ),
    Row(
        "morrie-value",
        "misprint",
        product(lambda k: cos(k * pi / 9), (1, 2, 4)),
        Rational(1, 4),
        "false",
    ),
    Row(
        "heptagon-near",
        "misprint",
        product(lambda k: sin(k * pi / 7), (1, 2, 3)),
        sqrt(7) / 8 + Rational(1, 10**30),
        "false",
    ),
    Row(
        "nested-root-near",
        "misprint",
        sqrt(5 + 2 * sqrt(6)),
        sqrt(2) + sqrt(3) + Rational(1, 10**40),
        "false",
    ),
    Row(
        "wheels-sign",
        "misprint",
        WHEELS,
        -4 * sin((a2 - a1) / 2) * sin((a3 - a2) / 2) * sin((a3 - a1) / 2),
        "false",
    ),
    Row("heron-factor", "misprint", a * b * sqrt(1 - COS_GAMMA**2) / 2, sqrt(HERON) / 2, "false"),
    Row(
        "inradius-side",
        "misprint",
        sqrt(HALF * (HALF - SIDES[0]) * (HALF - SIDES[1]) / (HALF - SIDES[2])),
        a * b * sin(x) / (2 * HALF),
        "false",
        IN_TRIANGLE,
    ),
    Row(
        "conjugate-roots-sign",
        "misprint",
        sqrt(1 - sqrt(a)) * sqrt(1 + sqrt(a)),
        sqrt(1 + a),
        "false",
    ),
    Row("shorter-than-a-leg", "misprint", Abs(RADIUS - x), x - RADIUS, "false"),
    Row("index", "misprint", -sin(a1) + sin(a1), -sin(a1) + sin(a3), "false"),
    Row("never-equal", "a square root is not negative", sqrt(x**2 + 1), -sqrt(x**2 + 1), "false"),
    Row("small-angle", "an approximation is no identity", sin(x), x, "false"),
)

BRANCH = (
    Row("root-of-square", "sign of x", sqrt(x**2), x, "branch"),
    Row("root-of-cosine", "sign of the cosine", sqrt(1 - sin(x) ** 2), cos(x), "branch"),
    Row("half-sine-sign", "sign in A&S 4.3.20", sin(x / 2), sqrt((1 - cos(x)) / 2), "branch"),
    Row("one-plus-sine-sign", "sign of a sum", sqrt(1 + sin(x)), sin(x / 2) + cos(x / 2), "branch"),
    Row("volume", "an image volume is positive", 8 / WHEELS, 8 / Abs(WHEELS), "branch"),
    Row("two-signs", "both numbers", Abs(x) + Abs(y), x + y, "branch"),
    Row("product-sign", "equal signs", Abs(x) * Abs(y), x * y, "branch"),
    Row("sum-of-sizes", "triangle inequality, equality", Abs(x + a) + Abs(x - a), 2 * x, "branch"),
    Row(
        "half-angle-of-a-triangle",
        "Todhunter, Plane Trigonometry XIII, without its domain",
        sin(x / 2),
        sqrt((HALF - a) * (HALF - b) / (a * b)),
        "branch",
    ),
    Row("leg-sign", "Euclid I.47", sqrt((RADIUS - x) * (RADIUS + x)), y, "branch"),
    Row(
        "interval",
        "sign in an interval",
        sqrt(1 - sin(x) ** 2),
        cos(x),
        "branch",
        Domain({"x": (0, pi)}),
    ),
)

ROWS = TRUE + FALSE + BRANCH
