"""Plant misprints in what is verified, and see what becomes of them."""

from omniproof.audit.mutation import study, write_study
from omniproof.report.step import step

with step(snakemake) as output:
    params = snakemake.params
    write_study(study(params.papers, params.sample, params.seed), output.study)
