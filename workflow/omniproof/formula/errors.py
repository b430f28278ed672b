"""What is said where a formula asks for what cannot be done."""

from __future__ import annotations

import sys

sys.set_int_max_str_digits(0)  # what is read can also be written: Python's own limit is 4300
MAX_REASON = 300
"""So many characters of a reason are shown."""


class UnsupportedError(Exception):
    """An engine is asked for what it cannot do; public functions turn it into `Undecided`."""

    def __str__(self) -> str:
        """The reason, cut where it quotes a number of thousands of digits."""
        reason = super().__str__()
        return reason if len(reason) <= MAX_REASON else f"{reason[: MAX_REASON - 1]}…"


class WorkLimitError(UnsupportedError):
    """An engine would need more work than it is allowed."""
