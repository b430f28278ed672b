"""The systems that are compared, each asked one question in a process of its own, with a time-out.

A fresh fork for each question: nobody profits from what another row left in a cache, and a system
that hangs is stopped. All start from the same two SymPy expressions. Each process first makes the
memory of its parent its own and answers something easy, so that neither the copying of memory after
a fork nor imports are counted: a page is copied when it is first written to, and Python writes to
whatever it looks at. Seconds are those of the processor, which a busy machine hardly changes.
A system that only rewrites says `proved` when the difference becomes 0, and `refuted` when it does
not, although that proves nothing: counted in its favour where the record is false.
"""

from __future__ import annotations

import ctypes
import gc
import multiprocessing
import time
from collections.abc import Callable
from dataclasses import dataclass
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

import symengine  # type: ignore[import-untyped]
import sympy as sp
from questions import Question, decision, verdict

from omniproof.decide.in_sympy.domain import Domain

POPULATE_WRITE = 23  # MADV_POPULATE_WRITE of Linux
CAN_OWN = ctypes.CDLL(None).madvise(None, ctypes.c_size_t(0), POPULATE_WRITE) == 0
"""Whether a process can ask for pages of its own (Linux 5.14); else copying is counted, for all."""
TIME_OUT = 5.0
"""Seconds by the clock for one row, after which a system is stopped."""


@dataclass(frozen=True)
class Timed:
    """What a system said, and the seconds that it took."""

    said: str
    seconds: float


def _rewriting(is_zero: Callable[[sp.Expr, sp.Expr], Any]) -> Callable[[Question], str]:
    def answer(question: Question) -> str:
        said = [is_zero(left, right) for left, right in question.pairs]
        if all(said):
            return "proved"
        return "undecided" if None in said and False not in said else "refuted"

    return answer


def _symengine(left: sp.Expr, right: sp.Expr) -> bool:
    return bool(symengine.expand(symengine.sympify(left) - symengine.sympify(right)) == 0)


SYSTEMS: dict[str, Callable[[Question], str]] = {
    "flint": lambda question: verdict(question, decision(question)),
    "confirmed": lambda question: verdict(question, decision(question, confirmed=True)),
    "simplify": _rewriting(lambda left, right: bool(sp.simplify(left - right) == 0)),
    "trigsimp": _rewriting(lambda left, right: bool(sp.trigsimp(left - right) == 0)),
    "equals": _rewriting(lambda left, right: left.equals(right)),
    "symengine": _rewriting(_symengine),
}
"""By the name of the column; the first two are ours."""
OURS = ("flint", "confirmed")
ANGLE = sp.Symbol("angle", real=True)
EASY = Question(((sp.sin(ANGLE) ** 2 + sp.cos(ANGLE) ** 2, sp.S.One),), "=", Domain(), (ANGLE,))


def timed(system: str, question: Question, time_out: float = TIME_OUT) -> Timed:
    """Ask one system one question; says `time-out` or `error` where there is no answer."""
    context = multiprocessing.get_context("fork")
    receiver, sender = context.Pipe(duplex=False)
    process = context.Process(target=_ask, args=(sender, system, question))
    gc.freeze()
    process.start()
    sender.close()
    try:
        return receiver.recv() if receiver.poll(time_out) else Timed("time-out", time_out)
    except EOFError:
        return Timed("error", time_out)
    finally:
        process.kill()
        process.join()


def own_memory() -> None:
    """Copy all memory that a fork still shares with its parent."""
    for line in Path("/proc/self/maps").read_text().splitlines() if CAN_OWN else ():
        addresses, rights, *_ = line.split()
        if rights == "rw-p":
            start, end = (int(address, 16) for address in addresses.split("-"))
            size = ctypes.c_size_t(end - start)
            ctypes.CDLL(None).madvise(ctypes.c_void_p(start), size, POPULATE_WRITE)


def _ask(sender: Connection, system: str, question: Question) -> None:
    start = time.process_time()
    try:
        own_memory()
        SYSTEMS[system](EASY)
        start = time.process_time()
        said = SYSTEMS[system](question)
    except Exception as error:
        said = f"error: {type(error).__name__}"
    sender.send(Timed(said, time.process_time() - start))
