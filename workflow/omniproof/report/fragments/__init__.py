r"""What a notebook shows: each call returns one `Fragment` of finished, deterministic HTML.

Raw HTML is the format, because a claim needs an element with its own address, which Markdown
cannot promise. Formulas are `\(...\)` inside class `math`, which Jupyter sets, too; in the book
they are MathML (`omniproof.report.finish`).
"""

from omniproof.report.fragments.base import Fragment
from omniproof.report.fragments.chapter import Chapter
from omniproof.report.fragments.coverage import Coverage
from omniproof.report.fragments.mutation import Mutation
from omniproof.report.fragments.overview import Overview
from omniproof.report.fragments.topic import Topic
from omniproof.report.fragments.values import in_text

__all__ = ["Chapter", "Coverage", "Fragment", "Mutation", "Overview", "Topic", "in_text"]
