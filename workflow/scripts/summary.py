"""Write the summary that `make` closes with."""

import json
from pathlib import Path

from omniproof.audit.ledger import read_json
from omniproof.report.step import step
from omniproof.report.summary import summary

with step(snakemake) as output:
    ledgers = [read_json(Path(path)) for path in snakemake.input.ledgers]
    theorems = json.loads(Path(snakemake.input.theorems).read_text(encoding="utf-8"))
    output.summary.write_text(summary(ledgers, theorems), encoding="utf-8")
