"""What to say of a name that nothing has: what was expected, what was found, what is nearest."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches

from omniproof.transcription.faults import shorten


class UnknownNameError(LookupError):
    """A model, a case, a parameter or an engine that there is none of."""


def unknown(what: str, name: str, known: Iterable[str]) -> UnknownNameError:
    """Return the error for a name that is none of those `known`, with the nearest one."""
    known = list(known)
    close = get_close_matches(name[:80], known, n=1)
    cure = f"did you mean `{close[0]}`?" if close else f"known: {', '.join(known)}"
    return UnknownNameError(f"expected a {what}, found {shorten(name)}\n    {cure}")
