"""
This part of the workflow makes the tables of papers anew.

REQUIRED INPUTS:
    ledger = results/ledger/{paper}.json
    data   = paper_data/{paper}/*

OUTPUTS:
    tables = results/tables/{paper}/table-{number}.csv
"""

# One rule a paper, since papers differ in how many tables they have.
for paper, made in settings.papers.items():

    rule:
        """Make the tables of {params.paper}"""
        name:
            f"tables_{module_name(paper)}"
        input:
            ledger=f"results/ledger/{paper}.json",
            data=paper_data(paper),
            package=package("report.tables"),
        output:
            tables=reported("table", paper, made.tables, tables_of(paper)),
        params:
            paper=paper,
            numbers=made.tables,
        log:
            f"logs/tables/{paper}.log",
        benchmark:
            f"results/benchmarks/tables/{paper}.tsv"
        script:
            "../scripts/tables.py"
