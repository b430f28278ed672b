"""
This part of the workflow records what the report was made from, by what, and its checksums.

REQUIRED INPUTS:
    index    = book/_build/html/index.html
    data     = paper_data/{paper}/*
    config   = workflow/config.yaml
    packages = requirements*.in
    locks    = requirements*.lock

OUTPUTS:
    crate = book/_build/html/ro-crate-metadata.json
"""

revision = read_revision(Path())


rule crate:
    """Record inputs, versions and checksums"""
    input:
        index="book/_build/html/index.html",
        data=[file for paper in settings.papers for file in paper_data(paper)],
        config="workflow/config.yaml",
        packages=["requirements.in", "requirements-engines.in"],
        locks=["requirements.lock", "requirements-engines.lock"],
        package=package("report.crate", "report.revision", "report.fragments.overview"),
    output:
        crate="book/_build/html/ro-crate-metadata.json",
    params:
        commit=revision.commit,
        date=revision.date,
        papers=list(settings.papers),
    log:
        "logs/crate.log",
    benchmark:
        "results/benchmarks/crate.tsv"
    script:
        "../scripts/crate.py"
