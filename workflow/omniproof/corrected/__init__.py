"""What the papers ought to say, to calculate with: one module a paper, one function a formula.

>>> from omniproof.corrected import ballbot
>>> ballbot.wheel_matrix(phi=0.7, L=0.1).shape
(3, 3)

Every function is bound to the claim that it stands in for, and is generated from the derivation by
which that claim was judged. Formulas that are right as printed have none.
"""

from __future__ import annotations

from collections.abc import Mapping

from omniproof.corrected import ballbot, omni_arrangement, omni_trajectory, two_roller_sphere
from omniproof.corrected.answer import Answers
from omniproof.corrected.formula import Functions

__all__ = [
    "ANSWERS",
    "FUNCTIONS",
    "ballbot",
    "omni_arrangement",
    "omni_trajectory",
    "two_roller_sphere",
]

FUNCTIONS: Mapping[str, Functions] = {
    "omni-arrangement": omni_arrangement.FUNCTIONS,
    "omni-trajectory": omni_trajectory.FUNCTIONS,
    "ballbot": ballbot.FUNCTIONS,
    "two-roller-sphere": two_roller_sphere.FUNCTIONS,
    "three-roller-sphere": {},
}
"""Paper -> claim -> the function to use instead of what is printed there.

The paper on three rollers has no false formula, so it has no function.
"""

ANSWERS: Mapping[str, Answers] = {
    "ballbot": ballbot.ANSWERS,
    "omni-arrangement": omni_arrangement.ANSWERS,
    "omni-trajectory": omni_trajectory.ANSWERS,
    "two-roller-sphere": two_roller_sphere.ANSWERS,
}
"""Paper -> equation -> how its parts stand together; of others, they stand one after the other."""
