"""Section 2.2, by algebra: the least value of a quadratic form, its coefficients free.

Each coefficient is a lemma of its own (`optimum`), so that ten free symbols stand for thirteen
here. Eliminating x and then y gives the coefficients D and E; the optimum is that of the three
normal equations at once, and not of the elimination.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

from sympy import Expr, ImmutableMatrix, Poly, cancel, diff, hessian

from omniproof.papers.three_roller_sphere.derivations.quantities import COEFFICIENTS, REGISTRY
from omniproof.papers.three_roller_sphere.symbols import POINT

X, Y, Z = POINT
MONOMIALS = {1: X**2, 2: Y**2, 3: Z**2, 4: X * Y, 5: Y * Z, 6: X * Z, 7: X, 8: Y, 9: Z, 10: X**0}
"""Monomials of a quadratic form in the paper's order."""


@cache
def form(eliminated: int = 0) -> Expr:
    """Quadratic form, least over the first coordinates that are eliminated."""
    if eliminated == 0:
        return sum(COEFFICIENTS[k] * monomial for k, monomial in MONOMIALS.items())
    before, variable = form(eliminated - 1), POINT[eliminated - 1]
    polynomial = Poly(diff(before, variable), variable)
    rate, rest = polynomial.coeff_monomial(variable), polynomial.coeff_monomial(1)
    return before.subs(variable, -rest / rate)


@cache
def coefficient(k: int, eliminated: int) -> Expr:
    """Coefficient of the k-th monomial in what elimination leaves."""
    left = Poly(form(eliminated), *POINT)
    return cancel(left.coeff_monomial(MONOMIALS[k]))


@cache
def optimum() -> ImmutableMatrix:
    """Point without slope: 3x1."""
    curvature = ImmutableMatrix(hessian(form(), POINT))
    slope = ImmutableMatrix([diff(form(), variable) for variable in POINT])
    at_origin = slope.subs(dict.fromkeys(POINT, 0))
    solved = curvature.adjugate(method="berkowitz") * at_origin
    return ImmutableMatrix(-solved / curvature.det(method="berkowitz"))


def meanings() -> Mapping[str, Any]:
    """Free coefficients, and what follows for the printed names."""
    found: dict[str, Any] = {f"C_{k}": symbol for k, symbol in COEFFICIENTS.items()}
    found |= {f"D_{k}": coefficient(k, 1) for k in (2, 3, 5, 8, 9, 10)}
    found |= {f"E_{k}": coefficient(k, 2) for k in (3, 9, 10)}
    return found | {f"{axis}_0": optimum()[k] for k, axis in enumerate("xyz")}


def _bind(claim: str, name: str) -> None:
    REGISTRY.derives(claim, meanings=meanings)(lambda: meanings()[name])


for _k in (2, 3, 5, 8, 9, 10):
    REGISTRY.quantity(f"D_{_k}")(lambda k=_k: coefficient(k, 1))
    _bind(f"eq:9/d-{_k}", f"D_{_k}")
for _k in (3, 9, 10):
    REGISTRY.quantity(f"E_{_k}")(lambda k=_k: coefficient(k, 2))
    _bind(f"eq:8/e-{_k}", f"E_{_k}")
for _axis in "xyz":
    _bind(f"eq:7/{_axis}-0", f"{_axis}_0")
