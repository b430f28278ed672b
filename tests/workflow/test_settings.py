"""The configuration: each mistake gives its message, to the letter."""

from itertools import pairwise
from pathlib import Path

import pytest

from omniproof.settings import read_settings
from omniproof.transcription.faults import BadInput

GOOD = """\
papers:
  one-wheel:
    tables: [1]
    figures: [1, 2]
chapters:
  - index
  - one-wheel
"""
FILE = Path("config.yaml")
BITS = list(pairwise("abcdefghijkl"))


@pytest.fixture
def folder(tmp_path):
    """Return a project with one paper and two chapters."""
    for name in (
        "paper_data/one-wheel/paper.yaml",
        "workflow/omniproof/papers/one_wheel/derivations.py",
        "notebooks/index.md",
        "notebooks/one-wheel.md",
        "workflow/omniproof/simulation/one_wheel.py",
    ):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).touch()
    return tmp_path


def test_good_file(folder):
    (folder / FILE).write_text(GOOD)
    settings = read_settings(FILE, root=folder)
    assert settings.papers["one-wheel"].figures == (1, 2)
    assert settings.chapters == ("index", "one-wheel")


def test_command_line_comes_first(folder):
    (folder / FILE).write_text(GOOD)
    assert read_settings(FILE, root=folder, overrides={"chapters": ["index"]}).chapters == (
        "index",
    )


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        pytest.param(
            "tables",
            "tabels",
            "config.yaml:3:5: papers.one-wheel.tabels: expected a known key, found another\n"
            "    did you mean `tables`?",
            id="misspelt key",
        ),
        pytest.param(
            "chapters",
            "zzz",
            "config.yaml:1:1: chapters: expected this key, found none\n"
            "    add it\n"
            "config.yaml:5:1: zzz: expected a known key, found another\n"
            "    known: chapters, mutation, papers, simulation, topics",
            id="missing and unknown key",
        ),
        pytest.param(
            "chapters:",
            "mutation:\n  mutants: none\n  seeds: 1\nchapters:",
            "config.yaml:6:3: mutation.mutants: expected a whole number from 1, found 'none'\n"
            "    write how many\n"
            "config.yaml:7:3: mutation.seeds: expected a known key, found another\n"
            "    did you mean `seed`?",
            id="sample of mutants",
        ),
        pytest.param(
            "chapters:",
            "simulation:\n  one-weel: [slow]\nchapters:",
            "config.yaml:6:3: simulation.one-weel: "
            "no file workflow/omniproof/simulation/one_weel.py\n"
            "    did you mean `one-wheel`?",
            id="misspelt model",
        ),
        pytest.param(
            "chapters:",
            "simulation:\n  one-wheel: [Slow run]\nchapters:",
            "config.yaml:6:15: simulation.one-wheel[1]: expected a key, found 'Slow run'\n"
            "    write lower-case words joined by hyphens, such as omni-arrangement",
            id="no name of a case",
        ),
        pytest.param(
            "chapters:",
            "    models: [one-weel]\nsimulation:\n  one-wheel: [slow]\nchapters:",
            "config.yaml:5:14: papers.one-wheel.models[1]: no cases of one-weel under simulation\n"
            "    did you mean `one-wheel`?",
            id="drawings of a model that is not simulated",
        ),
        pytest.param(
            "[1, 2]",
            "[1, two, 0]",
            "config.yaml:4:18: papers.one-wheel.figures[2]: "
            "expected a whole number from 1, found 'two'\n"
            "    write the number of the caption\n"
            "config.yaml:4:23: papers.one-wheel.figures[3]: "
            "expected a whole number from 1, found '0'\n"
            "    write the number of the caption",
            id="no caption's number",
        ),
        pytest.param(
            "  one-wheel:",
            "  one-weel:",
            "config.yaml:2:3: papers.one-weel: no file paper_data/one-weel/paper.yaml\n"
            "    did you mean `one-wheel`?",
            id="misspelt paper",
        ),
        pytest.param(
            "- index",
            "- Index page",
            "config.yaml:6:5: chapters[1]: expected a key, found 'Index page'\n"
            "    write lower-case words joined by hyphens, such as omni-arrangement",
            id="no key",
        ),
        pytest.param(
            "- index",
            "- appendix",
            "config.yaml:6:5: chapters[1]: no file notebooks/appendix.md\n"
            "    known: index, one-wheel",
            id="unknown chapter",
        ),
        pytest.param(
            "    tables",
            "\ttables",
            "config.yaml:3:1: broken YAML: found character '\\t' that cannot start any token\n"
            "    `git diff config.yaml` shows what was changed",
            id="broken YAML",
        ),
        pytest.param(
            GOOD,
            "nothing",
            "config.yaml:1:1: expected keys with values, found something else\n"
            "    `git diff config.yaml` shows what was changed",
            id="no mapping",
        ),
    ],
)
def test_message(folder, old, new, message):
    (folder / FILE).write_text(GOOD.replace(old, new, 1))
    with pytest.raises(BadInput) as caught:
        read_settings(FILE, root=folder)
    faults = len(caught.value.faults)
    word = "fault" if faults == 1 else "faults"
    assert str(caught.value) == f"{message}\n{faults} {word} in config.yaml"


