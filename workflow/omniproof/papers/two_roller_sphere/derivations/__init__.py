"""What mechanics implies at each claim of the paper, in the order of its sections.

Importing this package fills `REGISTRY`; each module binds the claims of its part.
"""

from omniproof.papers.two_roller_sphere.derivations import (
    appendices,
    kinematics,
    rollers,
    simulation,
    slip,
)
from omniproof.papers.two_roller_sphere.derivations.quantities import REGISTRY

__all__ = ["REGISTRY", "appendices", "kinematics", "rollers", "simulation", "slip"]
