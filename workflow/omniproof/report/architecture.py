"""The project as two graphs, read from what is run: the rules, and what imports what.

A picture of an architecture that is drawn by hand shows what somebody once meant. These are read
from Snakemake's own graph of rules, from the heads of the rule files (which a test compares with
the rules), and from the import statements of the package.
"""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from omniproof.report.layers import Arrow
from omniproof.sources import imported

_NODE = re.compile(r'^\s*(\d+)\s*\[\s*label\s*=\s*"(\w+)"', re.MULTILINE)
_ARROW = re.compile(r"^\s*(\d+)\s*->\s*(\d+)", re.MULTILINE)
_RULE = re.compile(r"^( *)rule *(\w*):\n((?:\1 +.*\n|\n)+)", re.MULTILINE)
_NAMED = re.compile(r'name:\s+f"([a-z]+)_')
_INPUT = re.compile(r"^ +input:\n((?: {8,}.*\n)+)", re.MULTILINE)
_NEEDED = re.compile(r"^    (\w+) *= *(\S+)$", re.MULTILINE)
_MADE = ("results", "book/_build")
GOAL = "all"
"""The rule that only names what a whole build makes."""


@dataclass(frozen=True)
class RuleFile:
    """A file of rules: its name, what it is for, its rules by family, and who needs a source."""

    name: str
    purpose: str
    families: tuple[str, ...]
    sources: tuple[Arrow, ...]


@dataclass(frozen=True)
class Graph:
    """Nodes with the group that each belongs to, and arrows with their weights."""

    groups: Mapping[str, str]
    arrows: Mapping[Arrow, int]


def ask_snakemake(project: Path) -> str:
    """Return Snakemake's graph of the rules of a whole build, in the dot language.

    Raises `subprocess.CalledProcessError` when Snakemake cannot read the workflow.
    """
    command = [sys.executable, "-m", "snakemake", "--rulegraph", "dot", "--nolock", "--quiet"]
    run = subprocess.run(  # noqa: S603 - our own interpreter, no shell
        command, cwd=project, check=True, stdout=subprocess.PIPE, text=True
    )
    return run.stdout


def read_rule_files(folder: Path) -> tuple[RuleFile, ...]:
    """Read the files of rules (`*.smk`) of a folder, in order of name."""
    texts = {path.stem: path.read_text(encoding="utf-8") for path in sorted(folder.glob("*.smk"))}
    return tuple(_rule_file(name, text) for name, text in texts.items() if _RULE.search(text))


def rule_graph(dot: str, files: Sequence[RuleFile]) -> Graph:
    """Return the rules by family, `figures_ballbot` and its like as one, and their sources.

    dot: as `ask_snakemake` gives it. An arrow weighs how many pairs of rules it stands for.
    """
    names = dict(_NODE.findall(dot))
    named = {family: file.name for file in files for family in file.families}
    of_rule = {name: _family(name, named) for name in names.values() if name != GOAL}
    many = Counter(of_rule.values())
    label = {f: f"{f} \N{MULTIPLICATION SIGN} {n}" if n > 1 else f for f, n in many.items()}
    arrows = Counter(
        (label[of_rule[names[a]]], label[of_rule[names[b]]])
        for a, b in _ARROW.findall(dot)
        if GOAL not in (names[a], names[b])
    )
    sources = [(place, label[f]) for file in files for place, f in file.sources if f in label]
    groups = {label[family]: named[family] for family in many}
    return Graph(
        dict.fromkeys((place for place, _ in sources), "sources") | groups,
        arrows + Counter(sources),
    )


def import_graph(package: Path) -> Graph:
    """Return the parts of a package (folders and modules beside them), and what they import.

    The figures of a paper are a part of their own: they show what is simulated from what the paper
    prints. An arrow leads from the part that imports to the part that is imported; it weighs how
    many files of the one import from the other.
    """
    arrows: Counter[Arrow] = Counter()
    groups: dict[str, str] = {}
    for file in sorted(package.rglob("*.py")):
        path = file.relative_to(package).with_suffix("").parts
        part = _part(path)
        if part.startswith("__"):
            continue
        groups[part] = "module" if len(path) == 1 else "package"
        known = {_part(name.split(".")) for name in imported(file, package.name)} - {part}
        arrows.update((part, other) for other in known)
    return Graph(groups, Counter({arrow: n for arrow, n in arrows.items() if arrow[1] in groups}))


def _part(path: Sequence[str]) -> str:
    """Return the part that a module belongs to."""
    return "figures" if path[0] == "papers" and "figures" in path else path[0]


def parts(package: Path) -> tuple[tuple[str, str], ...]:
    """Return the parts of a package, each with the first sentence of its docstring."""
    files = [*package.glob("*/__init__.py"), *package.glob("[!_]*.py")]
    found = {
        file.parent.name if file.name == "__init__.py" else file.name: ast.get_docstring(
            ast.parse(file.read_text(encoding="utf-8"))
        )
        for file in files
    }
    return tuple((name, _first_sentence(text or "")) for name, text in sorted(found.items()))


def _first_sentence(text: str) -> str:
    """Return the first sentence of a docstring, on one line."""
    return re.split(r"(?<=\.)\s", text.replace("\n", " "), maxsplit=1)[0].strip()


def _rule_file(name: str, text: str) -> RuleFile:
    head = text.split('"""')[1].strip()
    needed = {key: _source(pattern) for key, pattern in _NEEDED.findall(head.split("OUTPUTS")[0])}
    rules = [(own or _NAMED.findall(body)[0], body) for _, own, body in _RULE.findall(text)]
    found = [
        (needed[key], family)
        for family, body in rules
        for key in re.findall(r"^ +(\w+)=", "".join(_INPUT.findall(body)), re.MULTILINE)
        if needed.get(key)
    ]
    return RuleFile(
        name,
        _purpose(head),
        tuple(family for family, _ in rules),
        tuple(dict.fromkeys(found)),
    )


def _purpose(head: str) -> str:
    """Return what a file of rules is for, from its first sentence."""
    return head.splitlines()[0].removeprefix("This part of the workflow ").rstrip(".")


def _source(pattern: str) -> str:
    """Return the folder of a source: `paper_data/{paper}/*` -> `paper_data/`; else nothing.

    Code is a source only where there is some for every paper.
    """
    code = pattern.startswith("workflow/") and "{" not in pattern
    if code or pattern.startswith(_MADE) or "/" not in pattern:
        return ""
    fixed = re.split(r"/(?=[^/]*[{*])", pattern, maxsplit=1)[0]
    return "" if fixed == pattern else fixed.rpartition("/")[2] + "/"


def _family(rule: str, families: Mapping[str, str]) -> str:
    """Return the family of a rule: its own name, or what stands before the first `_`."""
    return rule if rule in families else rule.partition("_")[0]
