"""Run the cases of one model."""

from omniproof.report.step import step
from omniproof.simulation.files import write_model

with step(snakemake) as output:
    params = snakemake.params
    recordings = dict(zip(params.cases, output.recordings, strict=True))
    write_model(params.model, recordings, output.numbers, output.times)
