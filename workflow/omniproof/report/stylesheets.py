"""Style sheets of the theme, cut down to the rules that some page can meet.

A rule goes when its selector asks for a class that stands neither on a page nor in a script, which
could put it there. Everything else stays, whatever it means.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator

_APART = re.compile(
    r"""/\*.*?\*/|"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*'|url\([^"')]*\)|[{}]""", re.DOTALL
)
_CLASS = re.compile(r"\.(-?[A-Za-z_][\w-]*)")
_CHOICE = re.compile(r":(?:not|is|where|has)\([^)]*\)")
_COMMA = re.compile(r",(?![^(]*\))")
_NESTED = ("@media", "@supports", "@layer", "@container")


def used_rules(css: str, classes: Collection[str]) -> str:
    """Return a style sheet without the rules for classes that are not among `classes`."""
    kept: list[str] = []
    for head, body in _rules(css):
        statements, _, selector = head.rpartition(";")  # such as @charset, @import
        kept += [f"{statements};"] * bool(statements)
        if not selector:
            continue
        if selector.startswith(_NESTED):
            inner = used_rules(body, classes)
            kept += [f"{selector}{{{inner}}}"] * bool(inner)
        elif selector.startswith("@"):
            kept.append(f"{selector}{{{body}}}")
        else:
            met = [part for part in _COMMA.split(selector) if _is_met(part, classes)]
            kept += [f"{','.join(met)}{{{body}}}"] * bool(met)
    return "".join(kept)


def _is_met(selector: str, classes: Collection[str]) -> bool:
    return all(name in classes for name in _CLASS.findall(_CHOICE.sub("", selector)))


def _rules(css: str) -> Iterator[tuple[str, str]]:
    """Yield what stands before each outer block, and what is in it; comments are left out."""
    start = opened = depth = 0
    css = re.sub(r"/\*.*?\*/", "", css, flags=re.DOTALL)
    for found in _APART.finditer(css):
        if found[0] == "{":
            opened = found.end() if depth == 0 else opened
            depth += 1
        elif found[0] == "}":
            depth -= 1
            if depth == 0:
                yield css[start : opened - 1].strip(), css[opened : found.start()].strip()
                start = found.end()
    yield css[start:].strip(), ""
