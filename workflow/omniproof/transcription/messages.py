"""What the data model refuses, in one sentence shape: what was expected, what was found.

pydantic knows that a value does not fit; which words would have fitted, and which of them the
writer probably meant, is added here.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any, TypeAlias

from pydantic import BaseModel

from omniproof.transcription import model
from omniproof.transcription.faults import Fault, nearest, shorten
from omniproof.transcription.paperfile import Document, Path_, Tree

Said: TypeAlias = tuple[str, str]
"""A message and its cure."""

MODELS: dict[str, type[BaseModel]] = {
    "edition": model.Edition, "notation": model.Notation, "symbols": model.Symbol,
    "tables": model.Table, "claims": model.Claim, "asserts": model.Asserts,
}  # fmt: skip
AN_ID = "an id such as eq:6, eq:10/a3 or tab:2[Z,D_A]"
PATTERNS = {
    "id": AN_ID, "agrees_with": AN_ID, "target": AN_ID,
    "name": "a name of letters, digits and `_`, such as alpha_1",
    "slash": "first or all",
    "angles": "degrees",
    "file": "the name of a CSV file in this folder, such as table-2.csv",
    "source": "the name of a source text, such as omni-arrangement.txt",
    "key": "a key of lower-case letters and hyphens, such as omni-arrangement",
    "sha256": "64 hexadecimal digits",
}  # fmt: skip
TYPES = {
    "string_type": "text", "tuple_type": "a list", "dict_type": "keys with values",
    "model_type": "keys with values", "model_attributes_type": "keys with values",
    "int_parsing": "a whole number", "int_type": "a whole number",
    "int_from_float": "a whole number", "bool_parsing": "true or false",
    "bool_type": "true or false", "greater_than_equal": "a number from 1",
    "int_parsing_size": "a whole number of fewer digits",
    "string_too_short": "text", "too_short": "at least one entry",
}  # fmt: skip


def show_value(value: object) -> str:
    """A value as messages show it."""
    if isinstance(value, str):
        return shorten(value) if value else "nothing"
    return "a list" if isinstance(value, list | tuple) else "keys with values"


def model_fault(error: dict[str, Any], document: Document) -> Fault:
    """Translate one error of pydantic, with its place in the file."""
    path: Path_ = tuple(error["loc"])
    message, cure = _SAYS.get(error["type"], _other)(error)
    if error["type"] == "value_error" and (key := re.match(r"`(\w+)`", message)):
        path = (*path, key[1]) if (*path, key[1]) in document.places else path
    place = document.keys.get(path) if error["type"] == "extra_forbidden" else None
    if error["type"] in {"missing", "extra_forbidden"}:
        path = path[:-1]
    where = label(path, document.values)
    return Fault(document.name, *(place or document.place(path)), where, message, cure)


def label(path: Path_, values: Tree) -> str:
    """Write a path with the names of list entries: `claims[eq:6].kind`."""
    text, here = "", values
    for step in path:
        try:
            here = here[step]  # type: ignore[index]
        except (KeyError, IndexError, TypeError):
            here = ""
        if isinstance(step, int):
            text += f"[{_entry_name(here) or step + 1}]"
        else:
            text += f"{'.' * bool(text)}{step}"
    return text


def _entry_name(value: Tree) -> str:
    name = (value.get("id") or value.get("name")) if isinstance(value, dict) else ""
    return name if isinstance(name, str) and len(name) <= 60 else ""


def _missing(error: dict[str, Any]) -> Said:
    key = error["loc"][-1]
    return f"expected the key `{key}`, found none", f"add `{key}: …`"


def _extra(error: dict[str, Any]) -> Said:
    path = error["loc"]
    parents = [MODELS[step] for step in path[:-1] if step in MODELS]
    known = error.get("known") or sorted((parents or [model.Paper])[-1].model_fields)
    cure = nearest(str(path[-1]), known, "leave it out")
    return f"expected one of {', '.join(known)}, found {shorten(str(path[-1]))}", cure


def _enum(error: dict[str, Any]) -> Said:
    known = re.findall(r"'([^']+)'", error["ctx"]["expected"])
    value = error["input"]
    cure = nearest(value, known) if isinstance(value, str) else ""
    return f"expected one of {', '.join(known)}, found {show_value(value)}", cure


def _pattern(error: dict[str, Any]) -> Said:
    key = next((step for step in reversed(error["loc"]) if isinstance(step, str)), "")
    value = error["input"]
    cure = nearest(value, ["first", "all"]) if key == "slash" else ""
    return f"expected {PATTERNS.get(key, 'another form')}, found {show_value(value)}", cure


def _long(error: dict[str, Any]) -> Said:
    limit = error["ctx"]["max_length"]
    found = len(error["input"])
    return f"expected at most {limit} characters, found {found}", "shorten or split it"


def _rule(error: dict[str, Any]) -> Said:
    return shorten_sentence(str(error["ctx"]["error"])), ""


def _other(error: dict[str, Any]) -> Said:
    expected = TYPES.get(error["type"], "another value")
    return f"expected {expected}, found {show_value(error['input'])}", ""


def shorten_sentence(text: str) -> str:
    """Cut a sentence of the model that repeats a long value."""
    return text if len(text) <= 200 else f"{text[:199]}…"


_SAYS: dict[str, Callable[[dict[str, Any]], Said]] = {
    "missing": _missing,
    "extra_forbidden": _extra,
    "enum": _enum,
    "string_pattern_mismatch": _pattern,
    "string_too_long": _long,
    "value_error": _rule,
}
