"""
This part of the workflow typesets what can be sent to the authors of each paper.

REQUIRED INPUTS:
    ledgers = results/ledger/{paper}.json
    data    = paper_data/{paper}/paper.yaml
    layout  = workflow/omniproof/report/corrigendum.typ

OUTPUTS:
    pdfs = results/corrigenda/{paper}.pdf
"""


# One step for all papers: they are typeset faster than a step starts.
rule corrigendum:
    """Typeset a corrigendum of every paper"""
    input:
        ledgers=ledgers_of(*settings.papers),
        data=[f"paper_data/{paper}/paper.yaml" for paper in settings.papers],
        layout="workflow/omniproof/report/corrigendum.typ",
        package=package("report.corrigendum_pdf", "report.fragments.overview"),
    output:
        pdfs=corrigenda_of(*settings.papers),
    log:
        "logs/corrigendum.log",
    benchmark:
        "results/benchmarks/corrigendum.tsv"
    script:
        "../scripts/corrigendum.py"
