"""
This part of the workflow runs the chapters of the report.

REQUIRED INPUTS:
    source     = notebooks/{chapter}.md
    printed    = paper_data/{paper}/*
    ledgers    = results/ledger/{paper}.json
    theorems   = results/theorems.json
    mutation   = results/mutation.json
    simulation = results/simulation/summary.csv
    tables     = results/tables/{paper}/table-{number}.csv
    figures    = results/figures/{paper}/figure-{number}.svg
    abouts     = results/figures/{paper}/figures.json
    architecture = results/figures/architecture/*
    heads      = workflow/*

OUTPUTS:
    chapter = results/notebooks/{chapter}.ipynb
"""


rule notebook:
    """Run the chapter {wildcards.chapter}"""
    input:
        source="notebooks/{chapter}.md",
        printed=lambda wildcards: printed_in(wildcards.chapter),
        ledgers=lambda wildcards: ledgers_of(*papers_of(wildcards.chapter)),
        theorems="results/theorems.json",
        mutation=lambda wildcards: mutation_of(wildcards.chapter),
        simulation=lambda wildcards: simulation_of(wildcards.chapter),
        tables=lambda wildcards: tables_of(*papers_of(wildcards.chapter)),
        figures=lambda wildcards: figures_of(*told_in(wildcards.chapter)),
        abouts=lambda wildcards: abouts_of(*told_in(wildcards.chapter)),
        architecture=lambda wildcards: architecture_of(wildcards.chapter),
        heads=lambda wildcards: heads_of(wildcards.chapter),
        package=lambda wildcards: [*package("report.notebook"), *code_of(wildcards.chapter)],
    output:
        chapter="results/notebooks/{chapter}.ipynb",
    log:
        "logs/notebook/{chapter}.log",
    benchmark:
        "results/benchmarks/notebook/{chapter}.tsv"
    script:
        "../scripts/notebook.py"
