"""Derivations rest on mechanics and SymPy only: they never see what is printed, nor the engines."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

import omniproof.papers

PAPERS = Path(omniproof.papers.__file__).parent
MODULES = sorted(PAPERS.glob("*/derivations/*.py")) + sorted(PAPERS.glob("*/derivations.py"))
STANDARD = {
    "__future__",
    "collections.abc",
    "dataclasses",
    "functools",
    "itertools",
    "types",
    "typing",
}
ANY_NAME = STANDARD | {"sympy", "omniproof.registry"}
SOME_NAMES = {
    "omniproof.kinematics": {
        "ballbot", "frames", "omni", "rolling", "sphere", "trajectory", "zonotope"
    },
    "omniproof.transcription.model": {"Form"},
    "sympy.polys.matrices": {"DomainMatrix"},
}  # fmt: skip


def imports(tree: ast.AST) -> Iterator[tuple[str, str]]:
    """Every imported module with the name taken from it (`*` for the module itself)."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from ((alias.name, "*") for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield from (("." * node.level + (node.module or ""), a.name) for a in node.names)


def allowed(module: str, name: str, own: str) -> bool:
    if module == own or module.startswith(f"{own}."):
        return True
    return module in ANY_NAME or name in SOME_NAMES.get(module, set())


def calls(tree: ast.AST) -> set[str]:
    """Names of all functions that are called."""
    functions = [node.func for node in ast.walk(tree) if isinstance(node, ast.Call)]
    return {getattr(f, "id", getattr(f, "attr", "")) for f in functions}


@pytest.mark.parametrize("file", MODULES, ids=lambda file: f"{file.parent.parent.name}/{file.stem}")
def test_a_derivation_imports_mechanics_and_sympy_only(file: Path) -> None:
    own = f"omniproof.papers.{file.relative_to(PAPERS).parts[0]}"
    tree = ast.parse(file.read_text(encoding="utf-8"))
    assert [found for found in imports(tree) if not allowed(*found, own)] == []


@pytest.mark.parametrize("file", MODULES, ids=lambda file: f"{file.parent.parent.name}/{file.stem}")
def test_a_derivation_reads_no_text_and_no_file(file: Path) -> None:
    tree = ast.parse(file.read_text(encoding="utf-8"))
    reading = {"sympify", "parse_expr", "parse_latex", "eval", "exec", "open", "S", "import_module"}
    assert calls(tree) & reading == set()


def test_what_a_derivation_imports_from_its_paper_reads_nothing_either() -> None:
    modules = {
        module
        for file in MODULES
        for module, _ in imports(ast.parse(file.read_text(encoding="utf-8")))
        if module.startswith("omniproof.papers.") and ".derivations" not in module
    } - {"omniproof.registry"}
    assert "omniproof.papers.omni_arrangement.arrangements" in modules
    for module in modules:
        file = PAPERS.joinpath(*module.split(".")[2:]).with_suffix(".py")
        own = ".".join(module.split(".")[:3])
        tree = ast.parse(file.read_text(encoding="utf-8"))
        assert [found for found in imports(tree) if not allowed(*found, own)] == []


@pytest.mark.parametrize(
    ("line", "fine"),
    [
        pytest.param("from sympy import cos", True, id="SymPy"),
        pytest.param("from omniproof.kinematics import omni", True, id="mechanics"),
        pytest.param("from omniproof.transcription.model import Form", True, id="the form"),
        pytest.param("from omniproof.transcription.model import Claim", False, id="a claim"),
        pytest.param("from omniproof.transcription import loader", False, id="the paper file"),
        pytest.param("from omniproof.decide.zero_test import decide_equal", False, id="an engine"),
        pytest.param("import yaml", False, id="a reader"),
        pytest.param("from pathlib import Path", False, id="files"),
    ],
)  # fmt: skip
def test_what_this_test_lets_pass(line: str, fine: bool) -> None:
    ((module, name),) = imports(ast.parse(line))
    assert allowed(module, name, "omniproof.papers.some_paper") is fine
