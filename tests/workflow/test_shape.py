"""The shape of our code: short functions, short files, short rules."""

import ast
from collections import Counter
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
FILES = sorted(
    file.relative_to(ROOT)
    for folder in ("workflow", "tests", "book/_ext")
    for file in (ROOT / folder).rglob("*.py")
    if "egg-info" not in str(file)
)


def code_lines(node, lines):
    """Return the lines of a function or module without blanks, comments and docstrings."""
    docstrings = {
        line
        for inner in ast.walk(node)
        if isinstance(inner, ast.Expr) and isinstance(inner.value, ast.Constant)
        for line in range(inner.lineno, inner.end_lineno + 1)
    }
    first, last = getattr(node, "lineno", 1), getattr(node, "end_lineno", len(lines))
    return [
        number
        for number in range(first, last + 1)
        if lines[number - 1].strip()
        and not lines[number - 1].lstrip().startswith("#")
        and number not in docstrings
    ]


@pytest.mark.parametrize("file", FILES, ids=str)
def test_functions_and_files_are_short(file):
    text = (ROOT / file).read_text()
    tree, lines = ast.parse(text), text.splitlines()
    functions = [x for x in ast.walk(tree) if isinstance(x, ast.FunctionDef)]
    assert [f.name for f in functions if len(code_lines(f, lines)) > 50] == []
    assert len(lines) <= 400 or file.parts[0] == "tests"


def test_no_two_test_files_have_one_name():
    """Test files import each other by bare names, so a name stands for one file only.

    A second file of that name is found only where no old bytecode hides it. pytest's import mode
    `importlib` allows equal names of tests, but not these imports; so the names are counted here.
    """
    names = Counter(file.name for file in FILES if file.parts[0] == "tests")
    assert [name for name, count in names.items() if count > 1 and name != "conftest.py"] == []
