"""Typeset the corrigendum of one paper."""

from pathlib import Path

from omniproof.audit.ledger import read_json
from omniproof.report.corrigendum import corrigendum
from omniproof.report.corrigendum_pdf import pdf
from omniproof.report.fragments.overview import read_edition
from omniproof.report.step import step

with step(snakemake) as output:
    ledger = read_json(Path(snakemake.input.ledger))
    edition = read_edition(Path("paper_data") / snakemake.wildcards.paper)
    output.pdf.write_bytes(pdf(corrigendum(ledger, edition)))
