"""Source files by import: complete for every form of the import statement, and no more."""

import ast

import pytest

from omniproof.sources import PACKAGE, imported, sources

FOLDERS = sorted({file.parent for file in PACKAGE.rglob("*.py")})


@pytest.fixture
def package(tmp_path):
    """Return a package whose modules import each other in several ways."""
    files = {
        "__init__.py": "",
        "a.py": "import pack.b\nimport os\n",
        "b.py": "from pack import c\n",
        "c.py": "def later():\n    from pack.sub.d import (\n        name,\n    )\n",
        "sub/__init__.py": "from pack.a import x\n",
        "sub/d.py": "",
        "alone.py": "from packing import c\nimport_module('pack.a')\n",
    }
    for name, text in files.items():
        file = tmp_path / "pack" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return tmp_path / "pack"


@pytest.mark.parametrize(
    ("modules", "expected"),
    [
        pytest.param(["alone"], ["alone.py"], id="other packages and text are no imports"),
        pytest.param(["sub.d"], ["sub/d.py"], id="a leaf"),
        pytest.param(["c"], ["c.py", "sub/d.py"], id="inside a function, over several lines"),
        pytest.param(["a"], ["a.py", "b.py", "c.py", "sub/d.py"], id="along a chain"),
        pytest.param(
            ["sub"], ["a.py", "b.py", "c.py", "sub/__init__.py", "sub/d.py"], id="a subpackage"
        ),
    ],
)
def test_sources(package, modules, expected):
    found = [str(file.relative_to(package)) for file in sources(*modules, package=package)]
    assert [name for name in found if name != "__init__.py"] == expected


def test_unknown_module_is_an_error(package):
    with pytest.raises(ModuleNotFoundError, match="pack has no module nowhere"):
        sources("a", "nowhere", package=package)


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.name)
def test_lines_say_what_syntax_trees_say(folder):
    """Python's own parser is asked about every file of the package."""
    for file in folder.glob("*.py"):
        names = set()
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import):
                names |= {alias.name for alias in node.names}
            elif isinstance(node, ast.ImportFrom):
                names |= {node.module, *(f"{node.module}.{alias.name}" for alias in node.names)}
        own = {name.partition(".")[2] for name in names if name.startswith("omniproof.")}
        assert imported(file, "omniproof") == own
