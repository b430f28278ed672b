"""What mechanics implies at each claim of the paper, in the order of its sections.

Importing this package fills `REGISTRY`; each module binds the claims of its part.
"""

from omniproof.papers.ballbot.derivations import introduction, motion, structure, wheels
from omniproof.papers.ballbot.derivations.quantities import REGISTRY

__all__ = ["REGISTRY", "introduction", "motion", "structure", "wheels"]
