"""What a failed step or a killed build leaves behind, and how the next build copes with it.

Snakemake removes the outputs of a step before it runs, and again when it fails. So a build first
copies the earlier results of all steps that it will run, and afterwards puts those back that were
not made anew. They are marked as incomplete: the next build tries again. (Snakemake's `update()`
puts an output back as well, but takes it for up to date from then on.)
"""

from __future__ import annotations

import shutil
from collections.abc import Iterable
from pathlib import Path

EARLIER = Path(".snakemake", "earlier")


def keep(files: Iterable[str]) -> None:
    """Copy results that are about to be made anew."""
    for file in map(Path, files):
        if file.exists():
            (EARLIER / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(file, EARLIER / file)


def put_back(files: Iterable[str]) -> None:
    """Put kept results back where there are none now."""
    for file in map(Path, files):
        if (EARLIER / file).exists() and not file.exists():
            file.parent.mkdir(parents=True, exist_ok=True)
            (EARLIER / file).replace(file)


def forget() -> None:
    """Remove what was kept: everything was made anew."""
    shutil.rmtree(EARLIER, ignore_errors=True)


def sweep(prefix: str, *folders: str) -> None:
    """Remove what killed steps left: folders of this prefix, anywhere in the given ones."""
    for folder in folders:
        for part in [*Path(folder).rglob(f"{prefix}*")]:
            shutil.rmtree(part, ignore_errors=True)


def list_files(folder: Path, listing: Path) -> None:
    """Write the names of all files in a folder, for `is_whole`."""
    names = sorted(str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file())
    listing.write_text("\n".join(names), encoding="utf-8")


def is_whole(folder: Path, listing: Path) -> bool:
    """Whether all files that were listed are there; without a listing nothing is known to lack."""
    if not listing.exists():
        return True
    names = listing.read_text(encoding="utf-8").splitlines()
    return all((folder / name).exists() for name in names)
