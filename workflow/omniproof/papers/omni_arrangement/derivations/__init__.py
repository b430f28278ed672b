"""What mechanics implies at each claim of the paper, in the order of its sections.

Importing this package fills `REGISTRY`; each module binds the claims of its part.
"""

from omniproof.papers.omni_arrangement.derivations import (
    appendices,
    evaluation,
    introduction,
    kinematics,
    simulation,
)
from omniproof.papers.omni_arrangement.derivations.quantities import REGISTRY

__all__ = ["REGISTRY", "appendices", "evaluation", "introduction", "kinematics", "simulation"]
