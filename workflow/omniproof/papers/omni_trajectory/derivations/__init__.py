"""What mechanics implies at each claim of the paper, in the order of its sections.

Importing this package fills `REGISTRY`; each module binds the claims of its part.
"""

from omniproof.papers.omni_trajectory.derivations import (
    introduction,
    kinematics,
    simulation,
    trajectory,
)
from omniproof.papers.omni_trajectory.derivations.quantities import REGISTRY

__all__ = ["REGISTRY", "introduction", "kinematics", "simulation", "trajectory"]
