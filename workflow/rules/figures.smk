"""
This part of the workflow draws the figures of papers and topics from computed data.

REQUIRED INPUTS:
    drawings   = workflow/omniproof/papers/{paper}/figures*
    printed    = paper_data/{paper}/*
    recordings = results/simulation/{model}/{case}.csv

OUTPUTS:
    pictures = results/figures/{paper}/figure-{number}.svg
    data     = results/figures/{paper}/figure-{number}.csv
    abouts   = results/figures/{paper}/figures.json
"""

# One rule each, since papers and topics differ in how many figures they have.
for paper, made in settings.told.items():

    rule:
        """Draw the figures of {params.paper}"""
        name:
            f"figures_{module_name(paper)}"
        input:
            drawings=paper_module(paper, "figures"),
            printed=paper_data(paper) if paper in settings.papers else [],
            recordings=recordings_of(*made.models),
            package=package("report.drawing"),
        output:
            pictures=reported("figure", paper, made.pictures, figures_of(paper)),
            data=figures_of(paper, suffix="csv"),
            abouts=abouts_of(paper),
        params:
            paper=paper,
        log:
            f"logs/figures/{paper}.log",
        benchmark:
            f"results/benchmarks/figures/{paper}.tsv"
        script:
            "../scripts/figures.py"
