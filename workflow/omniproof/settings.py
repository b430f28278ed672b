"""What `workflow/config.yaml` may say, checked before the first step runs.

Shape first (pydantic), meaning second (does every named paper and chapter exist?); all faults are
reported together, with their place in the file.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any

import yaml
from pydantic import BaseModel, ConfigDict, Field, StringConstraints, ValidationError

from omniproof.transcription.faults import BadInput, Fault, nearest, shorten
from omniproof.transcription.files import read_text
from omniproof.visible import one_line

Key = Annotated[str, StringConstraints(pattern=r"^[a-z][a-z0-9-]*$")]
Number = Annotated[int, Field(ge=1, strict=True)]
Place = tuple[int | str, ...]
NOTHING: Mapping[str, Any] = {}


class TopicSettings(BaseModel):
    """What is made for a topic of several papers; `drawings` are figures of our own, by name.

    `models` are those whose recordings any of the figures shows.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    drawings: tuple[Key, ...] = ()
    models: tuple[Key, ...] = ()

    @property
    def pictures(self) -> tuple[int | str, ...]:
        """Numbers and names of all that is drawn."""
        return self.drawings


class PaperSettings(TopicSettings):
    """What is made for one paper: its tables and figures, by the numbers of their captions.

    `drawings` are figures that the paper does not have, by name.
    """

    tables: tuple[Number, ...] = ()
    figures: tuple[Number, ...] = ()

    @property
    def pictures(self) -> tuple[int | str, ...]:
        """Numbers and names of all that is drawn."""
        return (*self.figures, *self.drawings)


class MutationSettings(BaseModel):
    """How large the sample of planted misprints is, and what it is drawn with."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    mutants: Number = 60
    seed: Number = 1


class Settings(BaseModel):
    """What is built: papers, topics, simulated cases by model, chapters, the sample of mutants.

    A topic is what several papers say together: it has theorems or drawings, and nothing printed.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    papers: dict[Key, PaperSettings] = Field(min_length=1)
    topics: dict[Key, TopicSettings] = Field(default_factory=dict)
    simulation: dict[Key, tuple[Key, ...]] = Field(default_factory=dict)
    chapters: tuple[Key, ...] = Field(min_length=1)
    mutation: MutationSettings = MutationSettings()

    @property
    def told(self) -> Mapping[str, TopicSettings]:
        """All that theorems are proved and pictures drawn for: papers, then topics."""
        return {**self.papers, **self.topics}


def read_settings(
    file: Path, *, root: Path = Path(), overrides: Mapping[str, Any] = NOTHING
) -> Settings:
    """Read a configuration `file` (relative to the project at `root`) and check it.

    `overrides` replace values at the top level: what Snakemake was given on its command line.
    Raises `BadInput` with all faults.
    """
    text = read_text(root / file)
    values = {**_load(file, text), **overrides}
    try:
        settings = Settings.model_validate(values)
    except ValidationError as error:
        raise BadInput(_shape_fault(dict(item), file, text) for item in error.errors()) from None
    faults = [
        _fault(file, text, place, message, cure) for place, message, cure in _absent(settings, root)
    ]
    if faults:
        raise BadInput(faults)
    return settings


def module_name(paper: str) -> str:
    """Return the name of a paper's or topic's subpackage: `one-wheel` -> `one_wheel`."""
    return paper.replace("-", "_")


def _load(file: Path, text: str) -> Mapping[str, Any]:
    """Return the keys and values at the top of a YAML text."""
    mark, message = None, "expected keys with values, found something else"
    try:
        # An alias of aliases would grow without end where a message shows its value.
        if mark := _first_alias(text):
            message = "expected values, found an alias of one"
        elif isinstance(values := yaml.safe_load(text), dict):
            return values
    except yaml.MarkedYAMLError as error:
        mark, message = error.problem_mark, f"broken YAML: {error.problem}"
    except yaml.YAMLError as error:
        message = f"broken YAML: {one_line(str(error))}"
    except RecursionError:
        message = "expected few levels, found a thousand"
    line, column = (mark.line + 1, mark.column + 1) if mark else (1, 1)
    cure = f"`git diff {file}` shows what was changed"
    raise BadInput([Fault(str(file), line, column, "", message, cure)])


def _first_alias(text: str) -> Any:
    events = yaml.parse(text, Loader=yaml.SafeLoader)
    return next((e.start_mark for e in events if isinstance(e, yaml.AliasEvent)), None)


