"""Make the tables of one paper anew."""

from pathlib import Path

from omniproof.report.step import step
from omniproof.report.tables import write_tables

with step(snakemake) as output:
    write_tables(
        Path("paper_data") / snakemake.params.paper,
        Path(snakemake.input.ledger),
        dict(zip(snakemake.params.numbers, output.tables, strict=True)),
    )
