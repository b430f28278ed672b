"""Sign and concavity of a function over a box; with one variable, the exact set where it holds."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from itertools import compress, islice, pairwise, product
from typing import Any, TypeAlias

import sympy as sp

from omniproof.decide import exact
from omniproof.decide.answer import Answer, OnBranch, Proved, Refuted, Undecided, Witness
from omniproof.decide.balls import enclose, format_ball
from omniproof.decide.in_sympy.exact import sign, vanishes
from omniproof.decide.normal_form.form import normal_form
from omniproof.decide.order.box import Box, middle
from omniproof.decide.order.intervals import Piece, condition_latex, in_degrees, pieces_of
from omniproof.decide.order.positivity import Open, Positive, prove_positive
from omniproof.decide.order.quotient import Family, OnBox, Quotient
from omniproof.decide.order.sign_chart import Chart, recognise, sign_chart
from omniproof.formula.derivative import derivative
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.sympy_terms import term_of
from omniproof.formula.term import Power, Term, multiply, substitute, walk

ENGINE = ("flint",)
CLAIM = {1: "> 0", -1: "< 0"}
MOST_ZEROS = 4
FINEST_TURN = 24
"""Zeros inside of a box of several variables are looked for among multiples of pi/24 and below."""

Closed: TypeAlias = Mapping[sp.Symbol, tuple[bool, bool]]
"""Whether lower and upper end belong to the range of a symbol."""
OPEN: Closed = {}
Zero: TypeAlias = dict[sp.Symbol, Any]
"""Exact values of those symbols that a factor has."""


def sign_on(family: Family, wanted: int, *, zero: bool = False, closed: Closed = OPEN) -> Answer:
    """Decide whether a function is positive (1) or negative (-1) wherever it is defined.

    With `zero`, it may also vanish. Sides of the box are open, but for ends that are `closed`.
    With one variable, a sign that holds in parts is `OnBranch` with the exact set. Never raises for
    a family: what is not decided is `Undecided`.
    """
    if len(family.box) == 1:
        (ends,) = [closed.get(symbol, (False, False)) for symbol in family.box]
        return guarded(lambda: _sign_on_line(Quotient.of(family), wanted, zero, ends))
    inside = guarded(lambda: _sign_of(Quotient.of(family), wanted, zero))
    if isinstance(inside, Refuted | Undecided):
        return inside
    return guarded(lambda: not_on_faces(family, wanted, zero, closed) or inside)


def not_on_faces(family: Family, wanted: int, zero: bool, closed: Closed) -> Answer | None:
    """Return why a sign does not hold on a closed face of a box; None where it does on all.

    A corner is a face, too. Where a function is not defined on a face, nothing is asked.
    """
    printed = getattr(family, "printed", None) or term_of(family.expression)
    for at, rest in faces(family.box, closed):
        value = family.expression.subs(at)
        term = substitute(printed, {symbol.name: term_of(end) for symbol, end in at.items()})
        if value.has(sp.nan, sp.zoo, sp.oo, -sp.oo) or _divides_by_zero(term):
            continue
        if value.free_symbols:
            answer = sign_on(OnBox(value, rest, term), wanted, zero=zero)
        else:
            Quotient.of(OnBox(value, rest, term))  # proves that it is one number on all of the face
            answer = of_number(term_of(value), wanted, zero=zero)
        if not isinstance(answer, Proved):
            return on_face(answer, at if value.free_symbols else at | _somewhere(rest))
    return None


def _divides_by_zero(term: Term) -> bool:
    """Whether a printed denominator is 0 everywhere."""
    powers = (part for part in walk(term) if isinstance(part, Power) and part.exponent < 0)
    return any(_is_zero(power.base) for power in powers)


def _is_zero(term: Term) -> bool:
    try:
        return normal_form(term).is_zero
    except UnsupportedError:
        return False


def _somewhere(box: Mapping[sp.Symbol, tuple[Any, Any]]) -> dict[sp.Symbol, Any]:
    return dict(zip(box, _completed({}, Box.of(box)), strict=True)) if box else {}


def faces(
    box: Mapping[sp.Symbol, tuple[Any, Any]], closed: Closed
) -> Iterator[tuple[dict[sp.Symbol, Any], dict[sp.Symbol, tuple[Any, Any]]]]:
    """Yield the closed faces of a box: ends of some symbols, and the open sides of the others."""
    choices = [(None, *compress(box[symbol], closed.get(symbol, (False, False)))) for symbol in box]
    for chosen in islice(product(*choices), 1, None):
        at = {s: end for s, end in zip(box, chosen, strict=True) if end is not None}
        yield at, {symbol: side for symbol, side in box.items() if symbol not in at}


def on_face(answer: Answer, at: Mapping[sp.Symbol, Any]) -> Answer:
    """Name the whole point at which a statement fails on a face."""
    if not isinstance(answer, Refuted | OnBranch):
        return answer
    exact = {symbol.name: end for symbol, end in at.items()} | dict(answer.witness.exact)
    point = {name: str(end) for name, end in exact.items()} | dict(answer.witness.point)
    return Refuted(ENGINE, replace(answer.witness, point=point, exact=exact))


def of_number(value: Term, wanted: int, *, zero: bool = False) -> Answer:
    """Decide the sign of an exact number; raises `UnsupportedError` where it has none."""
    if _suits(exact.sign(value), wanted, zero):
        return Proved(ENGINE)
    return Refuted(ENGINE, Witness({}, CLAIM[wanted], format_ball(enclose(value), 6)))


def _suits(own: int, wanted: int, zero: bool) -> bool:
    return own == wanted or (zero and own == 0)


def concave(family: Family) -> Answer:
    """Decide whether a function of one variable is concave; `OnBranch` gives the exact set."""
    return guarded(lambda: _concave(family))


def guarded(question: Callable[[], Answer]) -> Answer:
    """Ask a question, and turn what an engine cannot do into `Undecided`."""
    try:
        return question()
    except UnsupportedError as reason:
        return Undecided(str(reason), ENGINE)
    except RecursionError:
        return Undecided("the formula is nested too deeply", ENGINE)


def denominator_sign(function: Quotient) -> int:
    """Return the sign of D wherever D is not zero; raises `UnsupportedError` when it changes."""
    if function.denominator.is_nonnegative:
        return 1
    sides = dict(zip(function.box.symbols, function.box.sides, strict=True))
    for candidate in (1, -1):
        if isinstance(sign_on(OnBox(function.denominator, sides), candidate), Proved):
            return candidate
    raise UnsupportedError("no constant sign of a denominator was proved")


def _sign_of(function: Quotient, wanted: int, zero: bool) -> Answer:
    wrong = function.find(function.term, -wanted)
    if wrong is not None:
        witness = function.witness(wrong, CLAIM[wanted], function.digits(wrong))
        return Refuted(ENGINE, witness)
    total = 1
    zeros: list[Zero] = []
    for factor in sp.Mul.make_args(function.numerator):
        sign_, own = _sign_of_factor(factor, function.box, zero)
        total, zeros = total * sign_, zeros + own
    for factor in sp.Mul.make_args(function.denominator):
        total *= _sign_of_factor(factor, function.box, True)[0]
    if total != wanted:
        return Undecided("its sign is the opposite one, but no point shows that", ENGINE)
    zeros = [own for own in zeros if len(own) < len(function.box.symbols)
             or not function.is_pole(tuple(own.values()))]  # fmt: skip
    return Proved(ENGINE) if zero or not zeros else _but_at(zeros, function, wanted)


def _sign_of_factor(factor: sp.Expr, box: Box, zero: bool) -> tuple[int, list[Zero]]:
    """Prove a sign, and find the points where the factor vanishes; in a line, only if it may."""
    if not factor.free_symbols:
        return sign(factor), []
    sides = zip(box.symbols, box.sides, strict=True)
    own = {symbol: side for symbol, side in sides if symbol in factor.free_symbols}
    for candidate in (1, -1):
        if len(own) == 1 and len(own) < len(box.symbols):
            if isinstance(sign_on(OnBox(factor, own), candidate, zero=zero), Proved):
                return candidate, []
            continue
        zeros = _zeros_of_positive(candidate * factor, Box.of(own))
        if zeros is not None:
            return candidate, [dict(zip(own, point, strict=True)) for point in zeros]
    raise UnsupportedError(f"no constant sign of {factor} was proved")


def _zeros_of_positive(function: sp.Expr, box: Box) -> list[tuple[Any, ...]] | None:
    """Return all zeros of a function that is positive at all other points; None if not proved.

    Where a proof gets stuck there may be a zero: one that is recognised and exact is named, and
    the proof is tried again.
    """
    zeros: list[tuple[Any, ...]] = []
    while len(zeros) <= MOST_ZEROS:
        match prove_positive(term_of(function), box, zeros):
            case Positive():
                return [zero for zero in zeros if box.contains(zero)]
            case Open(places=places) if found := _zero_near(function, box, places, zeros):
                zeros.append(found)
            case _:
                return None
    return None


def _zero_near(
    function: sp.Expr, box: Box, places: Iterable[tuple[float, ...]], known: list[tuple[Any, ...]]
) -> tuple[Any, ...] | None:
    closure = ((True, True),) * len(box.symbols)
    for place in places:
        for point in product(*(recognise(x, 1e-5, FINEST_TURN) for x in place)):
            exact = function.subs(dict(zip(box.symbols, point, strict=True)))
            if point not in known and box.contains(point, closure) and vanishes(exact):
                return point
    return None


def _completed(zero: Zero, box: Box) -> tuple[Any, ...]:
    """Give the other symbols of a box a value, too."""
    inside = box.rational_near(middle(box.unit_cell, box.enclosed_sides()))
    values = zip(box.symbols, inside or (), strict=True)
    return tuple(zero.get(symbol, sp.Rational(str(value))) for symbol, value in values)


def _but_at(zeros: list[Zero], function: Quotient, wanted: int) -> OnBranch:
    """Say that a sign holds everywhere but at these points."""
    point = _completed(zeros[0], function.box)
    if function.is_pole(point):
        raise UnsupportedError("it vanishes, but where it is defined was not found")
    asked = dict(zip(function.box.symbols, function.asked, strict=True))
    apart = [[sp.Ne(asked[s], value) for s, value in zero.items()] for zero in zeros]
    texts = [" \\text{ or } ".join(map(sp.latex, unequal)) for unequal in apart]
    condition = " \\text{ and } ".join(f"({text})" if len(texts) > 1 else text for text in texts)
    relations = tuple(sp.Or(*unequal) for unequal in apart)
    witness = function.witness(point, CLAIM[wanted], "0")
    return OnBranch(ENGINE, condition, witness, relations=relations)


def _sign_on_line(function: Quotient, wanted: int, zero: bool, closed: tuple[bool, bool]) -> Answer:
    chart = _chart(function)
    ends = [end for end in compress(function.box.sides[0], closed) if not function.is_pole((end,))]
    good = [end for end in ends if _suits(exact.sign(function.value_at((end,))), wanted, zero)]
    bad = [end for end in ends if end not in good]
    zeros = [point for point in chart.points[1:-1] if not function.is_pole((point,))]
    allowed, holes = (zeros, []) if zero else ([], zeros)
    wrong = _point_of_sign(function.box, chart, -wanted) or tuple([*holes, *bad][:1])
    if not wrong:
        return Proved(ENGINE)
    shown = "0" if wrong[0] in holes else function.digits(wrong)
    witness = function.witness(wrong, CLAIM[wanted], shown)
    pieces = _pieces_with_zeros(chart, wanted, allowed)
    return _on_pieces(function.asked[0], _with_ends(pieces, good), witness)


def _pieces_with_zeros(chart: Chart, wanted: int, allowed: list[Any]) -> tuple[Piece, ...]:
    """Return where the sign holds, or the value is one of the zeros that are `allowed`."""
    pieces = pieces_of(chart, wanted, lambda point: point in allowed)
    # A zero that the function only touches from the other side belongs to no piece.
    touched = [
        Piece(point, point, True, True)
        for point, around in zip(chart.points[1:-1], pairwise(chart.signs), strict=True)
        if point in allowed and wanted not in around
    ]
    return tuple(sorted((*pieces, *touched), key=lambda each: chart.points.index(each.lower)))


def _with_ends(pieces: tuple[Piece, ...], ends: list[Any]) -> tuple[Piece, ...]:
    """Add closed ends of the box to the pieces that reach them, or as points of their own."""
    reached = {end for piece in pieces for end in (piece.lower, piece.upper)}
    points = [Piece(end, end, True, True) for end in ends if end not in reached]
    grown = [
        replace(piece, lower_closed=piece.lower_closed or piece.lower in ends,
                upper_closed=piece.upper_closed or piece.upper in ends)
        for piece in pieces
    ]  # fmt: skip
    return tuple(sorted((*grown, *points), key=lambda piece: float(piece.lower)))


def _concave(family: Family) -> Answer:
    if len(family.box) != 1:
        return Undecided("concavity is decided for functions of one variable only", ENGINE)
    function = Quotient.of(family)
    (symbol,), (side,) = function.box.symbols, function.box.sides
    second = derivative(derivative(function.term, symbol.name), symbol.name)
    curvature = Quotient.of(OnBox(sp.diff(function.value, symbol, 2), {symbol: side}, second))
    if vanishes_identically(curvature.numerator):
        return Proved(ENGINE, "it is linear")
    chart = _chart(curvature)
    wrong = _point_of_sign(function.box, chart, 1)
    pieces = pieces_of(chart, -1, lambda point: not curvature.is_pole((point,)))
    if wrong is None and len(pieces) == 1:
        return Proved(ENGINE)
    point = wrong or (pieces[0].upper,)
    shown = curvature.digits(point) if wrong else "undefined"
    witness = function.witness(point, "second derivative <= 0", shown)
    return _on_pieces(function.asked[0], pieces, witness)


def vanishes_identically(expression: sp.Expr) -> bool:
    """Whether an expression without symbols is zero."""
    return not expression.free_symbols and vanishes(expression)


def _chart(function: Quotient) -> Chart:
    """Chart N D, which has the sign of N/D; N alone where D cannot be negative."""
    if function.denominator.is_nonnegative:
        return sign_chart(term_of(function.numerator), function.box)
    both = multiply(term_of(function.numerator), term_of(function.denominator))
    return sign_chart(both, function.box)


def _point_of_sign(box: Box, chart: Chart, wanted: int) -> tuple[Any, ...] | None:
    """Return a short rational point where the chart has a sign, None where there is none."""
    for piece in pieces_of(chart, wanted, lambda _: False):
        part = Box.of({box.symbols[0]: (piece.lower, piece.upper)})
        return part.rational_near(middle(part.unit_cell, part.enclosed_sides()))
    return None


def _on_pieces(symbol: sp.Symbol, pieces: tuple[Piece, ...], witness: Witness) -> Answer:
    if not pieces:
        return Refuted(ENGINE, witness)
    note = in_degrees(symbol, pieces)
    relation = sp.Or(*(piece.relation(symbol) for piece in pieces))
    return OnBranch(ENGINE, condition_latex(symbol, pieces), witness, note, (relation,))
