"""Stage the sources of the report and set it."""

from pathlib import Path

from omniproof.report.book import build, stage
from omniproof.report.step import step

with step(snakemake):
    html = Path(snakemake.output.index).parent
    source = html.parent / "source"
    stage(Path("book"), Path("results"), Path("paper_data"), source)
    build(source, html)
