"""Signs of exact numbers: balls at rising precision, and the normal form where they meet zero."""

from __future__ import annotations

from omniproof.decide.balls import enclose, format_ball, sign_of
from omniproof.decide.normal_form.form import normal_form
from omniproof.formula.errors import UnsupportedError
from omniproof.formula.term import Term

PRECISIONS = (64, 256, 1_024, 4_096)


def sign(number: Term) -> int:
    """Return the certain sign -1, 0 or 1 of an exact real number.

    Raises `UnsupportedError` when it is not finite, or when its being zero cannot be proved.
    """
    for precision in PRECISIONS:
        ball = enclose(number, precision=precision)
        certain = sign_of(ball)
        if certain is not None:
            return certain
        if precision == PRECISIONS[1]:
            if not ball.is_finite():
                raise UnsupportedError("it is not a finite real number")
            if normal_form(number).is_zero:
                return 0
    raise UnsupportedError(f"{format_ball(ball)} is too small for its sign to be told")
