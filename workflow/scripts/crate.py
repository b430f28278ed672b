"""Record what the report was made from, by what, and its checksums."""

from pathlib import Path

from omniproof.report.crate import Run, crate, versions
from omniproof.report.fragments.overview import read_edition
from omniproof.report.revision import Revision
from omniproof.report.step import step

with step(snakemake) as output:
    made_by = snakemake.input
    asked_for = [Path(file).read_text(encoding="utf-8") for file in made_by.packages]
    run = Run(
        revision=Revision(snakemake.params.commit, snakemake.params.date),
        packages=versions("\n".join(asked_for)),
        inputs=tuple(map(Path, [*made_by.data, made_by.config, *made_by.locks])),
        papers={key: read_edition(Path("paper_data") / key) for key in snakemake.params.papers},
    )
    output.crate.write_text(crate(Path(made_by.index).parent, run), encoding="utf-8")
