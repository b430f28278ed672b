"""Whether a parametrised curve lies on a line, a circle or an ellipse, by exact elimination.

Two points fix a line, three a circle, five a conic; the points are taken at exact parameters. That
every other point of the curve lies there too is an identity in the parameter, which the zero test
decides. A curve that leaves the circle through three of its points lies on no circle at all, so
that one witness refutes. Curves in space are dealt with in the plane of three of their points, and
the conic in the affine coordinates of these points: Gram's matrix gives lengths back at the end.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, reduce
from itertools import combinations
from math import gcd
from typing import Any, TypeGuard

import sympy as sp

from omniproof.decide.answer import Answer, OnBranch, Proved, Refuted, Undecided
from omniproof.decide.answer import Witness as Point
from omniproof.decide.in_sympy.domain import REALS, Domain
from omniproof.decide.in_sympy.equality import confirmed_equal
from omniproof.decide.in_sympy.exact import sign
from omniproof.decide.order.hypotheses import sign_under
from omniproof.decide.order.signs import guarded
from omniproof.formula.errors import UnsupportedError, WorkLimitError
from omniproof.formula.sympy_terms import CIRCULAR_FUNCTIONS
from omniproof.registry import Curve

ENGINE = ("flint",)
UNIT_CIRCLE = [sp.Rational(k, 5) for k in (0, 3, -3, 4, -4)]  # sqrt(1 - t^2) is rational there
MOST_POINTS = 6
LONGEST = 600
STEPS = (1, 2, 3, 6, 4)  # denominators: few different roots
Vector = Any
"""A SymPy column of three."""


def is_line(curve: Curve, domain: Domain = REALS) -> Answer:
    """Decide whether a curve lies on one line; the note gives a point of it and its direction."""
    return guarded(lambda: _Track(curve, domain).line())


def is_circle(curve: Curve, domain: Domain = REALS) -> Answer:
    """Decide whether a curve lies on one circle; the note gives its centre and radius."""
    return guarded(lambda: _Track(curve, domain).circle())


def is_ellipse(curve: Curve, domain: Domain = REALS) -> Answer:
    """Decide whether a curve lies on one ellipse; the note gives its centre and semi-axes."""
    return guarded(lambda: _Track(curve, domain).ellipse())


@dataclass(frozen=True)
class _Frame:
    """The plane through three points of a curve: a point, two directions and their normal."""

    origin: Vector
    first: Vector
    second: Vector
    at: tuple[Any, ...]

    @cached_property
    def normal(self) -> Vector:
        return self.first.cross(self.second)

    def coordinates(self, point: Vector) -> tuple[Any, Any]:
        """Return s, r with point - origin = s first + r second, for a point of the plane."""
        offset, size = point - self.origin, self.normal.dot(self.normal)
        along = offset.cross(self.second).dot(self.normal) / size
        return along, self.first.cross(offset).dot(self.normal) / size

    def centre(self) -> Vector:
        """Return the centre of the circle through the three points."""
        a, b, n = self.first, self.second, self.normal
        return self.origin + (a.dot(a) * b - b.dot(b) * a).cross(n) / (2 * n.dot(n))


class _Track:
    """A curve in space (z = 0 for one in the plane), and where its parameter runs."""

    def __init__(self, curve: Curve, domain: Domain) -> None:
        if len(curve.box) != 1 or len(curve.coordinates) not in {2, 3}:
            raise UnsupportedError("a curve has one parameter and two or three coordinates")
        ((self.parameter, self.side),) = curve.box.items()
        self.place = sp.Matrix([*curve.coordinates, 0][:3])
        intervals = {**domain.intervals, self.parameter.name: self.side}
        self.domain = Domain(intervals, domain.conditions)

    def line(self) -> Answer:
        points = list(self.points())
        for (t0, start), (t1, end) in combinations(points, 2):
            along = end - start
            if all(self.vanishes(entry) for entry in along):
                continue
            answer = self.all_zero((self.place - start).cross(along), (t0, t1), "line")
            note = f"through {_shown(start)} along {_shown(along)}"
            return self.proper(answer, along.dot(along), note)
        return self.no_shape("a point", "a line", points)

    def circle(self) -> Answer:
        frame = self.frame()
        if isinstance(frame, Refuted):
            return frame
        plane = self.in_plane(frame)
        if not isinstance(plane, Proved):
            return plane
        centre = frame.centre()
        square = (frame.origin - centre).dot(frame.origin - centre)
        offset = self.place - centre
        answer = confirmed_equal(square, offset.dot(offset), self.domain)
        told = "squared distances from the centre of the circle"
        answer = self.told(answer, f"{told} through {self.named(frame.at)}")
        answer = _and_then(plane, answer)
        note = f"centre {_shown(centre)}, radius ${sp.latex(_root(square))}$"
        return self.proper(answer, frame.normal.dot(frame.normal), note)

    def ellipse(self) -> Answer:
        frame = self.frame()
        if isinstance(frame, Refuted):
            return frame
        plane = self.in_plane(frame)
        if not isinstance(plane, Proved):
            return plane
        conic = self.conic(frame)
        answer = self.told(
            confirmed_equal(0, _conic_at(conic, *frame.coordinates(self.place)), self.domain),
            f"left side of the conic through five points, among them {self.named(frame.at)}",
        )
        if not isinstance(answer, Proved):
            return answer
        other = _other_conic(conic)
        if other is not None:
            return other
        answer = _and_then(plane, answer)
        return self.proper(answer, frame.normal.dot(frame.normal), _axes(frame, conic))

    def conic(self, frame: _Frame) -> tuple[Any, Any, Any]:
        """Return A, B, C of A s^2 + B s r + C r^2 = A s + C r, through two further points."""
        rows = []
        for value, point in self.points():
            if value not in frame.at:
                s, r = (_tidy(x) for x in frame.coordinates(point))
                rows.append(sp.Matrix([s**2 - s, s * r, r**2 - r]))
        for first, second in combinations(rows, 2):
            coefficients = first.cross(second).applyfunc(_tidy)
            if not all(self.vanishes(entry) for entry in coefficients):
                return tuple(coefficients)
        raise UnsupportedError("no five points of the curve that fix a conic were found")

    def frame(self) -> _Frame | Refuted:
        """Return three points that are not on one line; refuted where there are none."""
        points = list(self.points())
        for (t0, p0), (t1, p1), (t2, p2) in combinations(points, 3):
            frame = _Frame(p0, p1 - p0, p2 - p0, (t0, t1, t2))
            if not all(self.vanishes(entry) for entry in frame.normal):
                return frame
        line = self.line()
        if isinstance(line, Proved):
            return self.no_shape("on one line", "on no line", points)
        raise UnsupportedError("no three points of the curve that span a plane were found")

    def in_plane(self, frame: _Frame) -> Answer:
        offset = (self.place - frame.origin).dot(frame.normal)
        return self.told(
            confirmed_equal(0, offset, self.domain),
            f"distance from the plane through {self.named(frame.at)}, in some unit",
        )

    def all_zero(self, values: Vector, at: tuple[Any, ...], shape: str) -> Answer:
        answers: list[Answer] = []
        for value in values:
            answers.append(confirmed_equal(0, value, self.domain))
            if not isinstance(answers[-1], Proved):
                told = f"cross product with the {shape} through {self.named(at)}"
                return self.told(answers[-1], told)
        return reduce(_and_then, answers)

    def proper(self, answer: Answer, size: Any, note: str) -> Answer:
        """Add the note to a proof, and ask when the shape does not shrink to a segment or point."""
        if not isinstance(answer, Proved):
            return answer
        open_ = [f for f in sp.Mul.make_args(_tidy(size)) if not _bare(f).is_nonzero]
        open_ = [part for part in map(_bare, open_) if not self.is_nonzero(part)]
        if not open_:
            return Proved(answer.engines, note)
        if not all(part.is_Symbol for part in open_):
            return Undecided(f"it shrinks where {sp.prod(open_)} = 0, if that can be", ENGINE)
        condition = sp.Ne(sp.prod(open_), 0)
        witness = Point({part.name: "0" for part in open_[:1]}, "the shape", "shrunk")
        return OnBranch(answer.engines, sp.latex(condition), witness, note, (condition,))

    def is_nonzero(self, part: Any) -> bool:
        """Whether the domain keeps an expression from zero."""
        stated = sp.Ne(part, 0) in self.domain.conditions
        return stated or sign_under(part, self.domain) is not None

    def points(self) -> Iterator[tuple[Any, Vector]]:
        """Yield exact parameters inside the box, the plainest first, and the points there."""
        found: set[Vector] = set()
        for value in self.parameters():
            point = sp.ImmutableMatrix(self.place.subs(self.parameter, value))
            if point in found or point.has(sp.nan, sp.zoo, sp.oo, -sp.oo):
                continue
            yield value, point
            found.add(point)
            if len(found) == MOST_POINTS:
                return

    def parameters(self) -> Iterator[Any]:
        """Yield plain parameters: of an analytic curve, whose shape goes on, outside of the box."""
        bent = any(_is_bent(node) for node in sp.preorder_traversal(self.place))
        lower, upper = self.side if bent else (-sp.oo, sp.oo)
        unit = self.unit()
        for part in UNIT_CIRCLE if bent and unit == 1 else _fractions():
            if sp.And(lower < part * unit, part * unit < upper) == sp.true:
                yield part * unit
        if sp.sympify(upper - lower).is_finite:
            yield from (lower + (upper - lower) * sp.Rational(k, 12) for k in range(1, 12))

    def unit(self) -> Any:
        """Return the parameter of half a turn, 1 for a curve without angles."""
        for node in sp.preorder_traversal(self.place):
            if isinstance(node, CIRCULAR_FUNCTIONS) and node.has(self.parameter):
                rate = sp.diff(node.args[0], self.parameter)
                if not rate.has(self.parameter):
                    return sp.pi / rate
        return sp.S.One

    def vanishes(self, value: Any) -> bool:
        return isinstance(confirmed_equal(value, 0, self.domain, enough=1), Proved)

    def no_shape(self, found: str, wanted: str, points: list[tuple[Any, Vector]]) -> Refuted:
        at = [value for value, _ in points[:3]]
        shown = {f"{self.parameter.name}_{k}": str(value) for k, value in enumerate(at, 1)}
        return Refuted(ENGINE, Point(shown, wanted, found), f"it is {found}")

    def told(self, answer: Answer, what: str) -> Answer:
        """Say what the values of a witness are; a point off the shape refutes, on any branch."""
        if isinstance(answer, Refuted) or self.leaves(answer):
            return Refuted(answer.engines, answer.witness, f"compared: {what}")
        return answer

    def leaves(self, answer: Answer) -> TypeGuard[OnBranch]:
        """Whether a part of the curve, not of the constants, is off the shape."""
        if not isinstance(answer, OnBranch):
            return False
        return any(self.parameter in relation.free_symbols for relation in answer.relations)

    def named(self, values: tuple[Any, ...]) -> str:
        return f"${sp.latex(self.parameter)} = {', '.join(map(sp.latex, values))}$"


def _fractions() -> Iterator[Any]:
    """Yield fractions from -2 to 2, the plainest first."""
    for step in STEPS:
        for value in sorted(range(2 * step, -2 * step - 1, -1), key=abs):
            if gcd(value, step) == 1:
                yield sp.Rational(value, step)


def _conic_at(conic: tuple[Any, Any, Any], s: Any, r: Any) -> Any:
    a, b, c = conic
    return a * (s**2 - s) + b * s * r + c * (r**2 - r)


def _other_conic(conic: tuple[Any, Any, Any]) -> Answer | None:
    """Say what a conic is that is no ellipse, or may be none; `None` for an ellipse."""
    a, b, c = conic
    discriminant = _tidy(4 * a * c - b**2)
    known = _sign(discriminant)
    if known is None:
        return Undecided(f"the sign of the discriminant {discriminant} is not known", ENGINE)
    if known <= 0:
        seen = Point({}, "4AC - B^2 > 0", sp.sstr(discriminant))
        return Refuted(ENGINE, seen, "the conic through its points is no ellipse")
    return None


def _and_then(one: Answer, other: Answer) -> Answer:
    """Two steps of one proof: who has proved both is named; any other answer stays as it is."""
    if not (isinstance(one, Proved) and isinstance(other, Proved)):
        return other
    return Proved(tuple(name for name in one.engines if name in other.engines), other.note)


def _axes(frame: _Frame, conic: tuple[Any, Any, Any]) -> str:
    """Write centre and semi-axes p, q: p^2 and q^2 are the eigenvalues of Gram times M^-1."""
    a, b, c = conic
    discriminant = 4 * a * c - b**2
    s, r = (2 * a * c - b * c) / discriminant, (2 * a * c - a * b) / discriminant
    centre = frame.origin + s * frame.first + r * frame.second
    height = -_conic_at(conic, s, r)
    shape = sp.Matrix([[a, b / 2], [b / 2, c]]) / height
    gram = sp.Matrix([[u.dot(v) for v in (frame.first, frame.second)]
                      for u in (frame.first, frame.second)])  # fmt: skip
    squares = gram * shape.adjugate() / shape.det()
    product_of_both, both = 2 * _root(squares.det()), squares.trace()
    total, spread = _root(both + product_of_both), _root(both - product_of_both)
    spread = spread.args[0] if isinstance(spread, sp.Abs) else spread
    shown = ", ".join(f"${sp.latex(_tidy(sum_ / 2))}$" for sum_ in (total + spread, total - spread))
    return f"centre {_shown(centre)}, semi-axes {shown}"


def _is_bent(node: Any) -> bool:
    return isinstance(node, (sp.Abs, sp.sign)) or (isinstance(node, sp.Expr) and _is_root(node))


def _is_root(node: sp.Expr) -> bool:
    """Whether a node is an odd power of a square root, or of a root of such a root."""
    if not (node.is_Pow and node.exp.is_Rational):
        return False
    order = int(node.exp.q)
    return order > 1 and order & (order - 1) == 0


def _sign(value: Any) -> int | None:
    if not value.free_symbols:
        return sign(value)
    if value.is_positive:
        return 1
    return -1 if value.is_nonpositive else None


def _bare(factor: Any) -> Any:
    return factor.base if factor.is_Pow else factor


def _root(square: Any) -> Any:
    return sp.sqrtdenest(sp.sqrt(_tidy(square)))


def _tidy(value: Any) -> Any:
    """Write a value in a plain way; equality is never judged by this."""
    if value.count_ops() > (LONGEST if value.free_symbols else LONGEST // 4):
        raise WorkLimitError("the points of the curve that fix the shape have no short form")
    if not value.free_symbols:
        return sp.radsimp(sp.expand(value), max_terms=3)
    value = sp.factor(sp.radsimp(sp.cancel(sp.expand(value))))
    return sp.trigsimp(value) if value.has(*CIRCULAR_FUNCTIONS) else value


def _shown(point: Vector) -> str:
    entries = [_tidy(entry) for entry in point]
    shown = entries[:2] if entries[2] == 0 else entries
    return f"$({', '.join(map(sp.latex, shown))})$"
