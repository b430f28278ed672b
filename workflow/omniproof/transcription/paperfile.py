"""A paper file as plain text, lists and dictionaries, each with its place.

A paper file is untrusted, so YAML's conveniences are refused, not interpreted: no tags, anchors or
aliases, no numbers or dates (`4.00` keeps its zeros), no repeated keys. The walk runs over the
events of the parser, which do not nest, so that neither depth nor size can exhaust anything; that
is also why `yaml.compose` does not serve: it follows aliases and recurses in C.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TypeAlias

import yaml

from omniproof.transcription.faults import BadInput, Fault, shorten
from omniproof.transcription.files import display_name, read_text
from omniproof.visible import acting

MAX_DEPTH = 12
MAX_VALUES = 40_000
"""Ten times as many as the longest of our papers has; each may be a fault with a message."""
LOADER = getattr(yaml, "CSafeLoader", yaml.SafeLoader)

Tree: TypeAlias = "str | list[Tree] | dict[str, Tree]"
Path_: TypeAlias = tuple[str | int, ...]
Place: TypeAlias = tuple[int, int]
"""Line and column, from 1."""


@dataclass(frozen=True)
class Document:
    """What stands in a file: `values` with scalars as text; places of values and of keys."""

    name: str
    values: Tree
    places: Mapping[Path_, Place]
    keys: Mapping[Path_, Place]

    def place(self, path: Path_) -> Place:
        """The place of a value, or of the nearest thing around it."""
        while path and path not in self.places:
            path = path[:-1]
        return self.places.get(path, (1, 1))


def load_document(path: Path) -> Document:
    """Read a paper file; raises `BadInput` with everything in it that is refused."""
    name = display_name(path)
    text = read_text(path)
    builder = _Builder(name)
    try:
        for event in yaml.parse(text, Loader=LOADER):
            builder.add(event)
            if len(builder.stack) > MAX_DEPTH or builder.documents > 1 or builder.is_full:
                break
    except yaml.YAMLError as error:
        builder.faults.append(_syntax_fault(name, error, text))
    if builder.faults:
        raise BadInput(builder.faults)
    if builder.root is None:
        raise BadInput([Fault(name, 1, 1, "", "expected a paper, found an empty file", "write it")])
    return Document(name, builder.root, builder.places, builder.keys)


def _syntax_fault(name: str, error: yaml.YAMLError, text: str) -> Fault:
    """A fault of YAML's own syntax, in its words."""
    mark = getattr(error, "problem_mark", None)
    problem = getattr(error, "problem", None) or getattr(error, "reason", None) or "broken YAML"
    line, column = (mark.line + 1, mark.column + 1) if mark else _offset(error, text)
    cure = "check the indentation, and put LaTeX between single quotes"
    return Fault(name, line, column, "", f"expected YAML, found a fault: {problem}", cure)


def _offset(error: yaml.YAMLError, text: str) -> Place:
    """The place of a character that YAML does not allow."""
    before = text[: int(getattr(error, "position", 0) or 0)]
    return before.count("\n") + 1, len(before) - before.rfind("\n")


@dataclass
class _Open:
    """A list or dictionary whose end has not come yet; a dictionary may wait for a value."""

    value: list[Tree] | dict[str, Tree]
    path: Path_
    key: str | None = None