def test_paper_without_derivations(folder):
    (folder / FILE).write_text(GOOD)
    (folder / "workflow/omniproof/papers/one_wheel/derivations.py").unlink()
    with pytest.raises(
        BadInput, match="no module derivations in workflow/omniproof/papers/one_wheel"
    ):
        read_settings(FILE, root=folder)


def test_topic_has_drawings_and_no_printed_tables(folder):
    (folder / "workflow/omniproof/papers/two_wheels").mkdir()
    (folder / "workflow/omniproof/papers/two_wheels/theorems.py").touch()
    text = GOOD.replace("chapters:", "topics:\n  two-wheels:\n    drawings: [axes]\nchapters:")
    (folder / FILE).write_text(text)
    settings = read_settings(FILE, root=folder)
    assert settings.topics["two-wheels"].pictures == ("axes",)
    assert list(settings.told) == ["one-wheel", "two-wheels"]
    (folder / FILE).write_text(text.replace("drawings: [axes]", "tables: [1]"))
    with pytest.raises(BadInput, match=r"topics\.two-wheels\.tables: expected a known key"):
        read_settings(FILE, root=folder)


def test_topic_without_theorems_and_figures(folder):
    (folder / FILE).write_text(GOOD.replace("chapters:", "topics:\n  two-wheels: {}\nchapters:"))
    with pytest.raises(
        BadInput, match="no module theorems or figures in workflow/omniproof/papers/two_wheels"
    ):
        read_settings(FILE, root=folder)


BOMB = "a: &a [x]\n" + "".join(f"{b}: &{b} [{', '.join([f'*{a}'] * 9)}]\n" for a, b in BITS)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        pytest.param(
            f"papers:\n{BOMB}".encode(), "3:8: expected values, found an alias", id="bomb"),
        pytest.param(
            b"papers: " + b"[" * 5_000 + b"]" * 5_000,
            "1:1: expected few levels, found a thousand", id="deep"),
        pytest.param(
            b"papers: \x1b[31m", "1:1: broken YAML: unacceptable character #x001b", id="escape"),
        pytest.param(
            b"papers: \xff", "1:9: expected UTF-8, found the byte 0xff", id="another encoding"),
        pytest.param(b"papers: !!python/name:os.system", "1:9: broken YAML: could not", id="code"),
    ],
)  # fmt: skip
def test_hostile_file(folder, monkeypatch, text, message):
    monkeypatch.chdir(folder)
    FILE.write_bytes(text)
    with pytest.raises(BadInput) as caught:
        read_settings(FILE)
    assert str(caught.value).startswith(f"config.yaml:{message}")


def test_no_file(folder, monkeypatch):
    monkeypatch.chdir(folder)
    with pytest.raises(BadInput, match=r"config.yaml:1:1: expected a file, found none"):
        read_settings(FILE)


def test_our_own_file(root):
    assert "omni-arrangement" in read_settings(Path("workflow/config.yaml"), root=root).papers
