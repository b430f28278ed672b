r"""One statement, judged: what `omniproof check` answers.

Nothing here knows of a paper, a registry or pydantic, and an equation needs no SymPy: what only
some formulas need is imported when it is needed. The text is read by our own reader and never
evaluated as code.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import cache, partial
from itertools import pairwise
from typing import TYPE_CHECKING, assert_never

from omniproof.audit.definitions import Definitions, definitions
from omniproof.audit.setting import Assumptions, Setting, settle
from omniproof.audit.unclear import refuse_if_false, refuse_mixed_differences, refuse_unclear
from omniproof.decide.answer import Answer, OnBranch, Proved, Refuted, Undecided, Witness
from omniproof.decide.confirm import confirmed_equal
from omniproof.decide.direct import heard_on
from omniproof.decide.statement import Link, links
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.unfold import unfold
from omniproof.formula.writers import latex
from omniproof.transcription import tree
from omniproof.transcription.tokens import EXCERPT, MAX_LENGTH, LatexError

if TYPE_CHECKING:
    from omniproof.repair.kinds import Repair
    from omniproof.transcription.parses import Parse


class Finding(StrEnum):
    """Verdicts of a check."""

    VERIFIED = "verified"
    ERRATUM = "erratum"
    CONDITIONAL = "conditional"
    DEFINITION = "definition"
    UNDECIDED = "undecided"
    INVALID = "invalid"


@dataclass(frozen=True)
class CheckResult:
    """The verdict on one statement and what supports it.

    `printed` is the statement as given, `condition` LaTeX, `message` one or two sentences, or the
    fault of an invalid statement with its place. `repairs` are single edits that make a false one
    true, the likeliest first.
    """

    verdict: Finding
    printed: str
    witness: Witness | None = None
    condition: str = ""
    repairs: tuple[Repair, ...] = ()
    engines: tuple[str, ...] = ()
    message: str = ""


SHOWN = 3
"""So many further repairs are named."""
SEVERITY = (Refuted, Undecided, OnBranch, Proved)
"""Of several answers, the first kind of these is the answer on the whole statement."""


FAVOUR = (
    Finding.VERIFIED,
    Finding.DEFINITION,
    Finding.UNDECIDED,
    Finding.INVALID,
    Finding.CONDITIONAL,
    Finding.ERRATUM,
)
"""Of several readings, the one with the first of these verdicts counts."""
SHORT = {"c": "cos", "s": "sin"}
"""Letters that robotics writes for functions."""


def check(text: str, assumptions: Assumptions = Assumptions()) -> CheckResult:  # noqa: B008
    """Judge one statement in LaTeX; every symbol in it is a real number.

    It is false only if it is false in every reading that its print allows. Never raises for a text:
    what cannot be read is `invalid`, what cannot be decided `undecided`. Raises `DisagreementError`
    when engines contradict each other.
    """
    printed = text.strip()
    judge = partial(_judge, printed, assumptions)
    ways: tuple[Parse, ...] = ()

    def read_and_judge() -> CheckResult:
        nonlocal ways
        ways, complete = assumptions.parses(printed)
        first = judge(ways[0].node)
        return first if len(ways) == 1 else _in_favour(first, ways, complete, judge)

    result = _answered(printed, read_and_judge)
    if result.verdict is not Finding.ERRATUM:
        return result
    node = definitions(ways[0].node).rest or ways[0].node
    if (short := _short_functions(node)) and not assumptions.functions:
        other = check(text, replace(assumptions, functions=short))
        if other.verdict is Finding.VERIFIED:
            told = (f"`{letter}` as `\\{name}`" for letter, name in short.items())
            return replace(other, message=f"true if one reads {' and '.join(told)}")
    return _answered(printed, partial(_mended, result, node, assumptions))


def _answered(printed: str, work: Callable[[], CheckResult]) -> CheckResult:
    """Do the work; what it raises is an answer, too."""
    try:
        return work()
    except LatexError as error:
        return CheckResult(Finding.INVALID, _short(printed), message=error.alone)
    except UnsupportedError as reason:
        return CheckResult(Finding.UNDECIDED, printed, message=f"not decided: {reason}")
    except RecursionError:
        message = "not decided: the formula is nested too deeply"
        return CheckResult(Finding.UNDECIDED, printed, message=message)


def _judge(printed: str, assumptions: Assumptions, node: tree.Node) -> CheckResult:
    """Judge one reading of a statement."""

    def work() -> CheckResult:
        return _decided(printed, assumptions, node, settle(node, assumptions))

    return _answered(printed, work)


def _decided(
    printed: str,
    assumptions: Assumptions,
    node: tree.Node,
    setting: Setting,
    enough: int | None = 1,
) -> CheckResult:
    """Decide a statement; one confirmation is enough, since a refutation has its witness."""
    refuse_mixed_differences(node, printed)
    found = definitions(node)
    defined = ", ".join(f"`{latex(symbol)}`" for symbol in found.defined)
    if found.rest is None:
        message = f"a definition of {defined}: nothing to prove"
        return CheckResult(Finding.DEFINITION, printed, message=message)
    refuse_unclear(found.rest, printed, assumptions.functions)
    value = cache(partial(unfold, meanings=setting.letters, source=printed))
    steps = links(found.rest, value, printed)
    result = _result(printed, steps, [_decide(step, setting, enough) for step in steps])
    if result.verdict is Finding.ERRATUM and found.sought:
        sought = ", ".join(f"`{latex(symbol)}`" for symbol in found.sought)
        message = f"not decided: it defines {sought}, or is an equation for them"
        return CheckResult(Finding.UNDECIDED, printed, message=message)
    if not found.defined:
        return result
    if result.verdict is not Finding.VERIFIED and _uses(found):
        message = f"not decided: the definition of {defined} is not put in"
        return CheckResult(Finding.UNDECIDED, printed, message=message)
    return replace(result, message=f"{result.message}; a definition of {defined}")


def _uses(found: Definitions) -> bool:
    """Whether what is left to judge has a symbol that the statement defines."""
    return found.rest is not None and not tree.names(found.rest).isdisjoint(
        symbol.name for symbol in found.defined
    )


def _in_favour(
    first: CheckResult,
    ways: Sequence[Parse],
    complete: bool,
    judge: Callable[[tree.Node], CheckResult],
) -> CheckResult:
    """Judge the other readings, too; what one of them leaves open is not called false."""
    found = [(first, ways[0])]
    for way in ways[1:]:
        found.append((judge(way.node), way))
        if {Finding.VERIFIED} < {result.verdict for result, _ in found}:
            break
    best, way = min(found, key=lambda pair: FAVOUR.index(pair[0].verdict))
    if not complete and best.verdict in {Finding.CONDITIONAL, Finding.ERRATUM}:
        message = "not decided: there are too many ways to read arguments without brackets"
        return CheckResult(Finding.UNDECIDED, best.printed, message=message)
    if best.verdict is Finding.INVALID:
        return best
    if len({result.verdict for result, _ in found}) > 1:
        chosen = ", ".join(f"`{printed}` as `{read}`" for printed, read in way.chosen)
        return replace(best, message=f"{best.message}, if one reads {chosen}")
    if best.verdict is Finding.ERRATUM and len(found) > 1:
        return replace(best, message=f"{best.message}, in each of {len(found)} ways to read it")
    return best


def _short_functions(node: tree.Node) -> dict[str, str]:
    r"""The letters that stand before symbols as functions may: `c\theta`."""
    found = {
        first.name
        for item in tree.walk(node)
        if isinstance(item, tree.Product)
        for first, second in pairwise(item.factors)
        if isinstance(first, tree.Name) and isinstance(second, tree.Name)
    }
    return {letter: name for letter, name in SHORT.items() if letter in found}


def _mended(result: CheckResult, node: tree.Node, assumptions: Assumptions) -> CheckResult:
    """Add the repairs of a false statement; the further ones are named in the message."""
    refuse_if_false(node, result.printed)
    from omniproof.audit.remedies import remedies

    setting = settle(node, assumptions)

    def proved(text: str) -> tuple[str, ...]:
        """Name the engines that prove an edited statement: all are asked, as of a paper's."""

        def work() -> CheckResult:
            return _decided(text, assumptions, assumptions.read(text), setting, enough=None)

        found = _answered(text, work)
        return found.engines if found.verdict is Finding.VERIFIED else ()

    mended = remedies(result.printed, assumptions, setting, proved, result.witness)
    if mended is None:
        return result
    others = [f"`{edit.text}`" for edit in mended.repairs[1 : 1 + SHOWN]]
    left_out = len(mended.repairs) - 1 - len(others)
    more = [f"and {left_out} more"] if left_out > 0 else []
    single = mended.size == 1
    told = "" if single else "; the repair takes two edits"
    if others:
        size = "single edit" if single else "pair of edits"
        told += f"; another {size} gives {', '.join(others + more)}"
    return replace(result, repairs=mended.repairs, message=result.message + told)


