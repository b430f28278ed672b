"""
This part of the workflow makes the report of what was found, and checks it.

REQUIRED INPUTS:
    pages    = book/*
    citation = CITATION.cff
    chapters = results/notebooks/{chapter}.ipynb
    ledgers  = results/ledger/{paper}.json
    printed  = paper_data/{paper}/*
    table    = results/ledger.csv
    theorems = results/theorems.json
    tables   = results/tables/{paper}/table-{number}.csv
    figures  = results/figures/{paper}/figure-{number}.svg
    data     = results/figures/{paper}/figure-{number}.csv
    corrigenda = results/corrigenda/{paper}.pdf
    printed  = paper_data/{paper}/*
    crate    = book/_build/html/ro-crate-metadata.json

OUTPUTS:
    index      = book/_build/html/index.html
    validation = results/validation.txt
    summary    = results/summary.txt
"""


rule book:
    """Set the report"""
    input:
        pages=book_sources(),
        citation="CITATION.cff",
        chapters=expand("results/notebooks/{chapter}.ipynb", chapter=settings.chapters),
        ledgers=ledgers_of(*settings.papers),
        table="results/ledger.csv",
        theorems="results/theorems.json",
        tables=tables_of(*settings.papers),
        figures=[*figures_of(*settings.told), *architecture()],
        data=[*figures_of(*settings.told, suffix="csv"), *architecture(suffix="csv")],
        corrigenda=corrigenda_of(*settings.papers),
        printed=[file for paper in settings.papers for file in paper_data(paper)],
        package=package("report.book"),
    output:
        index="book/_build/html/index.html",
    log:
        "logs/book.log",
    benchmark:
        "results/benchmarks/book.tsv"
    script:
        "../scripts/book.py"


rule validate:
    """Check the report: anchors, figures, references"""
    input:
        index="book/_build/html/index.html",
        crate="book/_build/html/ro-crate-metadata.json",
        ledgers=ledgers_of(*settings.papers),
        printed=[file for paper in settings.papers for file in paper_data(paper)],
        figures=[*figures_of(*settings.told), *architecture()],
        package=package("report.validate"),
    output:
        validation="results/validation.txt",
    log:
        "logs/validate.log",
    benchmark:
        "results/benchmarks/validate.tsv"
    script:
        "../scripts/validate.py"


rule summary:
    """Sum up"""
    input:
        ledgers=ledgers_of(*settings.papers),
        theorems="results/theorems.json",
        validation="results/validation.txt",
        package=package("report.summary"),
    output:
        summary="results/summary.txt",
    log:
        "logs/summary.log",
    benchmark:
        "results/benchmarks/summary.tsv"
    script:
        "../scripts/summary.py"
