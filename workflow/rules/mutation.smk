"""
This part of the workflow measures the audit by misprints that are planted in what is verified.

REQUIRED INPUTS:
    data        = paper_data/{paper}/*
    readings    = workflow/omniproof/papers/{paper}/readings.yaml
    derivations = workflow/omniproof/papers/{paper}/derivations*

OUTPUTS:
    study = results/mutation.json
"""


rule mutation:
    """Plant misprints"""
    input:
        data=[file for paper in settings.papers for file in paper_data(paper)],
        readings=[file for paper in settings.papers for file in readings_of(paper)],
        derivations=[
            file for paper in settings.papers for file in paper_module(paper, "derivations")
        ],
        package=package("audit.mutation"),
    output:
        study="results/mutation.json",
    params:
        papers=list(settings.papers),
        sample=settings.mutation.mutants,
        seed=settings.mutation.seed,
    log:
        "logs/mutation.log",
    benchmark:
        "results/benchmarks/mutation.tsv"
    script:
        "../scripts/mutation.py"
