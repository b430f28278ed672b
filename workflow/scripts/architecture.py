"""Draw the rules and the modules of the project."""

from pathlib import Path

from omniproof.report.architecture_figures import drawings
from omniproof.report.drawing import write_drawings
from omniproof.report.step import step

with step(snakemake) as output:
    write_drawings(drawings(Path()), "architecture", output.abouts[0].parent, Path("results"))
