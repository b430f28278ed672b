"""One small paper and its source text, for what works on loaded papers."""

from __future__ import annotations

from hashlib import sha256
from pathlib import Path

import pytest

from omniproof.transcription.loader import LoadedPaper, load_paper

SOURCE = r"""# On wheels

The contact   points of all three
wheels [1] lie on a circle. See Eq. (2) and Figures 1(a) and 2.

$$q = L \cos \alpha_1 \quad (1)$$

$$p = L + 2
L \quad (2)$$

	$D_V$	$D_A$
Type (X)	3.08	4.00

As $L \leq 30^\circ$, Type (X) has the smallest value 3.08.
"""
PAPER = r"""key: on-wheels
edition:
  {{title: On wheels, authors: [A], year: 2023, venue: J, source: on-wheels.txt, sha256: {digest}}}
symbols:
  - {{latex: 'L', name: L, means: a radius}}
  - {{latex: '\alpha_1', name: alpha_1, means: an angle}}
  - {{latex: 'q', name: q, role: quantity, means: a point}}
  - {{latex: 'p', name: p, role: quantity, means: a point}}
tables:
  - {{id: tab:2, file: table-2.csv, line: 12, says: values, units: {{D_V: m}}}}
claims:
  - {{id: sec:1/wheels, kind: value, line: 3, says: number of wheels, printed: '3', unit: '1'}}
  - {{id: xref:sec-1-cites-eq-2, kind: reference, line: 4, says: points, target: eq:2}}
  - {{id: eq:1, kind: identity, line: 6, says: a point, latex: 'q = L \cos \alpha_1'}}
  - {{id: eq:2, kind: identity, line: 8, says: a point, latex: ['p =', '2 L']}}
  - {{id: sec:2/spelling, kind: editorial, line: 3, says: odd, quote: 'points of all three wheels'}}
  - {{id: sec:2/name, kind: consistency, line: 14, says: x, printed: 'Type (X)', agrees_with: eq:1}}
  - id: sec:2/smallest
    kind: relation
    line: 14
    says: X is least
    asserts: {{form: smallest, member: X}}
  - {{id: sec:2/opinion, kind: relation, line: 14, says: good, uncheckable: opinion, decided_by: x}}
"""


def write_folder(folder: Path, source: str = SOURCE) -> Path:
    """Write the paper for a source text into a folder."""
    digest = sha256(source.encode()).hexdigest()
    (folder / "paper.yaml").write_text(PAPER.format(digest=digest), encoding="utf-8")
    (folder / "table-2.csv").write_text("type,D_V,D_A\nX,3.08,4.00\n", encoding="utf-8")
    return folder


@pytest.fixture
def loaded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> LoadedPaper:
    """The paper that belongs to `SOURCE`; messages name `paper.yaml` alone."""
    monkeypatch.chdir(tmp_path)
    return load_paper(write_folder(tmp_path))


@pytest.fixture
def source() -> str:
    """The source text of the paper."""
    return SOURCE
