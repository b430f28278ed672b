"""The rules: their files exist, their contracts are true, their inputs are complete."""

import re
from fnmatch import fnmatch
from pathlib import Path

import pytest

from omniproof.settings import module_name, read_settings
from omniproof.sources import sources

RULE_FILES = [
    "audit.smk",
    "mutation.smk",
    "simulation.smk",
    "tables.smk",
    "figures.smk",
    "notebooks.smk",
    "corrigenda.smk",
    "book.smk",
    "crate.smk",
    "architecture.smk",
]
ORDER = [
    "name",
    "default_target",
    "input",
    "output",
    "params",
    "log",
    "benchmark",
    "threads",
    "script",
]
RULE = re.compile(r"^( *)rule\b.*:\n((?:\1 +.*\n|\n)+)", re.MULTILINE)
FRAME = {
    "workflow/omniproof/report/step.py",
    "workflow/omniproof/transcription/faults.py",
    "workflow/omniproof/visible.py",
}


def files(job, side):
    """Return all files on one side of a job."""
    return [file for named in job[side].values() for file in named]


def contract(text, title):
    """Return the name and the pattern of each line below a title of the head of a rule file."""
    block = re.search(rf"{title}:\n((?:    .*\n)+)", text)
    assert block, f"no {title}"
    return dict(re.split(r" +=? *", line.strip(), maxsplit=1) for line in block[1].splitlines())


def fits(file, pattern):
    """Return whether a file is one of a pattern with wildcards `{paper}` and `*`."""
    return fnmatch(file, re.sub(r"{\w+}", "*", pattern))


def test_every_leaf_is_in_git(jobs, project):
    made = {file for job in jobs for file in files(job, "output")}
    needed = {file for job in jobs for file in files(job, "input")}
    assert [file for file in sorted(needed - made) if not (project.folder / file).is_file()] == []


@pytest.mark.parametrize("name", RULE_FILES)
def test_contract_announces_the_outputs(jobs, root, name):
    announced = contract((root / "workflow/rules" / name).read_text(), "OUTPUTS")
    made = [
        (key, file)
        for job in jobs
        if job["rules"] == name
        for key, named in job["output"].items()
        for file in named
    ]
    assert [x for x in made if not fits(x[1], announced.get(x[0], ""))] == []
    assert {key for key, _ in made} == set(announced)


@pytest.mark.parametrize("name", RULE_FILES)
def test_contract_announces_the_inputs(jobs, root, name):
    announced = contract((root / "workflow/rules" / name).read_text(), "REQUIRED INPUTS")
    here = [job for job in jobs if job["rules"] == name]
    own = {file for job in here for file in files(job, "output")}
    needed = [
        (key, file)
        for job in here
        for key, named in job["input"].items()
        for file in named
        if key != "package" and file not in own
    ]
    data = [x for x in needed if not x[1].endswith(".py")]
    assert [x for x in data if not fits(x[1], announced.get(x[0], ""))] == []
    assert (
        {key for key, _ in needed}
        <= set(announced)
        <= {key for job in here for key in job["input"]}
    )


@pytest.mark.parametrize("name", RULE_FILES)
def test_rules_are_short_and_in_one_order(root, name):
    for _, body in RULE.findall((root / "workflow/rules" / name).read_text()):
        keys = re.findall(r"^ +(\w+):$", body, re.MULTILINE)
        assert keys == [key for key in ORDER if key in keys]
        assert body.lstrip().startswith('"""')
        assert len(body.strip().splitlines()) <= 25


def test_every_step_has_title_log_and_benchmark(jobs):
    assert [
        job["rule"] for job in jobs if not (job["title"] and job["log"] and job["benchmark"])
    ] == []
    assert len({job["title"] for job in jobs}) == len(jobs)
    assert [job["title"] for job in jobs if "{" in job["title"]] == []


def test_every_file_has_a_name(jobs):
    assert [job["rule"] for job in jobs if None in job["input"] or None in job["output"]] == []


def test_what_a_script_imports_is_an_input(jobs, root):
    for job in jobs:
        script = (root / "workflow/rules" / job["script"]).resolve()
        modules = re.findall(r"from omniproof\.([\w.]+) import", script.read_text())
        needed = {str(file.relative_to(root)) for file in sources(*modules)} - FRAME
        assert sorted(needed - set(files(job, "input"))) == []


@pytest.mark.parametrize(
    ("rule", "module"),
    [
        ("audit", "derivations"),
        ("mutation", "derivations"),
        ("theorems", "theorems"),
        ("figures_omni_arrangement", "figures"),
    ],
)
def test_what_is_imported_by_name_is_an_input(jobs, root, rule, module):
    needed = sources(f"papers.omni_arrangement.{module}")
    given = {file for job in jobs if job["rule"] == rule for file in files(job, "input")}
    assert [file for file in needed if str(file.relative_to(root)) not in given] == []


@pytest.mark.parametrize(
    ("source", "steps"),
    [
        pytest.param(
            "papers/omni_arrangement/figures/curves.py",
            {"figures_omni_arrangement"},
            id="drawings are drawn",
        ),
        pytest.param(
            "report/summary.py", {"summary"}, id="the report's code is no part of an audit"
        ),
    ],
)
def test_source_is_input_where_it_is_used_only(jobs, source, steps):
    file = f"workflow/omniproof/{source}"
    assert {job["rule"] for job in jobs if file in files(job, "input")} == steps


def test_what_a_chapter_imports_is_an_input(jobs, root):
    """Else an edit of the numbers or tables of a chapter would leave the old page."""
    chapters = [job for job in jobs if job["rule"] == "notebook"]
    assert chapters
    for job in chapters:
        (source,) = job["input"]["source"]
        modules = re.findall(r"^from omniproof\.([\w.]+) import", (root / source).read_text(), re.M)
        needed = {str(file.relative_to(root)) for file in sources(*modules)}
        assert sorted(needed - set(files(job, "input"))) == []


def test_what_a_chapter_holds_its_formulas_against_is_an_input(jobs, root):
    """Else a change of the printed form would leave the old text beside it."""
    (job,) = (job for job in jobs if job["input"].get("source") == ["notebooks/derivation.md"])
    papers = ("ballbot", "omni-arrangement", "omni-trajectory")
    needed = {f.relative_to(root) for p in papers for f in (root / "paper_data" / p).iterdir()}
    assert set(job["input"]["printed"]) == set(map(str, needed))


def test_derivations_belong_to_their_paper(jobs, root):
    """What several papers share, a topic, may be told in any chapter."""
    settings = read_settings(Path("workflow/config.yaml"), root=root)
    shared = {module_name(topic) for topic in settings.topics}
    for job in jobs:
        folders = (re.search(r"/papers/([a-z_]+)/", file) for file in files(job, "input"))
        papers = {found[1] for found in folders if found} - shared
        named = f"{job['rule']} {files(job, 'output')}".replace("-", "_")
        of_all = "simulation" in named or job["rule"] in {"theorems", "mutation"}
        assert of_all or all(paper in named for paper in papers)
