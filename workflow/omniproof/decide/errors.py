"""What an engine says when it is asked for what it cannot do."""

from __future__ import annotations


class UnsupportedError(Exception):
    """An engine is asked for what it cannot do; public functions turn it into `Undecided`."""


class WorkLimitError(UnsupportedError):
    """An engine would need more work than it is allowed."""
