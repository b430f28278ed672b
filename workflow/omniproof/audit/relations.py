"""Judge a form on a subject: the one door from statements to engines.

The engine behind each form is imported when it is asked for: a paper without extrema does not pay
for branch and bound.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from sympy import Expr, Integer, latex

from omniproof.audit import ordering
from omniproof.audit.answer import REALS, Answer, Domain, Proved, Refuted, Undecided, Witness
from omniproof.audit.balls import UnsupportedError
from omniproof.audit.confirm import confirmed_equal
from omniproof.audit.hypotheses import sign_under, with_box, within
from omniproof.registry import Curve, Family, Obligation, Ordered
from omniproof.transcription.model import Form

ENGINES = {"flint": 0, "modular": 1, "z3": 2}
"""The order in which a row names the engines; others come after these."""

_SIGNS = {Form.NEGATIVE: -1, Form.POSITIVE: 1}


def judge(obligation: Obligation, domain: Domain = REALS) -> Answer:
    """Decide whether the form holds for the subject; `Undecided` for a subject of the wrong type.

    Outside of the domain, nothing is asked. A condition between symbols that the form has no use
    for may be what makes it true: what is not proved without it is undecided.
    Raises nothing for any subject: a form that cannot be judged on it is undecided.
    """
    form, subject = obligation.form, obligation.subject
    if isinstance(subject, Sequence) and form is Form.EQUAL:
        return all_equal(tuple(subject), domain)
    if domain == REALS:
        return _judge(obligation)
    try:
        if isinstance(subject, Curve | Family | Ordered):
            obligation = replace(
                obligation, subject=replace(subject, box=within(subject.box, domain))
            )
    except UnsupportedError as reason:
        return Undecided(str(reason))
    answer = _judge(obligation, domain)
    boxed = isinstance(subject, Family | Ordered) and domain.conditions
    if isinstance(answer, Proved | Undecided) or not boxed:
        return answer
    if isinstance(subject, Family) and form in _SIGNS:
        sign = sign_under(subject.expression, with_box(domain, subject.box))
        if sign == _SIGNS[form]:
            return Proved(("flint",))
    told = ", ".join(f"${latex(condition)}$" for condition in domain.conditions)
    return Undecided(f"it is not proved from {told}, and false without")


def _judge(obligation: Obligation, domain: Domain = REALS) -> Answer:
    form, subject = obligation.form, obligation.subject
    if isinstance(subject, Family):
        return _judge_family(form, subject, obligation.at)
    if isinstance(subject, Curve):
        return _judge_curve(form, subject, domain)
    if isinstance(subject, Ordered) and form is Form.CHAIN:
        return _chain(subject)
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


def _judge_family(form: Form, family: Family, at: tuple[tuple[Expr, ...], ...]) -> Answer:
    from omniproof.audit import extrema

    match form:
        case Form.MINIMUM | Form.MAXIMUM:
            return extrema.prove_extremum(family, at, form)
        case Form.POSITIVE | Form.NEGATIVE:
            return extrema.sign_on(family, _SIGNS[form])
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


def _chain(chain: Ordered) -> Answer:
    from omniproof.audit.chains import holds

    return holds(chain)


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
