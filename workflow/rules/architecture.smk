"""
This part of the workflow draws the project itself: its rules, and who imports whom.

REQUIRED INPUTS:
    snakefile = Snakefile
    config    = workflow/config.yaml
    rules     = workflow/rules/*

OUTPUTS:
    pictures = results/figures/architecture/figure-{name}.svg
    data     = results/figures/architecture/figure-{name}.csv
    abouts   = results/figures/architecture/figures.json
"""

from omniproof.report.architecture import import_graph
from omniproof.sources import PACKAGE


rule architecture:
    """Draw the architecture"""
    input:
        snakefile="Snakefile",
        config="workflow/config.yaml",
        rules=sorted(map(str, Path("workflow/rules").glob("*.smk"))),
        package=package("report.architecture_figures", "report.drawing"),
    output:
        pictures=architecture(),
        data=architecture(suffix="csv"),
        abouts=abouts_of("architecture"),
    params:
        # Not all files of the package: an edit that imports nothing new changes no picture.
        imports=sorted(import_graph(PACKAGE).arrows),
    log:
        "logs/architecture.log",
    benchmark:
        "results/benchmarks/architecture.tsv"
    script:
        "../scripts/architecture.py"
