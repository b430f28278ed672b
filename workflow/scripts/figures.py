"""Draw the figures of one paper."""

from pathlib import Path

from omniproof.report.drawing import write_figures
from omniproof.report.step import step

with step(snakemake) as output:
    write_figures(snakemake.params.paper, output.abouts[0].parent, Path("results"))
