"""Integrals of functions that nobody knows: wheel speeds over time, say.

No engine knows an undefined function. But what is claimed of any continuous functions holds for all
of them exactly when it holds for free symbols in their place, in two cases:

* integrals up to a time that are linear in the functions: values and integrals of a function are
  independent of each other, so each integral of a function is a symbol of its own;
* c * integral of F = d * integral of G from the same place up to the time: differentiate. If the
  upper limit is fixed, F and G may contain nothing but values of the functions: constant functions
  then tell F from G. So each side becomes the integrand times one symbol for both limits.

Everything else is refused; by parts, the integral of t f(t) would look different from itself. What
is refused and false is left to `audit.counterexample`.
"""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from omniproof.formula.errors import UnsupportedError

__all__ = ["flattened", "without_integrals"]


def without_integrals(left: Any, right: Any) -> tuple[Any, Any]:
    """Write two sides without functions and integrals, equal exactly where they are equal.

    Raises `UnsupportedError` for integrals of other forms.
    """
    sides = [_reduced(side) for side in (left, right)]
    if len({range_ for _, range_ in sides}) > 1:
        raise UnsupportedError("integrals over different ranges are not compared")
    return sides[0][0], sides[1][0]


def flattened(value: Any) -> Any:
    """Write every integral as its integrand times the length of its range, for a first look.

    That is what constant functions would give, so where only functions change, what is equal stays
    so; what becomes equal need not be.
    """
    if not _is_of_functions(value):
        return value
    value = value.replace(sp.Integral, _of_constants)
    functions = value.atoms(AppliedUndef)
    return value.xreplace({f: sp.Symbol(str(f.func), real=True) for f in functions})


def _of_constants(integrand: sp.Expr, *limits: Any) -> sp.Expr:
    return integrand * sp.Mul(*(upper - lower for _, lower, upper in limits))


def _is_of_functions(value: Any) -> bool:
    return isinstance(value, sp.Expr) and value.has(sp.Integral, AppliedUndef)


def _reduced(value: Any) -> tuple[Any, Any]:
    """Write one side in symbols; the range of its integral, if one is left, beside it."""
    if not _is_of_functions(value):
        return value, None
    while linear := [part for part in value.atoms(sp.Integral) if _linear(part) is not None]:
        value = value.xreplace({part: _linear(part) for part in linear})
    if not value.has(sp.Integral):
        return _plain(value), None
    terms = [_term(term) for term in sp.Add.make_args(value)]
    if len({range_ for _, range_ in terms}) > 1:
        raise UnsupportedError("a sum of integrals is compared where all have the same limits")
    return sp.Add(*(term for term, _ in terms)), terms[0][1]


def _linear(integral: sp.Integral) -> sp.Expr | None:
    """Integrate a sum of constant multiples of functions; None for any other integrand."""
    (variable, lower, upper), *outer = integral.limits
    if outer:  # SymPy writes an integral of an integral as one
        inner = _linear(sp.Integral(integral.function, integral.limits[0]))
        return None if inner is None else _linear(sp.Integral(inner, *outer))
    functions = sorted(integral.function.atoms(AppliedUndef), key=str)
    symbols = {f: sp.Dummy() for f in functions if f.has(variable)}
    form = sp.expand(integral.function.xreplace(symbols))
    slopes = {f: form.coeff(symbol) for f, symbol in symbols.items()}
    rest = sp.expand(form - sum(slope * symbols[f] for f, slope in slopes.items()))
    if any(part.has(variable, *symbols.values(), sp.Integral) for part in (rest, *slopes.values())):
        return None
    # The integral up to a time is a function of that time, too: no constant in an integral over it.
    named = (
        slope * sp.Function(f"int_{f.func}_from_{lower}", real=True)(upper)
        for f, slope in slopes.items()
    )
    return sp.Add(rest * (upper - lower), *named)


def _term(term: sp.Expr) -> tuple[sp.Expr, Any]:
    """Write a constant times an integral; the range of the integral beside it."""
    integrals = [part for part in sp.Mul.make_args(term) if isinstance(part, sp.Integral)]
    if len(integrals) != 1 or len(integrals[0].limits) != 1:
        raise UnsupportedError("an integral is compared as a term with a constant factor")
    (integral,) = integrals
    ((variable, lower, upper),) = integral.limits
    factor, integrand = term / integral, integral.function
    if factor.has(sp.Integral, AppliedUndef, variable) or integrand.has(sp.Integral):
        raise UnsupportedError("an integral is compared as a term with a constant factor")
    values = _plain(integrand)
    names = {symbol.name for symbol in values.free_symbols}
    if upper != variable and (variable.name in names or any(n.startswith("int_") for n in names)):
        raise UnsupportedError("an integral up to a fixed time is compared by values alone")
    return factor * values * sp.Symbol(f"d{variable}", real=True), (variable, lower, upper)


def _plain(value: sp.Expr) -> sp.Expr:
    """Put a symbol for each function."""
    functions = value.atoms(AppliedUndef)
    return value.xreplace({f: sp.Symbol(str(f), real=True) for f in functions})
