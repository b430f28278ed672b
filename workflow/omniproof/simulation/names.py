"""What to say of a name that nothing has: what was expected, what was found, what is nearest."""

from __future__ import annotations

from collections.abc import Iterable

from omniproof.transcription.faults import nearest, shorten


class UnknownNameError(LookupError):
    """A model, a case, a parameter or an engine that there is none of."""


def unknown(what: str, name: str, known: Iterable[str]) -> UnknownNameError:
    """Return the error for a name that is none of those `known`, with the nearest one."""
    known = list(known)
    cure = nearest(name, known, f"known: {', '.join(known)}")
    return UnknownNameError(f"expected a {what}, found {shorten(name)}\n    {cure}")
