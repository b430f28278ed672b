"""What a paper prints against what its derivations, quantities and readings say of it."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from contextlib import suppress

from omniproof.transcription.faults import Fault, nearest, shorten
from omniproof.transcription.ids import base
from omniproof.transcription.loader import LoadedPaper
from omniproof.transcription.model import Claim, Kind, Role
from omniproof.transcription.symbols import symbol_name
from omniproof.transcription.tokens import LatexError

DERIVED = frozenset({Kind.IDENTITY, Kind.VALUE, Kind.RELATION})


def unmatched(
    loaded: LoadedPaper,
    derivation_ids: Collection[str],
    quantity_names: Collection[str],
    reading_ids: Collection[str] = (),
) -> list[Fault]:
    """List claims without derivation, derivations and readings without claim, bare quantities.

    A derivation is bound to a claim, to a whole of which the claim is a cell (`tab:2`), or to one
    entry of a claim (`eq:6[2,3]`).
    """
    return sorted(
        [
            *_underived(loaded, derivation_ids),
            *_without_claim(loaded, derivation_ids, "derivation"),
            *_quantities(loaded, quantity_names),
            *_readings(loaded, reading_ids),
            *_looked_for(loaded, reading_ids),
            *_without_claim(loaded, reading_ids, "reading"),
        ]
    )


def needs_derivation(claim: Claim) -> bool:
    """Whether a claim is judged against what mechanics implies."""
    return claim.kind in DERIVED and claim.uncheckable is None


def _underived(loaded: LoadedPaper, ids: Collection[str]) -> Iterator[Fault]:
    covered = {*ids, *(base(item) for item in ids)}
    for claim in loaded.claims:
        if needs_derivation(claim) and not {claim.id, base(claim.id)} & covered:
            message = f"expected a derivation for this {claim.kind}, found none"
            cure = (
                f'add a function with `@REGISTRY.derives("{claim.id}")` '
                f"to {_code(loaded)}, or say why it is `uncheckable`"
            )
            yield loaded.fault(claim.id, message, cure)


def _readings(loaded: LoadedPaper, ids: Collection[str]) -> Iterator[Fault]:
    """Editorial claims are read, and so are references whose target no program can look at."""
    for claim in loaded.claims:
        read = claim.kind is Kind.EDITORIAL or (
            claim.kind is Kind.REFERENCE and claim.target is None and claim.uncheckable is None
        )
        if read and claim.id not in ids:
            message = f"expected a reading of this {claim.kind}, found none"
            cure = f"add `{claim.id}` with its reason to {_folder(loaded)}/readings.yaml"
            yield loaded.fault(claim.id, message, cure)


def _looked_for(loaded: LoadedPaper, read: Collection[str]) -> Iterator[Fault]:
    """Find symbols that references are about and nobody declared: no place can show them."""
    for claim in loaded.claims:
        computed = claim.target and claim.id not in read and not claim.uncheckable
        if claim.kind is not Kind.REFERENCE or not claim.about or not computed:
            continue
        with suppress(LatexError):
            if symbol_name(claim.about) not in loaded.symbols:
                message = f"expected `about` to be a declared symbol, found {shorten(claim.about)}"
                latex = [symbol.latex for symbol in loaded.symbols.values()]
                cure = nearest(claim.about, latex, "declare it under `symbols`")
                yield loaded.fault(claim.id, message, cure)


def _without_claim(loaded: LoadedPaper, ids: Collection[str], kind: str) -> Iterator[Fault]:
    known = set(loaded.positions) | loaded.broken
    wholes = {base(claim) for claim in known}
    for item in ids:
        if item not in known | wholes and base(item) not in known:
            message = f"expected a claim for the {kind} `{item}`, found none"
            code = _code(loaded) if kind == "derivation" else f"{_folder(loaded)}/readings.yaml"
            cure = nearest(item, known | wholes, f"add the claim, or remove it from {code}")
            yield loaded.start.fault("", message, cure)


def _quantities(loaded: LoadedPaper, given: Collection[str]) -> Iterator[Fault]:
    roles = {symbol.name: symbol.role for symbol in loaded.symbols.values()}
    declared = {name for name, role in roles.items() if role is Role.QUANTITY}
    bare, free = declared - set(given), set(given) - declared
    for name in bare:
        message = f"expected a meaning of the quantity `{name}`, found none"
        add = f'add a function with `@REGISTRY.quantity("{name}")` to {_code(loaded)}'
        yield loaded.symbol_fault(name, "name", message, nearest(name, free, add))
    for name in free - loaded.broken:
        message = f"expected a symbol with `role: quantity` for the meaning `{name}`, found none"
        if name in roles:
            yield loaded.symbol_fault(name, "role", message, "write `role: quantity`")
        elif not nearest(name, bare):  # else it is a slip in that name, which is told
            yield loaded.start.fault("", message, "declare it under `symbols`")


def _folder(loaded: LoadedPaper) -> str:
    return f"papers/{loaded.paper.key.replace('-', '_')}"


def _code(loaded: LoadedPaper) -> str:
    return f"{_folder(loaded)}/derivations.py"
