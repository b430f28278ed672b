"""Typeset a corrigendum of every paper."""

from pathlib import Path

from omniproof.audit.ledger import read_json
from omniproof.report.corrigendum import corrigendum
from omniproof.report.corrigendum_pdf import pdf
from omniproof.report.fragments.overview import read_edition
from omniproof.report.step import step

with step(snakemake) as output:
    for path, file in zip(snakemake.input.ledgers, output.pdfs, strict=True):
        ledger = read_json(Path(path))
        edition = read_edition(Path("paper_data") / ledger.paper)
        file.write_bytes(pdf(corrigendum(ledger, edition)))