@dataclass
class _Builder:
    """Builds the tree from events; `stack` holds what is open."""

    name: str
    root: Tree | None = None
    stack: list[_Open] = field(default_factory=list)
    places: dict[Path_, Place] = field(default_factory=dict)
    keys: dict[Path_, Place] = field(default_factory=dict)
    faults: list[Fault] = field(default_factory=list)
    documents: int = 0

    def add(self, event: yaml.Event) -> None:
        mark = event.start_mark
        place = (mark.line + 1, mark.column + 1) if mark else (1, 1)
        self.refuse(event, place)
        if isinstance(event, yaml.ScalarEvent | yaml.AliasEvent):
            self.scalar(str(getattr(event, "value", "")), place)
        elif isinstance(event, yaml.MappingStartEvent):
            self.open({}, place)
        elif isinstance(event, yaml.SequenceStartEvent):
            self.open([], place)
        elif isinstance(event, yaml.MappingEndEvent | yaml.SequenceEndEvent):
            self.stack.pop()

    @property
    def is_full(self) -> bool:
        """Whether there are more values than any paper has; noted as a fault."""
        full = len(self.places) > MAX_VALUES
        if full:
            message = f"expected at most {MAX_VALUES} values, found more"
            self.faults = [Fault(self.name, 1, 1, "", message, "split the paper")]
        return full

    def refuse(self, event: yaml.Event, place: Place) -> None:
        """Note what YAML would interpret."""
        for message, cure in self.refusals(event):
            self.fault(place, message, cure)

    def refusals(self, event: yaml.Event) -> Iterator[tuple[str, str]]:
        anchor, tag = getattr(event, "anchor", None), getattr(event, "tag", None)
        if isinstance(event, yaml.AliasEvent):
            yield f"expected a value, found the alias `*{anchor}`", "write the value out"
        elif anchor:
            yield f"expected a value, found the anchor `&{anchor}`", "leave it out"
        if tag:
            yield f"expected plain text, found the tag `{tag}`", "leave the tag out"
        if isinstance(event, yaml.DocumentStartEvent):
            self.documents += 1
            if self.documents == 2:
                yield "expected one document, found a second one", "put each paper into its folder"

    def fault(self, place: Place, message: str, cure: str) -> None:
        top = self.stack[-1] if self.stack else _Open([], ())
        path = (*top.path, top.key) if top.key else top.path
        self.faults.append(Fault(self.name, *place, show_path(path), message, cure))

    def scalar(self, text: str, place: Place) -> None:
        if found := acting(text):
            name = f"U+{ord(found):04X} {unicodedata.name(found, 'a control character')}"
            self.fault(place, f"expected text that can be seen, found {name}", "leave it out")
        top = self.stack[-1] if self.stack else None
        if top is None or not isinstance(top.value, dict) or top.key is not None:
            self.attach(text, place)
            return
        path = (*top.path, text)
        if path in self.keys:
            message = f"expected each key once, found `{text}` again"
            self.fault(place, message, f"the first one is on line {self.keys[path][0]}")
        self.keys.setdefault(path, place)
        top.key = text

    def open(self, value: list[Tree] | dict[str, Tree], place: Place) -> None:
        top = self.stack[-1] if self.stack else None
        if top is not None and isinstance(top.value, dict) and top.key is None:
            self.fault(place, "expected a word as the key", "write text before the colon")
            top.key = ""
        path = self.attach(value, place)
        self.stack.append(_Open(value, path))
        if len(self.stack) > MAX_DEPTH:
            self.fault(place, f"expected at most {MAX_DEPTH} levels, found more", "write less deep")

    def attach(self, value: Tree, place: Place) -> Path_:
        """Put a value where it belongs and remember its place."""
        if not self.stack:
            path: Path_ = ()
            self.root = value if self.root is None else self.root
        else:
            top = self.stack[-1]
            if isinstance(top.value, dict):
                path = (*top.path, top.key or "")
                top.value.setdefault(top.key or "", value)
                top.key = None
            else:
                path = (*top.path, len(top.value))
                top.value.append(value)
        self.places.setdefault(path, place)
        return path


def show_path(path: Path_) -> str:
    """Write a path as `claims[3].kind`; list positions count from 1, keys are cut to 40."""
    text = ""
    for step in path:
        word = shorten(step, 40)[1:-1] if isinstance(step, str) and len(step) > 40 else step
        text += f"[{word + 1}]" if isinstance(word, int) else f"{'.' * bool(text)}{word}"
    return text
