"""
This part of the workflow typesets what can be sent to the authors of each paper.

REQUIRED INPUTS:
    ledger = results/ledger/{paper}.json
    data   = paper_data/{paper}/*
    layout = workflow/omniproof/report/corrigendum.typ

OUTPUTS:
    pdf = results/corrigenda/{paper}.pdf
"""


rule corrigendum:
    """Typeset the corrigendum of {wildcards.paper}"""
    input:
        ledger="results/ledger/{paper}.json",
        data=lambda wildcards: paper_data(wildcards.paper),
        layout="workflow/omniproof/report/corrigendum.typ",
        package=package("report.corrigendum_pdf", "report.fragments.overview"),
    output:
        pdf="results/corrigenda/{paper}.pdf",
    log:
        "logs/corrigendum/{paper}.log",
    benchmark:
        "results/benchmarks/corrigendum/{paper}.tsv"
    script:
        "../scripts/corrigendum.py"
