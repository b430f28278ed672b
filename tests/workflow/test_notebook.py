"""Chapters: same bytes every time, talk left out, a failing cell named."""

import json

import pytest

from omniproof.report.notebook import ChapterError, execute

HEAD = "---\nkernelspec:\n  name: python3\n  display_name: Python 3\n---\n\n# Title\n\n"


def chapter(tmp_path, code):
    source = tmp_path / "chapter.md"
    source.write_text(f"{HEAD}```{{code-cell}} python\n{code}\n```\n")
    return source


def test_same_bytes_and_no_talk(tmp_path, capsys):
    source = chapter(tmp_path, "import sys\nprint('talk', file=sys.stderr)\nprint(6 * 7)")
    for name in ("one.ipynb", "two.ipynb"):
        execute(source, tmp_path / name)
    assert (tmp_path / "one.ipynb").read_bytes() == (tmp_path / "two.ipynb").read_bytes()
    cells = json.loads((tmp_path / "one.ipynb").read_text())["cells"]
    assert [cell["id"] for cell in cells] == ["cell-1", "cell-2"]
    assert [out["text"] for out in cells[1]["outputs"]] == [["42\n"]]
    assert "execution" not in cells[1]["metadata"]
    assert capsys.readouterr().err.count("talk") == 2


def test_failing_cell_is_named(tmp_path):
    source = chapter(tmp_path, "total = 1\ntotal / 0")
    with pytest.raises(ChapterError) as caught:
        execute(source, tmp_path / "out.ipynb")
    assert str(caught.value) == f"{source}, cell 2 (total = 1): ZeroDivisionError: division by zero"
    assert not (tmp_path / "out.ipynb").exists()
