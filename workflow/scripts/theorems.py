"""Prove the results that no paper prints."""

from omniproof.audit.theorems import prove_all, write_theorems
from omniproof.report.step import step

with step(snakemake) as output:
    write_theorems(prove_all(snakemake.params.papers), output.theorems)
