"""What mechanics implies at each claim of the paper, in the order of its sections.

Importing this package fills `REGISTRY`; each module binds the claims of its part.
"""

from omniproof.papers.three_roller_sphere.derivations import (
    elimination,
    introduction,
    optimum,
    premises,
    simulation,
)
from omniproof.papers.three_roller_sphere.derivations.quantities import REGISTRY

__all__ = ["REGISTRY", "elimination", "introduction", "optimum", "premises", "simulation"]
