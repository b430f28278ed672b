"""Run a chapter: a Markdown notebook in, an executed notebook out, the same bytes every time.

Run from a script and not by Snakemake's `notebook:`, whose output holds absolute paths and times.
"""

from __future__ import annotations

import os
import re
import sys
import tempfile
from pathlib import Path
from typing import Any

import jupytext
import nbformat
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError

SECONDS = 120
COLOUR = re.compile(r"\x1b\[[0-9;]*m")


class ChapterError(Exception):
    """A cell of a chapter failed."""


def execute(source: Path, output: Path, folder: Path = Path()) -> None:
    """Run the notebook `source` (MyST Markdown) in `folder` and write it with its outputs.

    Cells get the ids `cell-1`, `cell-2`, …; no times and no version of Python are recorded. What a
    cell prints to standard error is printed here, and is no part of the page.

    Raises `ChapterError` with the number and the first line of the cell that failed.
    """
    notebook = jupytext.read(source)
    for number, cell in enumerate(notebook.cells, start=1):
        cell.id = f"cell-{number}"
    with tempfile.TemporaryDirectory(prefix="ipython-") as profile:
        client = NotebookClient(
            notebook,
            timeout=SECONDS,
            kernel_name="python3",
            record_timing=False,
            resources={"metadata": {"path": str(folder)}},
        )
        try:
            client.execute(env=os.environ | {"IPYTHONDIR": profile})
        except CellExecutionError as error:
            raise ChapterError(
                _where(notebook, source) + f": {error.ename}: {error.evalue}"
            ) from error
    _take_out_talk(notebook)
    notebook.metadata.get("language_info", {}).pop("version", None)
    nbformat.write(notebook, output)


def _where(notebook: Any, source: Path) -> str:
    """Name the cell that failed: the last one with an error among its outputs."""
    for number, cell in enumerate(notebook.cells, start=1):
        if any(out.output_type == "error" for out in cell.get("outputs", ())):
            return f"{source}, cell {number} ({cell.source.strip().splitlines()[0]})"
    return str(source)


def _take_out_talk(notebook: Any) -> None:
    for cell in notebook.cells:
        outputs = cell.get("outputs", [])
        talk = [out for out in outputs if out.get("name") == "stderr"]
        for out in talk:
            print(COLOUR.sub("", out.text), file=sys.stderr)
        if talk:
            cell.outputs = [out for out in outputs if out not in talk]
