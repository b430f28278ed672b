"""A paper of one page with every kind of claim and every verdict, and what is derived for it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from sympy import (
    Abs,
    And,
    Expr,
    ImmutableMatrix,
    Integer,
    Or,
    Rational,
    Symbol,
    cos,
    gamma,
    pi,
    sin,
    symbols,
)

from omniproof.audit.ledger import Verdict
from omniproof.audit.readings import Read
from omniproof.registry import Convention, Modelled, Obligation, Registry, Relation
from omniproof.transcription.model import Form

x, y, t = symbols("x y t", real=True)
L = Symbol("L", positive=True)
SHORT, LONG = "the lever is 1", "the lever is L"

PAPER = r"""
key: tiny-paper
edition:
  title: On everything
  authors: [A. Writer]
  year: 2023
  venue: Journal 1(1)
  source: tiny-paper.txt
  sha256: 0000000000000000000000000000000000000000000000000000000000000000
symbols:
  - {latex: 'x', name: x, means: a number}
  - {latex: 'y', name: y, means: a number}
  - {latex: 'L', name: L, positive: true, means: a length}
  - {latex: 'f', name: f, role: quantity, of: 'x', means: a function}
  - {latex: 'M', name: M, role: quantity, means: a moment}
tables:
  - id: tab:2
    file: table-2.csv
    line: 50
    says: numbers
    units: {value: '1'}
claims:
  - {id: 'eq:1', kind: identity, line: 1, says: double angle, latex: '\sin 2x = 2 \sin x \cos x'}
  - id: eq:6
    kind: identity
    line: 2
    says: a matrix
    latex: '\begin{pmatrix} 1 & x & L \\ \cos x & 2 & \cos x + \sin y \end{pmatrix}'
  - {id: 'eq:7', kind: identity, line: 3, says: the entry again, latex: '\cos x + \sin y'}
  - {id: 'eq:8', kind: identity, line: 4, says: a distance, latex: 'x'}
  - {id: 'eq:9', kind: identity, line: 5, says: nonsense, latex: '3 x'}
  - {id: 'eq:10', kind: identity, line: 6, says: beyond us, latex: 'x'}
  - {id: 'eq:11', kind: identity, line: 7, says: the number y, latex: 'y'}
  - id: eq:16
    kind: identity
    line: 8
    says: a model
    latex: '\begin{pmatrix} x \\ y \\ 2 x \end{pmatrix}'
  - {id: 'eq:17', kind: identity, line: 9, says: a side, latex: '\cos x\,L'}
  - {id: 'eq:18', kind: identity, line: 9, says: a moment, latex: 'M = x^2'}
  - {id: 'sec:1/grows', kind: relation, line: 10, says: it grows, asserts: {form: increasing}}
  - {id: 'sec:1/shrinks', kind: relation, line: 11, says: it shrinks, asserts: {form: decreasing}}
  - {id: 'sec:1/same', kind: relation, line: 12, says: they agree, asserts: {form: equal}}
  - {id: 'sec:1/unproved', kind: relation, line: 13, says: they agree, asserts: {form: equal}}
  - {id: 'sec:1/modelled', kind: relation, line: 13, says: they agree, asserts: {form: equal}}
  - {id: 'sec:1/neither', kind: relation, line: 13, says: they agree, asserts: {form: equal}}
  - id: eq:12
    kind: relation
    line: 14
    says: signs agree
    latex: 'x y > 0'
    asserts: {form: equivalent}
  - id: eq:15
    kind: relation
    line: 14
    says: one sign is known
    latex: 'x y > 0'
    assumes: 'y > 30^\circ'
    asserts: {form: equivalent}
  - id: sec:1/acute
    kind: relation
    line: 15
    says: an acute triangle
    latex: '\{210^\circ, 270^\circ, 330^\circ\}'
    assumes: '0 < x < 90^\circ'
    asserts: {form: instance}
  - id: sec:1/angles
    kind: relation
    line: 15
    says: an isosceles triangle
    latex: '\{210^\circ, 270^\circ, 330^\circ\}'
    asserts: {form: instance}
  - id: sec:1/best
    kind: relation
    line: 16
    says: it is largest at 90 degrees
    asserts: {form: largest, member: b}
  - id: sec:2/frame
    kind: consistency
    line: 20
    says: name of the frame
    printed: '\Sigma'
    agrees_with: sec:3/frame
  - id: sec:3/frame
    kind: consistency
    line: 30
    says: name of the frame
    printed: '\Omega'
    agrees_with: [sec:2/frame, sec:4/frame]
  - id: sec:4/frame
    kind: consistency
    line: 31
    says: name of the frame
    printed: '\Omega'
    agrees_with: sec:3/frame
  - {id: 'eq:13', kind: identity, line: 13, says: a value, latex: 'f(2y)'}
  - {id: 'eq:14', kind: identity, line: 14, says: the function, latex: 'f(y)'}
  - {id: 'sec:2/symbol', kind: consistency, line: 21, says: x, printed: x, agrees_with: 'eq:1'}
  - {id: 'sec:2/other', kind: consistency, line: 22, says: y, printed: y, agrees_with: 'eq:1'}
  - id: sec:2/lever
    kind: consistency
    line: 23
    says: the lever is stated
    printed: lever
    agrees_with: app:A/lever
  - id: app:A/lever
    kind: consistency
    line: 60
    says: the appendix takes the lever as stated
    printed: its lever
    agrees_with: sec:2/lever
  - {id: 'eq:A.1', kind: identity, line: 61, says: first, latex: 'L x'}
  - {id: 'eq:A.2', kind: identity, line: 62, says: second, latex: 'L y'}
  - {id: 'eq:A.3', kind: identity, line: 63, says: third, latex: 'x y'}
  - {id: 'eq:A.4', kind: identity, line: 64, says: fourth, latex: 'L x'}
  - {id: 'eq:A.5', kind: identity, line: 65, says: fifth, latex: 'M = L x^2'}
  - {id: 'eq:A.6', kind: identity, line: 66, says: sixth, latex: 'y + y'}
  - {id: 'xref:sec-2-cites-eq-1', kind: reference, line: 24, says: x, target: 'eq:1', about: x}
  - {id: 'xref:sec-2-cites-eq-7', kind: reference, line: 25, says: L, target: 'eq:7', about: L}
  - {id: 'xref:sec-3-cites-eq-1', kind: reference, line: 32, says: y, target: 'eq:1', about: y}
  - {id: 'xref:sec-3-cites-eq-8', kind: reference, line: 33, says: a distance, target: 'eq:8'}
  - {id: 'xref:sec-3-cites-2', kind: reference, line: 34, says: a book}
  - {id: 'sec:3/noble', kind: editorial, line: 35, says: novel, quote: noble}
  - id: fig:1/shape
    kind: relation
    line: 36
    says: a hexagon
    source: doubtful
    uncheckable: figure-not-seen
    decided_by: Figure 1
