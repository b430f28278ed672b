"""
This part of the workflow judges what papers print.

REQUIRED INPUTS:
    data        = paper_data/{paper}/*
    readings    = workflow/omniproof/papers/{paper}/readings.yaml
    derivations = workflow/omniproof/papers/{paper}/derivations*
    papers      = workflow/omniproof/papers/{paper}/theorems*

OUTPUTS:
    ledger   = results/ledger/{paper}.json
    table    = results/ledger.csv
    theorems = results/theorems.json
"""


rule audit:
    """Audit {wildcards.paper}"""
    input:
        data=lambda wildcards: paper_data(wildcards.paper),
        readings=lambda wildcards: readings_of(wildcards.paper),
        derivations=lambda wildcards: paper_module(wildcards.paper, "derivations"),
        package=package("audit.run", "audit.ledger"),
    output:
        ledger="results/ledger/{paper}.json",
    log:
        "logs/audit/{paper}.log",
    benchmark:
        "results/benchmarks/audit/{paper}.tsv"
    script:
        "../scripts/audit.py"


rule ledger:
    """Write the ledger of all papers"""
    input:
        ledgers=ledgers_of(*settings.papers),
        package=package("audit.ledger"),
    output:
        table=report(
            "results/ledger.csv",
            caption="../report/ledger.rst",
            category="Ledger",
            labels={"what": "one row per printed cell"},
        ),
    log:
        "logs/ledger.log",
    benchmark:
        "results/benchmarks/ledger.tsv"
    script:
        "../scripts/ledger.py"


rule theorems:
    """Prove what no paper prints"""
    input:
        papers=theorems_of(*settings.told),
        package=package("audit.theorems"),
    output:
        theorems=report(
            "results/theorems.json",
            caption="../report/theorems.rst",
            category="Ledger",
            labels={"what": "theorems"},
        ),
    params:
        papers=list(settings.told),
    log:
        "logs/theorems.log",
    benchmark:
        "results/benchmarks/theorems.tsv"
    script:
        "../scripts/theorems.py"
