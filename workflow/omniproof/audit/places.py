"""The place of a claim in words, from its id."""

from __future__ import annotations

from omniproof.transcription.model import ID

_OBJECTS = {
    "eq": "Eq. ({})",
    "tab": "Table {}",
    "fig": "Figure {}",
    "sec": "Section {}",
    "app": "Appendix ({})",
}
_NAMED = {"abstract": "Abstract", "references": "References", "authors": "About the authors"}


def where(claim: str) -> str:
    """Return the place of a claim or entry: `eq:6[2,3]` is "Eq. (6), row 2, column 3".

    Raises `ValueError` for what is no id.
    """
    return ", ".join(places(claim))


def places(claim: str) -> tuple[str, ...]:
    """Return the same from the outermost place to the innermost.

    Raises `ValueError` for what is no id.
    """
    parts = ID.fullmatch(claim)
    if parts is None:
        raise ValueError(f"expected an id such as eq:6[2,3], got {claim!r}")
    number = parts["number"]
    if number in _NAMED:
        words = [_NAMED[number]]
    elif parts["object"] == "xref":
        words = [f"Reference: {number.replace('-', ' ')}"]
    else:
        words = [_OBJECTS[parts["object"]].format(number)]
    if parts["again"]:
        words.append(f"place {parts['again'][1:]}")
    if parts["part"]:
        words.append(parts["part"].replace("-", " "))
    if parts["index"]:
        words.extend(_index(parts["object"], parts["index"].split(",")))
    return tuple(words)


def _index(kind: str, index: list[str]) -> list[str]:
    if kind != "eq":
        return [f"row {i}" if i.isdigit() else i for i in index]
    if len(index) == 1:
        return [f"entry {index[0]}"]
    return [f"row {index[0]}", f"column {index[1]}"]
