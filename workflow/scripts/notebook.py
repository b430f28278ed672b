"""Run one chapter of the report."""

from pathlib import Path

from omniproof.report.notebook import execute
from omniproof.report.step import step

with step(snakemake) as output:
    execute(Path(snakemake.input.source), output.chapter)
