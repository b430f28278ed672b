"""
From what papers print to a validated report: the whole build on one page.

    snakemake                                   everything
    snakemake results/ledger/PAPER.json         one ledger; tables, figures and chapters likewise
    snakemake --report results/report.html      what was made, with captions
"""

from snakemake.utils import min_version

min_version("9.0")


# Reads and checks workflow/config.yaml.
include: "workflow/rules/common.smk"
include: "workflow/rules/audit.smk"
include: "workflow/rules/mutation.smk"
include: "workflow/rules/simulation.smk"
include: "workflow/rules/tables.smk"
include: "workflow/rules/figures.smk"
include: "workflow/rules/architecture.smk"
include: "workflow/rules/notebooks.smk"
include: "workflow/rules/corrigenda.smk"
include: "workflow/rules/book.smk"
include: "workflow/rules/crate.smk"
include: "workflow/rules/recovery.smk"


rule all:
    """Build everything that the report shows, and the report: all outputs of all rules."""
    default_target: True
    input:
        ledgers=ledgers_of(*settings.papers),
        ledger="results/ledger.csv",
        theorems="results/theorems.json",
        mutation="results/mutation.json",
        simulation=simulated(*settings.simulation),
        tables=tables_of(*settings.papers),
        figures=[*figures_of(*settings.told), *architecture()],
        data=[*figures_of(*settings.told, suffix="csv"), *architecture(suffix="csv")],
        abouts=abouts_of(*settings.told, "architecture"),
        chapters=expand("results/notebooks/{chapter}.ipynb", chapter=settings.chapters),
        corrigenda=corrigenda_of(*settings.papers),
        book="book/_build/html/index.html",
        crate="book/_build/html/ro-crate-metadata.json",
        validation="results/validation.txt",
        summary="results/summary.txt",


# The docstring of a rule is its progress line. Software: the locked environment, for every rule.
for step in workflow.rules:
    step.message = step.docstring
    step.conda_env = lambda wildcards: None
