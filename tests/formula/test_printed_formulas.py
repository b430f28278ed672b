"""Every formula of the five papers, written in every way, is still the same formula."""

from __future__ import annotations

import random
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp
from mpmath import mp
from test_code_writers import close, pasted

from omniproof.decide import digits
from omniproof.formula import writers
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.writers.identifiers import identifier
from omniproof.report.shown import shown
from omniproof.transcription import tree
from omniproof.transcription.checking import known_names
from omniproof.transcription.loader import LoadedPaper, load_paper
from omniproof.transcription.reader import read_with

PAPERS = sorted(Path("paper_data").iterdir())


@cache
def paper(folder: Path) -> LoadedPaper:
    return load_paper(folder)


@pytest.mark.parametrize("folder", PAPERS, ids=lambda folder: folder.name)
def test_latex_reads_back_as_the_same_tree(folder: Path) -> None:
    loaded = paper(folder)
    names = known_names(loaded.symbols)
    for claim, node in loaded.trees.items():
        text = writers.latex(node)
        assert read_with(text, loaded.paper.notation, names) == node, claim


@pytest.mark.parametrize("folder", PAPERS, ids=lambda folder: folder.name)
def test_every_formula_can_be_shown(folder: Path) -> None:
    texts = {claim.id: claim.printed for claim in paper(folder).claims}
    for claim in paper(folder).trees:
        row = shown(str(texts[claim]))
        assert row, claim
        assert "\\" not in writers.text(row), claim


def sides(folder: Path) -> Iterator[tree.Node]:
    for node in paper(folder).trees.values():
        chain = isinstance(node, tree.Chain) and node.relation == "="
        yield from node.sides if isinstance(node, tree.Chain) and chain else (node,)


def place(name: str) -> sp.Rational:
    """A number that is all a symbol's own."""
    return sp.Rational(random.Random(name).randint(100, 2_900), 1_013)


def expected(node: tree.Node) -> list[Any] | None:
    """Evaluate to 60 digits with a number for each symbol; nothing where there is no value."""
    try:
        with mp.workdps(60):
            found = digits.value(node, lambda symbol, _: mp.mpf(place(symbol.name)))
    except digits.UndefinedError:
        return None
    return list(found) if isinstance(found, mp.matrix) else [found]


@pytest.mark.parametrize("folder", PAPERS, ids=lambda folder: folder.name)
def test_code_has_the_value_that_is_printed(folder: Path) -> None:
    tried = 0
    for node in sides(folder):
        value = expected(node)
        if value is None or any(isinstance(x, tree.Applied) for x in tree.walk(node)):
            continue
        points = {identifier(name): place(name) for name in tree.names(node)}
        try:
            numpy, sympy = writers.numpy(node), writers.sympy(node)
        except UnsupportedError:
            continue
        tried += 1
        with np.errstate(all="ignore"):
            found = pasted(numpy, **{name: float(x) for name, x in points.items()})
        assert close(found, value, digits=8), numpy
        assert close(pasted(sympy, **points), value, digits=45), sympy
    assert tried > 20
