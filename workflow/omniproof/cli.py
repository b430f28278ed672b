r"""The command line: `omniproof check 'LHS = RHS'`, `audit FOLDER`, `simulate MODEL CASE`.

Data goes to stdout, talk to stderr. Exit status of all: 2 bad input, 4 internal. A check: 0 true,
1 false, or true under a condition only, 3 not decided, or a definition. An audit: 0 the ledger
could be computed, whatever it says. A simulation: 0 done, 1 for a run that left physics behind.
Imports wait until a command is known, so that `--help` is quick.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Sequence
from errno import EISDIR, ENOTDIR
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from omniproof.door import CLOSED, Said, say
from omniproof.visible import one_line

if TYPE_CHECKING:
    from omniproof.audit.check import CheckResult

OK, FALSE, BAD_INPUT, UNDECIDED, INTERNAL = range(5)
INTERRUPTED = 130
"""Exit status after Ctrl-C, as shells have it."""
STATUS = {
    "verified": OK,
    "erratum": FALSE,
    "conditional": FALSE,
    "invalid": BAD_INPUT,
    "undecided": UNDECIDED,
    "definition": UNDECIDED,
}
LONGEST_INPUT = 4_000_000
"""So many bytes of stdin are looked at; a formula has far fewer."""
PATIENCE, LEAST, MOST = 10, 0.01, 86_400
"""Seconds of CPU time for a check: by default, at least (a tick of the clock), at most."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit status."""
    options = _parser().parse_args(arguments)
    try:
        said = _guarded(lambda: _COMMANDS[options.command](options))
    except KeyboardInterrupt:
        return INTERRUPTED
    return say(said, failed=BAD_INPUT)


def _guarded(command: Callable[[], Said]) -> Said:
    """Run a command; what it raises is told as bad input, or else as an error of ours."""
    from omniproof.transcription.faults import BadInput

    try:
        return command()
    except BadInput as error:
        return Said(BAD_INPUT, err=str(error))
    except OSError as error:
        return Said(BAD_INPUT, err=_of_system(error))
    except MemoryError:
        raise  # a child's: its parent tells what it may take
    except Exception as error:
        told = f"internal error, please report it: {type(error).__name__}: {error}"
        return Said(INTERNAL, err=told)


def _of_system(error: OSError) -> str:
    from omniproof.transcription.files import display_name, of_system

    if error.filename is None:
        return str(error)
    found, cure = of_system(error)
    name = display_name(Path(os.fsdecode(error.filename)))
    return f"{name}: expected a file, found {found}\n    {cure}"


class _Parser(argparse.ArgumentParser):
    """A parser whose messages are shown like all others: they repeat what was typed."""

    def error(self, message: str) -> NoReturn:
        usage = self.format_usage()
        said = Said(BAD_INPUT, err=f"{usage}{self.prog}: error: {one_line(message)}")
        raise SystemExit(say(said, failed=BAD_INPUT))


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(prog="omniproof", description=_DESCRIPTION)
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    _add_check(commands.add_parser("check", help="check one formula", description=_CHECK))
    audit = commands.add_parser("audit", help="audit one paper", description=_AUDIT)
    audit.add_argument(
        "folder", type=_folder, help="folder of the paper, such as paper_data/ballbot"
    )
    audit.add_argument("--json", action="store_true", help="print the ledger as one JSON object")
    _add_simulate(
        commands.add_parser(
            "simulate", help="run one case", description=_SIMULATE, epilog=_SIMULATE_EXAMPLE
        )
    )
    return parser


def _add_simulate(simulate: argparse.ArgumentParser) -> None:
    simulate.add_argument("model", nargs="?", help="such as omni-robot")
    simulate.add_argument("case", nargs="?", help="such as line-30-flying; without it, list them")
    simulate.add_argument("--list", action="store_true", help="list the cases, and run none")
    simulate.add_argument(
        "--summary", action="store_true", help="print what is read off the run, not its course"
    )
    simulate.add_argument(
        "--set",
        metavar="NAME=VALUE",
        action="append",
        default=[],
        help="change a parameter, such as friction=0.1; a wrong name lists the known ones",
    )
    simulate.add_argument(
        "--engine", metavar="NAME", help="let another physics engine run it: mujoco or drake"
    )
    simulate.add_argument("--output", metavar="FILE", type=Path, help="write there, not to stdout")


def _add_check(check: argparse.ArgumentParser) -> None:
    check.add_argument("formula", help="LaTeX, such as '|x| = x'; - reads it from stdin")
    check.add_argument("--json", action="store_true", help="print the result as one JSON object")
    check.add_argument(
        "--positive", metavar="SYMBOL", action="append", default=[], help="assume SYMBOL > 0"
    )
    check.add_argument(
        "--between",
        metavar="RANGE",
        action="append",
        default=[],
        help=r"assume a range, such as '0 < \theta < 90^\circ' (the ends do not belong to it)",
    )
    check.add_argument(
        "--function",
        metavar="LETTER=NAME",
        action="append",
        default=[],
        type=_shorthand,
        help=r"read a letter as a function: c=cos reads 'c \theta'",
    )
    check.add_argument(
        "--slash", choices=["first", "all"], help="what 1/3L divides by: 3, or all of 3L"
    )
    check.add_argument(
        "--limit",
        metavar="SECONDS",
        type=_seconds,
        default=PATIENCE,
        help=f"CPU time after which it is not decided (default {PATIENCE})",
    )


def _shorthand(text: str) -> tuple[str, str]:
    letter, equals, name = text.partition("=")
    if not (equals and len(letter) == 1 and letter.isalpha()):
        raise argparse.ArgumentTypeError(f"expected LETTER=NAME, such as c=cos, found {text!r}")
    return letter, name


