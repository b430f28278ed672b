"""A derived integral over time, evaluated from samples: for speeds that were measured or simulated.

The integrals stay unevaluated in a derivation, because any speeds may stand in them. The
trapezoidal rule suits samples: it asks for nothing between them, and for no equal steps.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike
from sympy import Integral, Symbol, lambdify
from sympy.core.function import AppliedUndef

from omniproof.corrected.formula import Array, Formula


def running_integral(time: Array, values: Array) -> Array:
    """Return the integral of `values` from the first time up to each: all `(n,)`."""
    steps = np.diff(time) * (values[1:] + values[:-1]) / 2
    return np.concatenate([np.zeros(1), np.cumsum(steps)])


def sampled_integral(
    formula: Formula, time: ArrayLike, functions: Mapping[str, ArrayLike], **constants: float
) -> Array:
    """Evaluate a claim that is an integral over time, from samples of the functions in it.

    time: `(n,)`, increasing, in s; functions: name -> samples `(n,)`; constants: the other symbols.
    Returns the value up to each time, `(n,)`, with an error of the order of the steps squared.
    """
    at = np.asarray(time, dtype=float)
    samples = {name: np.asarray(values, dtype=float) for name, values in functions.items()}
    integrand = formula.expression.function
    inner = {part: Symbol(f"integral_of_{_function(part)}") for part in integrand.atoms(Integral)}
    known: dict[str, Any] = samples | constants
    known |= {str(own): running_integral(at, samples[_function(x)]) for x, own in inner.items()}
    bare = integrand.xreplace(inner)
    bare = bare.xreplace({value: Symbol(_function(value)) for value in bare.atoms(AppliedUndef)})
    names = sorted(map(str, bare.free_symbols))
    values = lambdify(names, bare, "numpy")(*(known[name] for name in names))
    return running_integral(at, values)


def _function(part: Any) -> str:
    """Return the name of the one unknown function in an expression."""
    (applied,) = part.atoms(AppliedUndef)
    return str(applied.func)
