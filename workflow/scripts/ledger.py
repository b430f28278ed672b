"""Join the ledgers of all papers in one table."""

from pathlib import Path

from omniproof.audit.ledger import read_json, write_csv
from omniproof.report.step import step

with step(snakemake) as output:
    write_csv([read_json(Path(path)) for path in snakemake.input.ledgers], output.table)
