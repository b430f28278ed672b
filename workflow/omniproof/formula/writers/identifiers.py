r"""The names of printed symbols in Python: `\dot{\theta}_1` is `theta_dot_1`."""

from __future__ import annotations

import keyword
import re

LIBRARIES = frozenset({"np", "sp"})
"""Names that code of ours is written with."""
_ACCENT = re.compile(r"\\([a-z]+)\{([^{}]*)\}")
_SEPARATORS = re.compile(r"[^A-Za-z0-9]+")


def identifier(name: str) -> str:
    r"""Return the identifier of a symbol's canonical name: `\lambda` is `lambda_`, `x'` `x_prime`.

    Accents follow the letter that bears them, then come primes, indices and superscripts.
    """
    if name.isidentifier() and not keyword.iskeyword(name) and name not in LIBRARIES:
        return name
    text = name.replace(r"\mathrm{d}", "d ")
    while _ACCENT.search(text):
        text = _ACCENT.sub(r"\2 \1 ", text)
    text = text.replace("'", " prime ").replace("+", " plus ").replace("-", " minus ")
    found = _SEPARATORS.sub("_", text.replace("*", " star ")).strip("_")
    is_word = found.isidentifier() and not keyword.iskeyword(found) and found not in LIBRARIES
    return found if is_word else f"{found}_" if found[:1].isalpha() else f"_{found}"
