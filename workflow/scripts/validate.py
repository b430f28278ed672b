"""Check the finished report against the ledgers."""

from pathlib import Path

from omniproof.audit.ledger import read_json
from omniproof.report.step import step
from omniproof.report.validate import validate_book

with step(snakemake) as output:
    ledgers = [read_json(Path(path)) for path in snakemake.input.ledgers]
    figures = map(Path, snakemake.input.figures)
    validate_book(Path(snakemake.input.index).parent, ledgers, figures)
    output.validation.write_text("valid\n")
