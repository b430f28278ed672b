"""Check the transcription of one paper; stop with all its faults."""

import json
from pathlib import Path

from omniproof.audit.run import check_paper
from omniproof.report.step import step

with step(snakemake) as output:
    facts = check_paper(Path("paper_data") / snakemake.wildcards.paper)
    output.checked.write_text(json.dumps(facts, indent=1, sort_keys=True) + "\n")
