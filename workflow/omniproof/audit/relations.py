"""Judge a form on a subject: the one door from statements to engines.

The engine behind each form is imported when it is asked for: a paper without extrema does not pay
for branch and bound.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import pairwise
from typing import Any

from sympy import Expr, Integer, latex

from omniproof.decide import direct
from omniproof.decide.answer import Answer, Proved, Refuted, Undecided, Witness
from omniproof.decide.direct import Place, Statement
from omniproof.decide.in_sympy.digits import known_side, places_in
from omniproof.decide.in_sympy.domain import REALS, Domain
from omniproof.decide.in_sympy.equality import confirmed_equal
from omniproof.decide.order import ordering
from omniproof.decide.order.hypotheses import closed_ends, sign_under, with_box, within
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.sympy_terms import term_of
from omniproof.formula.value import Comparison
from omniproof.registry import Curve, Family, Obligation, Ordered
from omniproof.transcription.model import Form

ENGINES = {"flint": 0, "modular": 1, "z3": 2}
"""The order in which a row names the engines; others come after these."""

Closed = Mapping[Any, tuple[bool, bool]]
"""Whether lower and upper end belong to the range of a symbol."""
_SIGNS = {Form.NEGATIVE: -1, Form.POSITIVE: 1}
_ORDER = {Form.POSITIVE: ">", Form.NEGATIVE: "<", Form.INCREASING: ">", Form.DECREASING: "<"}
"""How a value stands to 0, or the next value to one."""
_EXTREMA = {Form.MINIMUM: ">", Form.MAXIMUM: "<"}
"""How all other values stand to the best."""
_EXTREME = {Form.LARGEST: ">", Form.SMALLEST: "<"}
"""How the best value stands to all others."""
_FAILS = {">": "\\leq", "<": "\\geq", "\\leq": ">", "=": "\\neq"}
"""How the sides stand where a link does not hold."""


def judge(obligation: Obligation, domain: Domain = REALS) -> Answer:
    """Decide whether the form holds for the subject; `Undecided` for a subject of the wrong type.

    Outside of the domain, nothing is asked. A condition between symbols that the form has no use
    for may be what makes it true: what is not proved without it is undecided.
    Raises nothing for any subject: a form that cannot be judged on it is undecided.
    Raises `DisagreementError` when engines, or direct evaluation, contradict each other.
    """
    form, subject = obligation.form, obligation.subject
    if isinstance(subject, Sequence) and form is Form.EQUAL:
        return _heard(all_equal(tuple(subject), domain), obligation, domain)
    try:
        if isinstance(subject, Curve | Family | Ordered) and domain != REALS:
            box = within(subject.box, domain)
            obligation = replace(obligation, subject=replace(subject, box=box))
    except UnsupportedError as reason:
        return Undecided(str(reason))
    answer = _confirmed(_judge_under(obligation, domain), obligation, domain)
    return _heard(answer, obligation, domain)


def _heard(answer: Answer, obligation: Obligation, domain: Domain) -> Answer:
    """Ask direct evaluation; what is false because a value is undefined stays so."""
    links = () if isinstance(answer, Undecided) else tuple(_links(obligation))
    if not links:
        return answer
    statement = Statement(tuple((known_side(a), sign, known_side(b)) for a, sign, b in links))
    symbols = {symbol for a, _, b in links for symbol in a.free_symbols | b.free_symbols}
    heard = direct.heard(answer, statement, partial(_places, symbols, obligation, domain))
    return heard if isinstance(answer, Proved) else answer


def _places(symbols: Iterable[Any], obligation: Obligation, domain: Domain) -> Iterator[Place]:
    """Yield points of the domain; the extreme value itself is no better than it is."""
    box = getattr(obligation.subject, "box", {})
    names = [symbol.name for symbol in box]
    extreme = [dict(zip(names, point, strict=True)) for point in obligation.at]
    for place in places_in(with_box(domain, box), {*symbols, *box}):
        if not any(point.items() <= place.items() for point in extreme):
            yield place


def _judge_under(obligation: Obligation, domain: Domain) -> Answer:
    """Judge on a box; what is false there may follow from a condition between symbols."""
    form, subject = obligation.form, obligation.subject
    answer = _judge(obligation, domain)
    boxed = isinstance(subject, Family | Ordered) and domain.conditions
    if isinstance(answer, Proved | Undecided) or not boxed:
        return answer
    if isinstance(subject, Family) and form in _SIGNS and not closed_ends(subject.box, domain):
        sign = sign_under(subject.expression, with_box(domain, subject.box))
        if sign == _SIGNS[form]:
            return Proved(("flint",))
    told = ", ".join(f"${latex(condition)}$" for condition in domain.conditions)
    return Undecided(f"it is not proved from {told}, and false without")


def _confirmed(answer: Answer, obligation: Obligation, domain: Domain) -> Answer:
    """Ask z3 for the point that would refute an order; what is open it may prove alone."""
    is_open = isinstance(answer, Undecided)
    on_box = isinstance(obligation.subject, Family | Ordered)
    if is_open and not (on_box and obligation.form in {*_SIGNS, Form.CHAIN}):
        return answer
    links = tuple(_links(obligation))
    if not links:
        return answer
    from omniproof.decide.order.confirm_order import confirmed_order, decided_by_algebra, region_of

    box = getattr(obligation.subject, "box", {})
    unique = obligation.at if obligation.form in _EXTREMA else ()
    sides = [side for left, _, right in links for side in (left, right)]
    try:
        failures = [
            Comparison(term_of(left), _FAILS[sign], term_of(right)) for left, sign, right in links
        ]
        region = region_of(box, closed_ends(box, domain), domain.conditions, sides, unique)
    except UnsupportedError:
        return answer
    if is_open:
        return decided_by_algebra(failures, region) or answer
    return confirmed_order(answer, failures, region)


def _links(obligation: Obligation) -> Iterator[tuple[Any, str, Any]]:
    """Yield values and the sign between them; all of these at all points are the statement."""
    form, subject, zero = obligation.form, obligation.subject, Integer(0)
    match subject:
        case Family():
            yield from _links_of_family(form, subject, obligation.at)
        case Ordered(terms=terms):
            yield from ((right, ">", left) for left, right in pairwise(terms))
        case Mapping() if form in _EXTREME:
            best = subject[str(obligation.member)]
            others = (value for name, value in subject.items() if name != obligation.member)
            yield from ((best, _EXTREME[form], other) for other in others)
        case Sequence() if form is Form.EQUAL:
            yield from ((subject[0], "=", value) for value in subject[1:])
        case Sequence() if form in _SIGNS:
            yield from ((value, _ORDER[form], zero) for value in subject)
        case Sequence() if form in _ORDER:
            yield from ((right, _ORDER[form], left) for left, right in pairwise(subject))


def _links_of_family(
    form: Form, family: Family, at: Sequence[tuple[Expr, ...]]
) -> Iterator[tuple[Any, str, Any]]:
    value, symbols = family.expression, tuple(family.box)
    if form in _EXTREMA:
        best = value.subs(dict(zip(symbols, at[0], strict=True)))
        yield value, _EXTREMA[form], best
    elif form is Form.CONCAVE:
        yield value.diff(symbols[0], 2), "\\leq", Integer(0)
    elif form in _SIGNS:
        yield value, _ORDER[form], Integer(0)


def _judge(obligation: Obligation, domain: Domain = REALS) -> Answer:
    form, subject = obligation.form, obligation.subject
    if isinstance(subject, Family):
        return _judge_family(obligation, subject, closed_ends(subject.box, domain))
    if isinstance(subject, Curve):
        return _judge_curve(form, subject, domain)
    if isinstance(subject, Ordered) and form is Form.CHAIN:
        return _chain(subject, closed_ends(subject.box, domain))
    if isinstance(subject, Mapping):
        return _judge_member(form, subject, str(obligation.member))
    if isinstance(subject, Sequence):
        return _judge_sequence(form, tuple(subject))
    return Undecided(f"the form {form} is not judged on a {type(subject).__name__}")


def all_equal(values: Sequence[Expr], domain: Domain = REALS) -> Answer:
    """Decide whether all expressions agree, wherever they are defined; one alone says nothing."""
    if len(values) < 2:
        return Undecided("one value is compared with nothing")
    engines: tuple[str, ...] = ()
    for value in values[1:]:
        answer = confirmed_equal(values[0], value, domain)
        if not isinstance(answer, Proved):
            return answer
        engines = merge(engines, answer.engines)
    return Proved(engines)


def merge(*groups: Sequence[str]) -> tuple[str, ...]:
    """Names of engines: flint, modular, z3, then others as they appear."""
    found = dict.fromkeys(name for group in groups for name in group)
    return tuple(sorted(found, key=lambda name: ENGINES.get(name, len(ENGINES))))


def _judge_family(obligation: Obligation, family: Family, closed: Closed) -> Answer:
    from omniproof.decide.order import extrema

    form = obligation.form
    match form:
        case Form.MINIMUM | Form.MAXIMUM:
            return extrema.prove_extremum(family, obligation.at, form, closed)
        case Form.POSITIVE | Form.NEGATIVE:
            return extrema.sign_on(family, _SIGNS[form], closed=closed)
        case Form.CONCAVE:
            return extrema.concave(family)
    return Undecided(f"the form {form} is not judged on a family")


def _judge_curve(form: Form, curve: Curve, domain: Domain) -> Answer:
    from omniproof.audit import shapes

    judges = {
        Form.LINE: shapes.is_line,
        Form.CIRCLE: shapes.is_circle,
        Form.ELLIPSE: shapes.is_ellipse,
    }
    if form not in judges:
        return Undecided(f"the form {form} is not judged on a curve")
    return judges[form](curve, domain)


def _chain(chain: Ordered, closed: Closed) -> Answer:
    from omniproof.audit.chains import holds

    return holds(chain, closed)


def _judge_member(form: Form, values: Mapping[str, Expr], member: str) -> Answer:
    if form not in {Form.LARGEST, Form.SMALLEST} or member not in values:
        return Undecided(f"the form {form} with the member {member} is not judged on {set(values)}")
    answer = ordering.is_extreme(values, member, 1 if form is Form.LARGEST else -1)
    if isinstance(answer, Refuted):
        shown = {name: ordering.digits(value) for name, value in values.items()}
        return Refuted(
            answer.engines, Witness(shown, answer.witness.printed, answer.witness.derived)
        )
    return answer


def _judge_sequence(form: Form, values: tuple[Expr, ...]) -> Answer:
    match form:
        case Form.EQUAL:
            return all_equal(values)
        case Form.POSITIVE | Form.NEGATIVE:
            return _same_sign(values, _SIGNS[form])
        case Form.INCREASING:
            return ordering.monotone(values, 1)
        case Form.DECREASING:
            return ordering.monotone(values, -1)
    return Undecided(f"the form {form} is not judged on a sequence")


def _same_sign(values: tuple[Expr, ...], wanted: int) -> Answer:
    try:
        wrong = [value for value in values if ordering.compare(value, Integer(0)) != wanted]
    except UnsupportedError as reason:
        return Undecided(str(reason), ("flint",))
    if not wrong:
        return Proved(("flint",))
    sign = "positive" if wanted > 0 else "negative"
    return Refuted(("flint",), Witness({}, sign, ordering.digits(wrong[0])))
