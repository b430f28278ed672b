"""All theorems that concern several papers, in the order in which the chapter tells them."""

from omniproof.papers.one_mechanics import friction, platforms, rollers
from omniproof.registry import Theorem

THEOREMS: tuple[Theorem, ...] = (*rollers.THEOREMS, *platforms.THEOREMS, *friction.THEOREMS)
