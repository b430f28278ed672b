"""The column `interval` of the ledger, taken apart."""

from __future__ import annotations

import re

_BRACKETS = re.compile(r"[\[(]\s*[^\[\]()]*,[^\[\]()]*[\])]")
_DECIMAL = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


def split_interval(text: str) -> tuple[str, str]:
    """Return interval and exact value of `3.07920; [3.075, 3.085]`, in either order of the two.

    What is absent is empty.
    """
    brackets = _BRACKETS.search(text)
    value = _DECIMAL.search(_BRACKETS.sub(" ", text))
    return (brackets[0] if brackets else "", value[0] if value else "")
