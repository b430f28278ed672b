"""Other repairs of a formula, which the ledger names in the note: taken out, to be folded away.

A sum with a wrong sign can be mended at every one of its factors. One repair is enough to show what
is wrong; a reader who wants them all unfolds them.
"""

from __future__ import annotations

import re

_OTHERS = re.compile(r"(?:^|(?<=\s))or (\$[^$]+\$(?:, or \$[^$]+\$)*)\.?\s*$")


def alternatives(note: str) -> tuple[str, tuple[str, ...]]:
    """Return a note without the repairs at its end (`or $a$, or $b$`), and these as LaTeX."""
    found = _OTHERS.search(note)
    if found is None:
        return note, ()
    return note[: found.start()].rstrip(), tuple(re.findall(r"\$([^$]+)\$", found[1]))
