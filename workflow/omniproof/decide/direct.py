r"""A voice in every verdict: the value of the printed tree itself, at points.

The engines are given what SymPy makes of a formula, and agree with each other about that. Direct
evaluation shares nothing with them but the reader (`digits`), so it finds what they have in common:
a simplification that is wrong, a witness where nothing is printed that has a value. It proves
nothing. What is proved has to hold at a few points of the domain, what is refuted to fail at the
witness, a condition to do both; a contradiction stops the run. A point counts only where every
printed part is defined: a witness elsewhere is replaced by one that counts, and where no point
counts, nothing is decided.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, TypeAlias

from mpmath import mp

from omniproof.decide.answer import (
    Answer,
    DisagreementError,
    OnBranch,
    Proved,
    Refuted,
    Undecided,
    Witness,
)
from omniproof.decide.digits import (
    DIGITS,
    NotEvaluatedError,
    UndefinedError,
    Value,
    are_equal,
    number,
    value,
)
from omniproof.decide.domain import Domain
from omniproof.decide.sampling import sample_points
from omniproof.decide.statement import Link
from omniproof.formula.errors import UnsupportedError
from omniproof.transcription import tree

POINTS = 3
"""A false statement that an engine proves is hardly true at three points by chance."""
IN_ORDER = 12
"""A false order holds in regions, and fails in others."""
TRIES, ALLOWED = 60, 12
"""So many points are looked at for them: arcsin x arcsin y is defined at one of nine. Where the
domain has conditions, most of its points are."""
SEED = 1
"""Other points than those at which the engines look."""
FURTHER = 4
"""So many times the digits tell what was lost on the way from what differs by little."""
MOST_DIGITS = 2_000
"""Numbers of more digits, such as 10^{9999}, would take seconds."""
NOWHERE = "no point of the domain was found at which every printed part is defined"


class Place(dict[str, Any]):
    """An exact number for each symbol, by name; what is evaluated there is evaluated once."""

    def __init__(self, numbers: Mapping[str, Any]) -> None:
        super().__init__(numbers)
        self.found: dict[tuple[Any, int], Value] = {}

    def once(self, key: object, evaluated: Callable[[], Value]) -> Value:
        """Return what is evaluated here, to the digits that are worked to, for a key."""
        if (key, mp.dps) not in self.found:
            self.found[key, mp.dps] = evaluated()
        return self.found[key, mp.dps]


Side: TypeAlias = Callable[[Place], Value]
Sides: TypeAlias = tuple[Side, str, Side]
"""Two sides to evaluate at a point, and the sign between them."""


@dataclass(frozen=True)
class Statement:
    """Links that hold together, wherever all their sides have values; `digits` they take."""

    links: tuple[Sides, ...]
    digits: int = DIGITS

    def holds(self, place: Place, expected: bool) -> bool:
        """Evaluate at a place; what is not as expected is believed with more digits only.

        Raises `UndefinedError` where a side has no value, `NotEvaluatedError` where that is open.
        """
        if self.digits > MOST_DIGITS:
            raise NotEvaluatedError(f"it takes more than {MOST_DIGITS} digits")
        with mp.workdps(self.digits):
            if self._holds(place) is expected:
                return expected
        with mp.workdps(FURTHER * self.digits):
            return self._holds(place)

    @property
    def points(self) -> int:
        """How many points are looked at for one where it fails."""
        return POINTS if all(sign == "=" for _, sign, _ in self.links) else IN_ORDER

    def _holds(self, place: Place) -> bool:
        found = [stands(link, place) for link in self.links]  # so that each has to have values
        return all(found)

    def shown(self, place: Place) -> tuple[str, str, str]:
        """Write both values of the first link that fails, or of the first, and the sign between.

        They have as many digits as tell them apart.
        """
        with mp.workdps(self.digits):
            failing = (link for link in self.links if not stands(link, place))
            left, operator, right = next(failing, self.links[0])
            values = left(place), right(place)
            pairs = ([_written(each, digits) for each in values] for digits in (4, 8, 16, 32))
            first, *others = pairs
            one, other = next((pair for pair in (first, *others) if pair[0] != pair[1]), first)
            return one, operator, other


def stands(link: Sides, place: Place) -> bool:
    """Whether two values are in order; equal are those that are not told apart."""
    left, right = link[0](place), link[2](place)
    if are_equal(left, right):
        return link[1] in {"=", "\\leq", "\\geq"}
    if link[1] in {"<", "\\leq"}:
        return bool(left < right)
    return bool(left > right) if link[1] in {">", "\\geq"} else link[1] == "\\neq"


def heard(answer: Answer, statement: Statement, places: Callable[[], Iterable[Place]]) -> Answer:
    """Ask direct evaluation about an answer; what has no point that counts is mended.

    `places` yields points of the domain, each with a number for every symbol of the statement.
    Raises `DisagreementError` where it contradicts.
    """
    try:
        match answer:
            case Proved():
                return _where_it_should_hold(answer, statement, places())
            case OnBranch(relations=relations):
                inside = (place for place in places() if _are_met(relations, place))
                _where_it_should_hold(answer, statement, inside)
                return _at_its_witness(answer, statement, places)
            case Refuted():
                return _at_its_witness(answer, statement, places)
    except (NotEvaluatedError, UnsupportedError):
        pass  # direct evaluation has nothing to say
    return answer


def _where_it_should_hold(answer: Answer, statement: Statement, places: Iterable[Place]) -> Answer:
    seen = 0
    for place in places:
        try:
            if not statement.holds(place, expected=True):
                raise _contradiction(answer, statement, place)
        except NotEvaluatedError:
            raise
        except UndefinedError:
            continue
        seen += 1
        if seen == statement.points:
            break
    return answer if seen else Undecided(NOWHERE, answer.engines)


def _at_its_witness(
    answer: Refuted | OnBranch, statement: Statement, places: Callable[[], Iterable[Place]]
) -> Answer:
    there = exact_place(answer.witness)
    if there is None:
        return answer
    for place in places():
        try:
            moved = Place({**place, **{name: there[name] for name in there.keys() & place.keys()}})
            if statement.holds(moved, expected=False):
                raise _contradiction(answer, statement, moved)
            return answer
        except NotEvaluatedError:
            raise
        except UndefinedError:
            if len(there) >= len(place):
                break
    return _with_another_witness(answer, statement, places())


def _with_another_witness(
    answer: Refuted | OnBranch, statement: Statement, places: Iterable[Place]
) -> Answer:
    reason = NOWHERE
    for place in places:
        try:
            if not statement.holds(place, expected=False):
                point = {name: str(x) for name, x in place.items()}
                witness = Witness(point, *statement.shown(place)[::2])
                return replace(answer, witness=witness)
            reason = "it was found to fail only where a printed part is not defined"
        except NotEvaluatedError:
            raise
        except UndefinedError:
            continue
    return Undecided(reason, answer.engines)


def _contradiction(answer: Answer, statement: Statement, place: Place) -> DisagreementError:
    left, operator, right = statement.shown(place)
    at = ", ".join(f"{name} = {x}" for name, x in place.items())
    where = f" at {at}" if at else ""
    engines = "+".join(answer.engines)
    told = f"left {operator} right with left = {left}, right = {right}"
    return DisagreementError(f"direct evaluation contradicts {engines} on {told}{where}: {answer}")


def exact_place(witness: Witness) -> dict[str, Any] | None:
    """Read the point of a witness; None where it is no point of numbers."""
    try:
        return {
            name: witness.exact[name] if name in witness.exact else Fraction(text)
            for name, text in witness.point.items()
        }
    except ValueError:
        return None


def _are_met(relations: Iterable[Any], place: Place) -> bool:
    from omniproof.decide.in_sympy.digits import is_met

    try:
        return all(is_met(relation, place) for relation in relations)
    except UndefinedError:
        return False


def is_true(node: tree.Node, side: Callable[[tree.Node], Side], place: Place) -> bool:
    """Whether a printed condition holds at a place; `side` gives what evaluates its sides."""
    match node:
        case tree.Comparison():
            return stands((side(node.left), node.operator, side(node.right)), place)
        case tree.Logic():
            parts = [is_true(part, side, place) for part in node.operands]
            return all(parts) if node.operator == "and" else any(parts)
    raise NotEvaluatedError(f"{type(node).__name__} is no condition")


def places(names: Iterable[str], domain: Domain) -> Iterator[Place]:
    """Yield points of a domain with a number for each name; always the same."""
    count = ALLOWED if domain.positive else TRIES
    for sample in sample_points(names, domain, count=count, seed=SEED):
        yield Place({name: Fraction(int(x.p), int(x.q)) for name, x in sample.items()})


def printed_side(
    node: tree.Node, known: Callable[[tree.Symbolic], Side], name: Callable[[str], str]
) -> Side:
    """Return what evaluates a printed side at a place, at each once.

    `known` gives what evaluates a symbol, and `name` what the symbol that an integral runs over is
    called in places.
    """
    own = object()

    def evaluated(place: Place) -> Value:
        def meaning(symbol: tree.Symbolic, bound: Mapping[str, Value]) -> Value:
            if symbol.name in bound:
                return bound[symbol.name]
            moved = {name(printed): x for printed, x in bound.items()}
            return known(symbol)(Place({**place, **moved}) if moved else place)

        return value(node, meaning)

    return lambda place: place.once(own, lambda: evaluated(place))


def entry_of(side: Side, index: tuple[int, int]) -> Side:
    """Return what evaluates an entry of a matrix; a number is its own."""

    def entry(place: Place) -> Value:
        found = side(place)
        return found[index] if isinstance(found, mp.matrix) else found

    return entry


def heard_on(answer: Answer, part: Link, names: Mapping[str, str], domain: Domain) -> Answer:
    """Ask direct evaluation about an answer on a link; `names` are those of printed symbols."""

    def known(symbol: tree.Symbolic) -> Side:
        return lambda place: number(place[names[symbol.name]])

    sides = (printed_side(side, known, names.__getitem__) for side in part.printed)
    left, right = (entry_of(side, part.index) for side in sides)
    statement = Statement(((left, part.operator, right),), max(map(_digits_of, part.printed)))
    return heard(answer, statement, lambda: places(names.values(), domain))


def _digits_of(node: tree.Node) -> int:
    """Return how many digits a formula takes: those of its numbers beside those that are lost."""
    return DIGITS + sum(_own_digits(part) for part in tree.walk(node))


def _own_digits(node: tree.Node) -> int:
    match node:
        case tree.Number(text=text):
            return len(text)
        case tree.Power(base=base, exponent=exponent) if not tree.names(base):
            return 2 * abs(exponent) * sum(_own_digits(part) for part in tree.walk(base))
    return 0


def _written(number: Value, digits: int) -> str:
    return str(mp.nstr(number, digits, strip_zeros=True)).removesuffix(".0")
