"""Claims against derivations, quantities and readings."""

from __future__ import annotations

import pytest

from omniproof.transcription.loader import LoadedPaper
from omniproof.transcription.matching import unmatched

DERIVED = ["sec:1/wheels", "eq:1", "eq:2", "tab:2", "sec:2/smallest"]
QUANTITIES = ["q", "p"]
READ = ["sec:2/spelling"]


def without(items: list[str], item: str) -> list[str]:
    return [other for other in items if other != item]


MATCHES = [
    pytest.param(DERIVED, QUANTITIES, READ, [], id="all there"),
    pytest.param([*without(DERIVED, "tab:2"), "tab:2[X,D_V]", "tab:2[X,D_A]"], QUANTITIES, READ,
                 [], id="cells one by one"),
    pytest.param([*without(DERIVED, "eq:1"), "eq:1[1]", "eq:1[2]"], QUANTITIES, READ,
                 [], id="entries of a claim"),
    pytest.param(without(DERIVED, "eq:1"), QUANTITIES, READ, [
        "paper.yaml:14:10: claims[eq:1]: expected a derivation for this identity, found none",
        '    add a function with `@REGISTRY.derives("eq:1")` to papers/on_wheels/derivations.py, '
        "or say why it is `uncheckable`"], id="claim without derivation"),
    pytest.param(without(DERIVED, "tab:2"), QUANTITIES, READ, [
        "table-2.csv:2:3: claims[tab:2[X,D_V]]: expected a derivation for this value, found none",
        '    add a function with `@REGISTRY.derives("tab:2[X,D_V]")` to '
        "papers/on_wheels/derivations.py, or say why it is `uncheckable`",
        "table-2.csv:2:8: claims[tab:2[X,D_A]]: expected a derivation for this value, found none",
        '    add a function with `@REGISTRY.derives("tab:2[X,D_A]")` to '
        "papers/on_wheels/derivations.py, or say why it is `uncheckable`"], id="bare table"),
    pytest.param([*DERIVED, "sec:2/smalest"], QUANTITIES, READ, [
        "paper.yaml:1:1: expected a claim for the derivation `sec:2/smalest`, found none",
        "    did you mean `sec:2/smallest`?"], id="derivation without claim"),
    pytest.param([*DERIVED, "fig:7"], QUANTITIES, READ, [
        "paper.yaml:1:1: expected a claim for the derivation `fig:7`, found none",
        "    add the claim, or remove it from papers/on_wheels/derivations.py"],
        id="derivation like no claim"),
    pytest.param(DERIVED, ["q"], READ, [
        "paper.yaml:8:24: symbols[p].name: expected a meaning of the quantity `p`, found none",
        '    add a function with `@REGISTRY.quantity("p")` to papers/on_wheels/derivations.py'],
        id="quantity without meaning"),
    pytest.param(DERIVED, ["q", "pp"], READ, [
        "paper.yaml:8:24: symbols[p].name: expected a meaning of the quantity `p`, found none",
        "    did you mean `pp`?"], id="quantity misspelt"),
    pytest.param(DERIVED, [*QUANTITIES, "L"], READ, [
        "paper.yaml:5:5: symbols[L].role: expected a symbol with `role: quantity` for the meaning "
        "`L`, found none", "    write `role: quantity`"], id="meaning of a variable"),
    pytest.param(DERIVED, [*QUANTITIES, "M"], READ, [
        "paper.yaml:1:1: expected a symbol with `role: quantity` for the meaning `M`, found none",
        "    declare it under `symbols`"], id="meaning of no symbol"),
    pytest.param(DERIVED, QUANTITIES, [], [
        "paper.yaml:16:10: claims[sec:2/spelling]: expected a reading of this editorial, "
        "found none",
        "    add `sec:2/spelling` with its reason to papers/on_wheels/readings.yaml"],
        id="editorial without reading"),
    pytest.param(DERIVED, QUANTITIES, [*READ, "eq:9"], [
        "paper.yaml:1:1: expected a claim for the reading `eq:9`, found none",
        "    did you mean `eq:2`?"], id="reading without claim"),
]  # fmt: skip


@pytest.mark.parametrize(("derived", "quantities", "read", "lines"), MATCHES)
def test_unmatched(
    loaded: LoadedPaper,
    derived: list[str],
    quantities: list[str],
    read: list[str],
    lines: list[str],
) -> None:
    faults = unmatched(loaded, derived, quantities, read)
    assert "\n".join(map(str, faults)).splitlines() == lines
