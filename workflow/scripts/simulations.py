"""Join the numbers of all simulations in one table."""

from pathlib import Path

from omniproof.report.step import step
from omniproof.simulation.files import write_summary

with step(snakemake) as output:
    write_summary(map(Path, snakemake.input.numbers), output.summary)
