"""
What the files beside it share: checked settings, the environment of all steps, names of files.
"""

import os
import re
import shlex
import sys
from pathlib import Path

from omniproof.report.revision import read_revision
from omniproof.settings import module_name, read_settings
from omniproof.simulation.engines import can_run
from omniproof.sources import sources
from omniproof.transcription.faults import BadInput
from omniproof.visible import visible

# Same bytes on every run: one thread for linear algebra, one order of sets, no display.
os.environ.update(
    OMP_NUM_THREADS="1",
    OPENBLAS_NUM_THREADS="1",
    MKL_NUM_THREADS="1",
    PYTHONHASHSEED="0",
    MPLBACKEND="Agg",
)
# Modules that are compiled anew in every step cost more than most steps.
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)

# Snakemake hands this to a shell as it stands, blanks in the path of the project included.
sys.executable = shlex.quote(os.path.join(sys.prefix, "bin", "python"))

try:
    settings = read_settings(Path("workflow/config.yaml"), overrides=config)
except BadInput as bad:
    raise SystemExit(visible(str(bad))) from None


wildcard_constraints:
    paper="[a-z][a-z0-9-]*",
    chapter="[a-z][a-z0-9-]*",


def package(*modules):
    """Return the source files of modules of the package and of all that they import."""
    return [os.path.relpath(file) for file in sources(*modules)]


def paper_module(paper, *modules):
    """Return the source files of a paper's modules, as `package` does."""
    return package(*(f"papers.{module_name(paper)}.{module}" for module in modules))


def paper_data(paper):
    """Return the files that say what a paper prints."""
    return sorted(map(str, Path("paper_data", paper).iterdir()))


def data_behind(*modules):
    """Return the files that say what the papers print that modules of the package rest on."""
    folders = (Path(file).parts for file in package(*modules))
    used = {parts[3] for parts in folders if parts[2] == "papers" and len(parts) > 4}
    return [
        file
        for paper in settings.papers
        if module_name(paper) in used
        for file in paper_data(paper)
    ]


def theorems_of(*papers):
    """Return the source files of the theorems of papers and topics; a paper may have none."""
    folders = {paper: Path("workflow/omniproof/papers", module_name(paper)) for paper in papers}
    proved = [paper for paper, folder in folders.items() if any(folder.glob("theorems*"))]
    return sorted({file for paper in proved for file in paper_module(paper, "theorems")})


def readings_of(paper):
    """Return what was decided about a paper by reading it."""
    return sorted(map(str, Path("workflow/omniproof/papers", module_name(paper)).glob("*.yaml")))


def ledgers_of(*papers):
    """Return the ledgers of papers."""
    return [f"results/ledger/{paper}.json" for paper in papers]


def tables_of(*papers):
    """Return the tables that are made for papers."""
    return [
        f"results/tables/{paper}/table-{number}.csv"
        for paper in papers
        for number in settings.papers[paper].tables
    ]


def figures_of(*papers, suffix="svg"):
    """Return the pictures of papers and topics, or their data with suffix csv."""
    return [
        f"results/figures/{paper}/figure-{number}.{suffix}"
        for paper in papers
        for number in settings.told[paper].pictures
    ]


def abouts_of(*papers):
    """Return what is said of the figures of papers and topics: titles, captions, alt texts."""
    return [f"results/figures/{paper}/figures.json" for paper in papers]


def architecture(suffix="svg"):
    """Return the pictures of the project itself, or their data with suffix csv."""
    return [f"results/figures/architecture/figure-{name}.{suffix}" for name in ("rules", "modules")]


def corrigenda_of(*papers):
    """Return what can be sent to the authors of papers."""
    return [f"results/corrigenda/{paper}.pdf" for paper in papers]


def papers_of(chapter):
    """Return the papers that a chapter tells: its own, or all for a chapter about all."""
    return [chapter] if chapter in settings.papers else list(settings.papers)


def told_in(chapter):
    """Return the papers and topics whose figures a chapter may show."""
    return [chapter] if chapter in settings.papers else list(settings.told)


def code_of(chapter):
    """Return the source files of what a chapter imports from the package."""
    text = Path("notebooks", f"{chapter}.md").read_text(encoding="utf-8")
    return package(*re.findall(r"^from omniproof\.([\w.]+) import", text, re.MULTILINE))


def printed_in(chapter):
    """Return what the papers print that a chapter tells, or holds its own formulas against."""
    text = Path("notebooks", f"{chapter}.md").read_text(encoding="utf-8")
    papers = dict.fromkeys(re.findall(r'\b(?:printed|Chapter\.open)\("([a-z0-9-]+)"', text))
    return [file for paper in papers for file in paper_data(paper)]


def recordings_of(*models):
    """Return what is recorded of models, and their numbers, for the pictures that show them."""
    return [
        f"results/simulation/{model}/{file}.csv"
        for model in models
        for file in (*filter(can_run, settings.simulation[model]), "summary")
    ]


def simulated(*models):
    """Return all that is recorded of models, measured and timed."""
    return [
        *recordings_of(*models),
        *(f"results/benchmarks/simulation/{model}.csv" for model in models),
        "results/simulation/summary.csv",
    ]


def mutation_of(chapter):
    """Return the study of planted misprints, for the chapter that shows it."""
    return ["results/mutation.json"] if chapter == "method" else []


def simulation_of(chapter):
    """Return the numbers of the simulations, for the chapter that shows them."""
    return ["results/simulation/summary.csv"] if chapter == "simulation" else []


def architecture_of(chapter):
    """Return the pictures of the project itself, for the chapter that shows them."""
    return [*architecture(), *abouts_of("architecture")] if chapter == "maintainers" else []


def heads_of(chapter):
    """Return the files whose heads say what the parts are for, for the chapter that lists them."""
    if chapter != "maintainers":
        return []
    package, rules = Path("workflow/omniproof"), Path("workflow/rules")
    files = [*package.glob("*.py"), *package.glob("*/__init__.py"), *rules.glob("*.smk")]
    return sorted(map(str, files))


def reported(kind, paper, numbers, files):
    """Enter the tables or figures of a paper in Snakemake's report, with caption and labels."""

    def entry(number, file):
        return report(
            file,
            caption=f"../report/{kind}.rst",
            category=f"{kind.capitalize()}s",
            labels={"paper": paper, kind: str(number)},
        )

    return list(map(entry, numbers, files))


def book_sources():
    """Return the hand-written files of the report."""
    files = (file for file in Path("book").rglob("*") if file.is_file())
    return sorted(str(file) for file in files if not {"_build", "__pycache__"} & set(file.parts))
