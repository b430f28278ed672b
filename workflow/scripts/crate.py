"""Record what the report was made from, by what, and its checksums."""

from pathlib import Path

from omniproof.report.crate import Run, crate, versions
from omniproof.report.fragments.overview import read_edition
from omniproof.report.revision import Revision
from omniproof.report.step import step

with step(snakemake) as output:
    made_by = snakemake.input
    run = Run(
        revision=Revision(snakemake.params.commit, snakemake.params.date),
        packages=versions("\n".join(map(Path.read_text, map(Path, made_by.packages)))),
        inputs=tuple(map(Path, [*made_by.data, made_by.config, *made_by.locks])),
        papers={key: read_edition(Path("paper_data") / key) for key in snakemake.params.papers},
    )
    output.crate.write_text(crate(Path(made_by.index).parent, run), encoding="utf-8")
