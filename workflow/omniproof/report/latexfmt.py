r"""What the ledger holds in LaTeX, made fit for a page (MathJax) and for a terminal (Unicode).

A ledger cell is LaTeX, a decimal, or words with `$math$` in them. The text comes from outside, so
it is escaped, and LaTeX that MathJax could not set (a fragment with an open bracket) or should not
(commands that make links or macros) is shown as code: ugly, but never an error on the page.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from html import escape

from omniproof.formula.writers import text as unicode
from omniproof.report.shown import shown
from omniproof.transcription.model import ID

_COMMAND = re.compile(r"\\[A-Za-z]+")
_TEXT = re.compile(
    r"[_^]\{[A-Za-z]+\}|\\(?:text|mathrm|mathbf|textbf|operatorname|begin|end)\s*\{[^{}]*\}"
)
_FORBIDDEN = re.compile(
    r"\\(?:href|url|require|def|let|newcommand|renewcommand|newenvironment|class|style|cssId|data"
    r"|unicode|bbox|includegraphics|[()\[\]])(?![A-Za-z])|(?<!\\)[%#$]"
)
_ENVIRONMENT = re.compile(r"\\(begin|end)\s*\{([A-Za-z]+\*?)\}")
TAG = re.compile(r"\\tag\*?\s*\{[^{}]*\}|\\label\s*\{[^{}]*\}")
CLAIM = re.compile(r"\b(?:eq|tab|fig|sec|app|xref):[A-Za-z0-9](?:[\w./#-]*\w)?(?:\[[\w,]+\])?")
PIECE = re.compile(rf"\$([^$]+)\$|`([^`]+)`|({CLAIM.pattern})")
_WORDS = re.compile(r"\\text\{([^{}]*[A-Za-z]{2,} [^{}]*)\}")


def is_latex(text: str) -> bool:
    """Whether a cell is one formula, rather than words (which may hold `$math$`)."""
    if "$" in text or not text.strip():
        return False
    bare = _COMMAND.sub(" ", _TEXT.sub(" ", text))
    words = re.findall(r"[A-Za-z]{3,}|[A-Z][a-z]+\. ", bare)
    marked = "\\" in text or re.search(r"[\^_{}=<>|+*/()-]|\d", text) is not None
    return not words and (marked or len(text.split()) == 1)


def is_settable(latex: str) -> bool:
    """Whether MathJax can set this: brackets, environments and delimiters all close."""
    if _FORBIDDEN.search(latex):
        return False
    open_names: list[str] = []
    for which, name in _ENVIRONMENT.findall(latex):
        if which == "begin":
            open_names.append(name)
        elif not open_names or open_names.pop() != name:
            return False
    sides = [len(re.findall(rf"\\{side}(?![A-Za-z])", latex)) for side in ("left", "right")]
    return not open_names and sides[0] == sides[1] and _braces_close(latex)


def _braces_close(latex: str) -> bool:
    depth = 0
    for brace in re.findall(r"(?<!\\)(?:\\\\)*([{}])", latex):
        depth += 1 if brace == "{" else -1
        if depth < 0:
            return False
    return depth == 0


def math(latex: str, *, display: bool = False) -> str:
    r"""Return HTML that MathJax sets, a span of class `math` around `\(...\)`; at worst, code.

    `display`: the large style, in a box of its own that scrolls when it is too wide.
    """
    body = TAG.sub("", latex).strip()
    if not is_settable(body):
        return f"<code>{escape(latex)}</code>"
    outside = re.sub(r"\\begin\{(\w+\*?)\}.*\\end\{\1\}", "", body, flags=re.DOTALL)
    if re.search(r"(?<!\\)&|\\\\", outside):
        body = rf"\begin{{aligned}}{body}\end{{aligned}}"
    if display:
        return f'<span class="math display notranslate nohighlight">\\[{escape(body)}\\]</span>'
    return f'<span class="math notranslate nohighlight">\\({escape(body)}\\)</span>'


def inline(text: str, refer: Callable[[str], str] = escape) -> str:
    """Return HTML of words with `$math$` and `code` in them; everything else is escaped.

    `refer`: makes HTML of a claim id that the words mention.
    """
    parts: list[str] = []
    end = 0
    for piece in PIECE.finditer(text):
        latex, code, claim = piece.groups()
        parts.append(escape(text[end : piece.start()]))
        if claim:
            parts.append(refer(claim))
        else:
            parts.append(formula(latex) if latex else f"<code>{escape(code)}</code>")
        end = piece.end()
    return "".join([*parts, escape(text[end:])])


def cell(text: str, refer: Callable[[str], str] = escape) -> str:
    """Return HTML of a ledger cell: a formula, a decimal, or words (see `inline`)."""
    if ID.fullmatch(text) or not is_latex(text):
        return inline(text, refer)
    return formula(text)


def formula(latex: str) -> str:
    r"""Return HTML of a formula; `A \text{ holds where } B` becomes words that can break a line.

    Words inside braces or environments stay where they are.
    """
    pieces: list[str] = []
    end = 0
    for words in _WORDS.finditer(latex):
        before = latex[end : words.start()]
        if is_settable(before):
            pieces += [math(before) if before.strip() else "", escape(words[1])]
            end = words.end()
    rest = latex[end:]
    return "".join([*pieces, math(rest) if rest.strip() else ""])


def same(latex: str, other: str) -> bool:
    """Whether two formulas differ at most in braces, spaces, alignment and a left side."""
    one, two = (re.sub(r"[{}\s&]|\\left(?![a-z])|\\right(?![a-z])", "", x) for x in (latex, other))
    return bool(one) and (one == two or one.endswith("=" + two))


def plain(text: str) -> str:
    r"""Return a cell as Unicode for a terminal: `\alpha_1^2` becomes `α₁²`.

    A formula that cannot be read stays as it is.
    """
    row = shown(text) if is_latex(text) else None
    if row is not None:
        return unicode(row)

    def piece(found: re.Match[str]) -> str:
        return plain(found[1]) if found[1] else found[2] or found[3]

    return " ".join(PIECE.sub(piece, text).split())
