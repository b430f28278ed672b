"""Judge a form on a subject: the one door from statements to engines.

The engine behind each form is imported when it is asked for: a paper without extrema does not pay
for branch and bound.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any

from sympy import Expr, Integer, latex

from omniproof.audit import ordering
from omniproof.audit.answer import REALS, Answer, Domain, Proved, Refuted, Undecided, Witness
from omniproof.audit.balls import UnsupportedError
from omniproof.audit.confirm import confirmed_equal
from omniproof.audit.hypotheses import closed_ends, sign_under, with_box, within
from omniproof.registry import Curve, Family, Obligation, Ordered
from omniproof.transcription.model import Form

ENGINES = {"flint": 0, "modular": 1, "z3": 2}
"""The order in which a row names the engines; others come after these."""

Closed = Mapping[Any, tuple[bool, bool]]
"""Whether lower and upper end belong to the range of a symbol."""
_SIGNS = {Form.NEGATIVE: -1, Form.POSITIVE: 1}
_WRONG = {Form.POSITIVE: "<=", Form.NEGATIVE: ">=", Form.INCREASING: "<=", Form.DECREASING: ">="}
"""What a value, or a difference of neighbours, is where the form does not hold."""
_EXTREMA = {Form.MINIMUM: "<=", Form.MAXIMUM: ">="}
_EXTREME = {Form.LARGEST: "<=", Form.SMALLEST: ">="}
"""What the difference from the best value is where something else is as good."""


def judge(obligation: Obligation, domain: Domain = REALS) -> Answer:
    """Decide whether the form holds for the subject; `Undecided` for a subject of the wrong type.

    Outside of the domain, nothing is asked. A condition between symbols that the form has no use
    for may be what makes it true: what is not proved without it is undecided.
    Raises nothing for any subject: a form that cannot be judged on it is undecided.
    """
    form, subject = obligation.form, obligation.subject
    if isinstance(subject, Sequence) and form is Form.EQUAL:
        return all_equal(tuple(subject), domain)
    try:
        if isinstance(subject, Curve | Family | Ordered) and domain != REALS:
            box = within(subject.box, domain)
            obligation = replace(obligation, subject=replace(subject, box=box))
    except UnsupportedError as reason:
        return Undecided(str(reason))
    answer = _judge_under(obligation, domain)
    return _confirmed(answer, obligation, domain)


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
    failures = tuple(_failures(obligation))
    if not failures:
        return answer
    from omniproof.audit.confirm_order import confirmed_order, decided_by_algebra
    from omniproof.audit.smt_order import Region

    ranges = getattr(obligation.subject, "box", {})
    unique = obligation.at if obligation.form in _EXTREMA else ()
    region = Region(ranges, closed_ends(ranges, domain), domain.conditions, unique)
    if is_open:
        return decided_by_algebra(failures, region) or answer
    return confirmed_order(answer, failures, region)


def _failures(obligation: Obligation) -> Iterator[tuple[Any, str]]:
    """Yield signs of formulas of which each alone, at one point, refutes a statement on order."""
    form, subject = obligation.form, obligation.subject
    match subject:
        case Family(expression=value):
            yield from _failures_of_family(form, value, obligation)
        case Ordered(terms=terms):
            yield from ((right - left, "<=") for left, right in pairwise(terms))
        case Mapping() if form in _EXTREME:
            best = subject[str(obligation.member)]
            others = (value for name, value in subject.items() if name != obligation.member)
            yield from ((best - other, _EXTREME[form]) for other in others)
        case Sequence() if form in _SIGNS:
            yield from ((value, _WRONG[form]) for value in subject)
        case Sequence() if form in _WRONG:
            yield from ((right - left, _WRONG[form]) for left, right in pairwise(subject))


def _failures_of_family(
    form: Form, value: Any, obligation: Obligation
) -> Iterator[tuple[Any, str]]:
    symbols = tuple(obligation.subject.box)
    if form in _EXTREMA:
        best = value.subs(dict(zip(symbols, obligation.at[0], strict=True)))
        yield value - best, _EXTREMA[form]
    elif form is Form.CONCAVE:
        yield value.diff(symbols[0], 2), ">"
    elif form in _SIGNS:
        yield value, _WRONG[form]


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
    from omniproof.audit import extrema

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
