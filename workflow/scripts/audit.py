"""Judge one paper."""

from pathlib import Path

from omniproof.audit.ledger import write_json
from omniproof.audit.run import audit_paper
from omniproof.report.step import step

with step(snakemake) as output:
    write_json(audit_paper(Path("paper_data") / snakemake.wildcards.paper), output.ledger)