def _absent(settings: Settings, root: Path) -> Iterator[tuple[Place, str, str]]:
    """Yield place, message and cure for every paper, topic, model, chapter without its files."""
    yield from _absent_papers(settings, root)
    for topic in settings.topics:
        code = f"workflow/omniproof/papers/{module_name(topic)}"
        if not any(file.stem in {"theorems", "figures"} for file in (root / code).glob("*")):
            cure = "write what is proved or drawn there"
            yield ("topics", topic), f"no module theorems or figures in {code}", cure
    yield from _absent_models(settings, root)
    chapters = sorted(file.stem for file in root.glob("notebooks/*.md"))
    for position, chapter in enumerate(settings.chapters):
        if chapter not in chapters:
            place = ("chapters", position)
            yield place, f"no file notebooks/{chapter}.md", _nearest(chapter, chapters)


def _absent_papers(settings: Settings, root: Path) -> Iterator[tuple[Place, str, str]]:
    papers = sorted(file.parent.name for file in root.glob("paper_data/*/paper.yaml"))
    for paper in settings.papers:
        code = f"workflow/omniproof/papers/{module_name(paper)}"
        if paper not in papers:
            missing = f"no file paper_data/{paper}/paper.yaml"
            yield ("papers", paper), missing, _nearest(paper, papers)
        elif not any((root / code).glob("derivations*")):
            cure = "write what mechanics implies for this paper"
            yield ("papers", paper), f"no module derivations in {code}", cure


def _absent_models(settings: Settings, root: Path) -> Iterator[tuple[Place, str, str]]:
    """Yield models without code, and models of drawings that nothing is simulated of."""
    code = "workflow/omniproof/simulation"
    models = sorted(file.stem.replace("_", "-") for file in root.glob(f"{code}/*.py"))
    for model in settings.simulation:
        if model not in models:
            missing = f"no file {code}/{module_name(model)}.py"
            yield ("simulation", model), missing, _nearest(model, models)
    for told, made in settings.told.items():
        kind = "papers" if told in settings.papers else "topics"
        for position, model in enumerate(made.models):
            if model not in settings.simulation:
                place = (kind, told, "models", position)
                cure = _nearest(model, list(settings.simulation))
                yield place, f"no cases of {model} under simulation", cure


def _shape_fault(error: Mapping[str, Any], file: Path, text: str) -> Fault:
    place = tuple(part for part in error["loc"] if part != "[key]")
    found = shorten(str(error["input"]))
    match error["type"]:
        case "missing":
            return _fault(file, text, place, "expected this key, found none", "add it")
        case "extra_forbidden":
            cure = _nearest(str(place[-1]), sorted(_owner(place).model_fields))
            return _fault(file, text, place, "expected a known key, found another", cure)
        case "string_pattern_mismatch":
            cure = "write lower-case words joined by hyphens, such as omni-arrangement"
            return _fault(file, text, place, f"expected a key, found {found}", cure)
        case "greater_than_equal" | "int_type" | "int_parsing":
            counted = place[0] == "mutation"
            cure = "write how many" if counted else "write the number of the caption"
            return _fault(file, text, place, f"expected a whole number from 1, found {found}", cure)
        case _:
            return _fault(file, text, place, f"{error['msg']}, found {found}", "")


def _owner(place: Place) -> type[BaseModel]:
    """Return the record that the key at a place belongs to."""
    if len(place) == 1:
        return Settings
    owners: dict[str, type[BaseModel]] = {
        "mutation": MutationSettings,
        "topics": TopicSettings,
    }
    return owners.get(str(place[0]), PaperSettings)


def _nearest(word: str, known: Sequence[str]) -> str:
    return nearest(word, known, f"known: {', '.join(known) or 'none'}")


def _fault(file: Path, text: str, place: Place, message: str, cure: str) -> Fault:
    line, column = _position(yaml.compose(text, Loader=yaml.SafeLoader), place)
    path = "".join(f"[{part + 1}]" if isinstance(part, int) else f".{part}" for part in place)
    return Fault(str(file), line, column, path.removeprefix("."), message, cure)


def _position(node: yaml.Node | None, place: Place) -> tuple[int, int]:
    """Return line and column, from 1, of the key or item that `place` leads to, or of its owner."""
    mark = node.start_mark if node else None
    for part in place:
        found = None
        if isinstance(node, yaml.MappingNode):
            found = next((pair for pair in node.value if pair[0].value == part), None)
        elif isinstance(node, yaml.SequenceNode) and isinstance(part, int):
            found = (node.value[part],) * 2 if part < len(node.value) else None
        if found is None:
            break
        mark, node = found[0].start_mark, found[1]
    return (mark.line + 1, mark.column + 1) if mark else (1, 1)