def _folder(text: str) -> Path:
    if not text:
        raise argparse.ArgumentTypeError("expected the name of a folder, found nothing")
    return Path(text)


def _seconds(text: str) -> float:
    try:
        seconds = float(text)
    except ValueError:
        seconds = 0
    if not LEAST <= seconds <= MOST:
        message = f"expected seconds from {LEAST} to {MOST}, found {text!r}"
        raise argparse.ArgumentTypeError(message)
    return seconds


_DESCRIPTION = "Audit what papers on omnidirectional robots print against what mechanics implies."
_CHECK = """Decide whether a formula is true: an equation, a chain of them, an equation between
matrices, or an inequality. Every symbol is a real number; e and i are not read, nor derivatives,
and vectors and matrices only by their entries. A symbol that stands nowhere else is defined. False
is what is false in every way to read it. A formula that starts with a minus sign goes behind --.
Exit status 0 true, 1 false, or true under a condition only, 2 bad input, 3 not decided, or a
definition: nothing to prove, 4 internal."""
_AUDIT = """Print the ledger of one paper: a line for every printed cell that a reader has to know
of, and the number of the others. Exit status 0 whatever the verdicts are, 2 for bad input."""

_SIMULATE = """Run one case in a physics engine and print its course as CSV, in SI units. Without
a case, list what there is. Exit status 0 done, 1 for a run that left physics behind, 2 bad
input, or an engine that is not installed."""
_SIMULATE_EXAMPLE = """Such as: omniproof simulate omni-robot circle-left-flying --engine drake
--set friction=0.3 --summary"""


def _check(options: argparse.Namespace) -> Said:
    import json

    # Before the clock starts: what every formula takes.
    from omniproof.audit.check import CheckResult, Finding, check
    from omniproof.audit.setting import Assumptions
    from omniproof.limited import LimitError, limited

    said = Assumptions(
        tuple(map(_unicode, options.positive)),
        tuple(map(_unicode, options.between)),
        dict(options.function),
        options.slash,
    )
    formula = _formula(options.formula)

    def judged() -> str:
        return json.dumps(_guarded(lambda: _told(check(formula, said), options)))

    try:
        return Said(*json.loads(limited(judged, options.limit)))
    except LimitError as reason:
        message = f"not decided: {reason}; `--limit SECONDS` gives more time"
        return _told(CheckResult(Finding.UNDECIDED, formula.strip(), message=message), options)


def _told(result: CheckResult, options: argparse.Namespace) -> Said:
    from omniproof.report.check_text import COLOURS, check_json, check_text
    from omniproof.report.layout import terminal_width

    status = STATUS[result.verdict]
    if options.json:
        return Said(status, check_json(result), json=True)
    if status == BAD_INPUT:
        return Said(status, err=result.message)
    colour = COLOURS[result.verdict] if _wants_colour() else 0
    return Said(status, check_text(result, terminal_width()), colour=colour)


def _formula(argument: str) -> str:
    if argument != "-":
        return _unicode(argument)
    if sys.stdin is None:  # closed by the shell: `<&-`
        raise OSError(CLOSED.format("stdin"))
    return sys.stdin.buffer.read(LONGEST_INPUT).decode("utf-8", "replace")


def _unicode(text: str) -> str:
    """Put a character that no formula has for every byte that is no text."""
    return text.encode("utf-8", "surrogateescape").decode("utf-8", "replace")


def _wants_colour() -> bool:
    """Whether stdout is a terminal that may be coloured (https://no-color.org)."""
    plain = os.environ.get("NO_COLOR") or os.environ.get("TERM") == "dumb"
    return sys.stdout is not None and sys.stdout.isatty() and not plain


def _audit(options: argparse.Namespace) -> Said:
    from omniproof.audit.run import audit_paper

    ledger = audit_paper(options.folder)
    if options.json:
        return Said(OK, ledger.model_dump_json(indent=1), json=True)
    from omniproof.report.terminal import ledger_text

    return Said(OK, ledger_text(ledger))


def _simulate(options: argparse.Namespace) -> Said:
    from omniproof.simulation.command import listing, simulated
    from omniproof.simulation.engine import ImplausibleRunError
    from omniproof.simulation.engines import MissingEngineError
    from omniproof.simulation.names import UnknownNameError

    if options.output:
        _refuse_no_place_for(options.output)
    try:
        if options.list or options.case is None:
            text = listing(options.model)
        else:
            text = simulated(
                options.model,
                options.case,
                options.set,
                summary=options.summary,
                engine=options.engine,
            )
    except (UnknownNameError, MissingEngineError, ValueError) as error:
        return Said(BAD_INPUT, err=str(error))
    except ImplausibleRunError as error:
        return Said(FALSE, err=str(error))
    if options.output:
        try:
            options.output.write_text(f"{text.rstrip()}\n", encoding="utf-8")
        except OSError as error:  # a full disk names no file
            raise OSError(error.errno, error.strerror, str(options.output)) from None
        return Said(OK)
    return Said(OK, text.rstrip())


def _refuse_no_place_for(output: Path) -> None:
    """Raise `OSError` for what cannot become a file, before a run of minutes is lost on it."""
    number = EISDIR if output.is_dir() else 0 if output.parent.is_dir() else ENOTDIR
    if number:
        raise OSError(number, os.strerror(number), str(output))


_COMMANDS = {"check": _check, "audit": _audit, "simulate": _simulate}


if __name__ == "__main__":
    sys.exit(main())
