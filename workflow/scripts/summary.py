"""Write the summary that `make` closes with."""

from pathlib import Path

from omniproof.audit.ledger import read_json
from omniproof.audit.theorems import read_theorems
from omniproof.report.step import step
from omniproof.report.summary import summary

with step(snakemake) as output:
    ledgers = [read_json(Path(path)) for path in snakemake.input.ledgers]
    text = summary(ledgers, read_theorems(Path(snakemake.input.theorems)))
    output.summary.write_text(text, encoding="utf-8")