def _decide(part: Link, setting: Setting, enough: int | None) -> Answer:
    """Decide one link, and hear direct evaluation about it."""
    if part.operator == "=":
        answer = confirmed_equal(part.left, part.right, setting.domain, enough=enough)
    else:
        from omniproof.audit.order import compare

        answer = compare(part.left, part.operator, part.right, setting.domain)
    return heard_on(answer, part, setting.names, setting.domain)


def _result(printed: str, steps: Sequence[Link], answers: Sequence[Answer]) -> CheckResult:
    """Join the answers on all links of a statement: the gravest one counts."""
    gravest = min((SEVERITY.index(type(answer)), k) for k, answer in enumerate(answers))[1]
    answer, place = answers[gravest], steps[gravest].place
    shared = set[str].intersection(*(set(each.engines) for each in answers))
    engines = tuple(name for name in answer.engines if name in shared)
    match answer:
        case Proved():
            message = _sentence("true wherever both sides are defined", "", answer.note)
            return CheckResult(Finding.VERIFIED, printed, engines=engines, message=message)
        case Refuted(engines=engines, witness=witness):
            message = _sentence("false", place, answer.note)
            return CheckResult(Finding.ERRATUM, printed, witness, engines=engines, message=message)
        case OnBranch(engines=engines, witness=witness):
            message = _sentence("true under a condition only", place, answer.note)
            branches = [each for each in answers if isinstance(each, OnBranch)]
            condition = " \\text{ and } ".join(dict.fromkeys(each.condition for each in branches))
            return CheckResult(
                Finding.CONDITIONAL, printed, witness, condition, engines=engines, message=message
            )
        case Undecided(reason=reason, engines=engines):
            message = _sentence("not decided", place, reason)
            return CheckResult(Finding.UNDECIDED, printed, engines=engines, message=message)
    assert_never(answer)


def _sentence(opening: str, place: str, note: str) -> str:
    return ": ".join(filter(None, [f"{opening} in {place}" if place else opening, note]))


def _short(text: str) -> str:
    """Cut what is too long to be a formula."""
    return text if len(text) <= MAX_LENGTH else f"{text[:EXCERPT]}…"
