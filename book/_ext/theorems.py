"""Theorems of sphinx-proof, made fit for a page with several of them.

sphinx-proof numbers theorems and lets pages refer to them. It also gives one and the same id to
every statement and every proof, which HTML forbids; and a proof is open, where these unfold.
"""

from __future__ import annotations

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.writers.html5 import HTML5Translator
from sphinx_proof.nodes import proof_node

WORD = "Proof. "
"""What the directive writes before the first line of a proof; the heading has it already."""


def tidy(app: Sphinx, document: nodes.document) -> None:
    """Take off the ids that recur, and the word that the heading of a proof says."""
    for statement in [*document.findall(nodes.section)]:  # a list: they are replaced on the way
        if "proof-content" in statement["ids"]:
            content = nodes.container("", *statement.children, classes=statement["classes"])
            statement.parent.replace(statement, content)  # `replace_self` would keep the id
    for proof in document.findall(proof_node):
        (frame,) = proof.children
        proof.children = frame.children
        for child in proof.children:
            child.parent = proof
        first = next(proof.findall(nodes.Text))
        first.parent.replace(first, nodes.Text(first.removeprefix(WORD)))


def visit_proof(translator: HTML5Translator, node: nodes.Element) -> None:
    """Open what unfolds; it needs no script."""
    translator.body.append('<details class="proof"><summary>Proof</summary>\n')


def depart_proof(translator: HTML5Translator, node: nodes.Element) -> None:
    """Close it."""
    translator.body.append("</details>\n")


def setup(app: Sphinx) -> dict[str, bool]:
    """Register with Sphinx."""
    app.setup_extension("sphinx_proof")
    app.add_node(proof_node, override=True, html=(visit_proof, depart_proof))
    app.connect("doctree-read", tidy)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
