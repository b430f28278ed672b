"""The command line: `omniproof audit FOLDER`.

Data goes to stdout, talk to stderr. Exit status: 0 the ledger could be computed, whatever it says;
2 bad input; 4 internal. Imports wait until a command is known, so that `--help` is quick.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

OK, BAD_INPUT, INTERNAL = 0, 2, 4


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit status."""
    options = _parser().parse_args(arguments)
    from omniproof.transcription.faults import BadInput

    try:
        return _audit(options.folder, options.json)
    except BadInput as error:
        print(error, file=sys.stderr)
        return BAD_INPUT
    except Exception as error:
        print(f"internal error, please report it: {type(error).__name__}: {error}", file=sys.stderr)
        return INTERNAL


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="omniproof", description=_DESCRIPTION)
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    audit = commands.add_parser("audit", help="audit one paper", description=_AUDIT)
    audit.add_argument("folder", type=Path, help="folder of the paper, such as paper_data/ballbot")
    audit.add_argument("--json", action="store_true", help="print the ledger as one JSON object")
    return parser


_DESCRIPTION = "Audit what papers on omnidirectional robots print against what mechanics implies."
_AUDIT = """Print the ledger of one paper: a line for every printed cell that a reader has to know
of, and the number of the others. Exit status 0 whatever the verdicts are, 2 for bad input."""


def _audit(folder: Path, as_json: bool) -> int:
    from omniproof.audit.run import audit_paper

    ledger = audit_paper(folder)
    if as_json:
        print(ledger.model_dump_json(indent=1))
        return OK
    from omniproof.report.terminal import ledger_text

    print(ledger_text(ledger))
    return OK


if __name__ == "__main__":
    sys.exit(main())