"""
TABLE = """row,value
exact,4.00
rounded,3.14
tie,0.13
truncated,2.71
neighbour,3.13
wrong,5.00
count,4
"""
VALUES = {
    "exact": Integer(4),
    "rounded": pi,
    "tie": Rational(1, 8),
    "truncated": Rational(2718, 1000),
    "neighbour": pi,
    "wrong": pi,
    "count": Integer(3),
}
LEVERS = {"eq:A.1": x, "eq:A.2": y, "eq:A.3": x * y, "eq:A.4": y, "eq:A.5": x**2}
READINGS = {
    "xref:sec-3-cites-2": Read(verdict=Verdict.VERIFIED, reason="the title says so"),
    "sec:3/noble": Read(verdict=Verdict.EDITORIAL, reason="misspelt", correction="novel"),
}


def write(folder: Path) -> Path:
    """Write the paper into a folder."""
    folder.mkdir()
    (folder / "paper.yaml").write_text(PAPER.lstrip(), encoding="utf-8")
    (folder / "table-2.csv").write_text(TABLE, encoding="utf-8")
    return folder


def registry() -> Registry:
    """Return the derivations of the paper."""
    tiny = Registry("tiny-paper")
    tiny.quantities["f"] = lambda: sin(x)
    tiny.quantities["M"] = lambda: x**2
    tiny.conventions["app:A/lever"] = Convention(SHORT, (LONG,))
    for claim, value in _identities().items():
        rests_on = ["eq:6[2,3]"] if claim == "eq:11" else []
        tiny.derives(claim, rests_on=rests_on)(lambda value=value: value)
    for claim, relation in _relations().items():
        rests_on = ["sec:1/shrinks"] if claim == "sec:1/same" else []
        tiny.derives(claim, rests_on=rests_on)(lambda relation=relation: relation)
    for claim, factor in LEVERS.items():
        tiny.derives(claim, convention="app:A/lever")(
            lambda lever, factor=factor: factor * (L if lever == LONG else 1)
        )
    tiny.derives("eq:A.6", convention="app:A/lever")(lambda lever: 2 * y)
    for row, value in VALUES.items():
        tiny.derives(f"tab:2[{row},value]")(lambda value=value: value)
    return tiny


def _identities() -> dict[str, Any]:
    return {
        "eq:1": sin(2 * x),
        "eq:6": ImmutableMatrix([[1, x, L], [cos(x), 2, cos(x) - sin(y)]]),
        "eq:7": cos(x) - sin(y),
        "eq:8": Abs(x),
        "eq:9": sin(x) * cos(y),
        "eq:10": gamma(x),
        "eq:11": y,
        "eq:16": Modelled(
            ImmutableMatrix([x * cos(y), y, x * cos(y)]), ImmutableMatrix([x, y, x]), "it rests"
        ),
        "eq:13": sin(2 * y),
        "eq:14": sin(x),
        "eq:17": L * cos(x),
        "eq:18": x**2,
    }


def _relations() -> dict[str, Relation]:
    rising: tuple[Expr, ...] = (Integer(1), Integer(2), Integer(3))
    return {
        "sec:1/grows": Relation(rising),
        "sec:1/shrinks": Relation(
            rising, correction="it grows", proof=(Obligation(Form.INCREASING, rising),)
        ),
        "sec:1/same": Relation(
            (x, y), condition="x = y", proof=(Obligation(Form.EQUAL, (x - y, -(y - x))),)
        ),
        "sec:1/unproved": Relation(
            (x, y), correction="x = 2y", proof=(Obligation(Form.EQUAL, (x, 2 * y)),)
        ),
        "sec:1/modelled": Relation((x, y), correction="no", premises=(x + y, y + x)),
        "sec:1/neither": Relation((x, y), correction="no", premises=(x, 2 * y)),
        "eq:12": Relation(Or(And(x > 0, y > 0), And(x < 0, y < 0))),
        "eq:15": Relation(x > 0),
        "sec:1/acute": Relation((x, pi - x, 3 * pi / 2), correction="x = 210"),
        "sec:1/angles": Relation((t, pi - t, 3 * pi / 2)),
        "sec:1/best": Relation({"a": Integer(1), "b": Integer(2)}),
    }
