r"""What the ledger holds in LaTeX, made fit for a page (MathML) and for a terminal (Unicode).

A ledger cell is LaTeX, a decimal, or words with `$math$` in them. The text comes from outside, so
it is escaped, and LaTeX that could not be set (a fragment with an open bracket) or should not
(commands that make links or macros) is shown as code: ugly, but never an error on the page.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from html import escape

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
    """Whether this can be set: brackets, environments and delimiters all close."""
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
    r"""Return HTML of a formula, a span of class `math` around `\(...\)`; at worst, code.

    It is set when the pages are finished.
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


_NAMES = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau "
    "upsilon phi chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Phi Psi Omega"
)
GREEK = dict(zip(_NAMES.split(), "αβγδεζηθικλμνξπρστυφχψωΓΔΘΛΞΠΣΦΨΩ", strict=True))
_SIGNS = {
    r"\\leq?(?![a-z])": "≤",
    r"\\geq?(?![a-z])": "≥",
    r"\\neq?(?![a-z])": "≠",
    r"\\int(?:\\limits)?(?![a-z])": "∫",
    r"\\pm(?![a-z])": "±",
    r"\\cdot(?![a-z])": "·",
    r"\\times(?![a-z])": "×",
    r"\\(?:to|rightarrow)(?![a-z])": "→",
    r"\\Leftrightarrow(?![a-z])": "⇔",
    r"\^\{?\\circ\}?": "°",
    r"\\degree(?![a-z])": "°",
    r"\\in(?![a-z])": "∈",
    r"\\langle(?![a-z])": "⟨",
    r"\\rangle(?![a-z])": "⟩",
    r"\\dots|\\ldots|\\cdots": "…",
    r"\\\|": "‖",
    r"&": "",
    r"\\[{]": "{",
    r"\\[}]": "}",
}
_ACCENTS = {
    "dot": "\u0307",
    "hat": "\u0302",
    "tilde": "\u0303",
    "widetilde": "\u0303",
    "bar": "\u0304",
}
_SUPERSCRIPT = str.maketrans("0123456789+-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻")
_SUBSCRIPT = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_ARGUMENT = r"\{([^{}]*)\}"


def same(latex: str, other: str) -> bool:
    """Whether two formulas differ at most in braces, spaces, alignment and a left side."""
    one, two = (re.sub(r"[{}\s&]|\\left(?![a-z])|\\right(?![a-z])", "", x) for x in (latex, other))
    return bool(one) and (one == two or one.endswith("=" + two))


def plain(text: str) -> str:
    r"""Return LaTeX or mixed text as Unicode for a terminal: `\alpha_1^2` becomes `α₁²`."""
    text = re.sub(r"\\begin\{\w+\*?\}.*?\\end\{\w+\*?\}", "[…]", text, flags=re.DOTALL)
    for pattern, sign in _SIGNS.items():
        text = re.sub(pattern, sign, text)
    text = _COMMAND.sub(lambda found: GREEK.get(found[0][1:], found[0]), text)
    previous = ""
    while previous != text:
        previous, text = text, _flatten(text)
    text = re.sub(r"\\(?:left|right|quad|qquad|displaystyle)(?![A-Za-z])|\\[,;:! ]|[{}]", "", text)
    text = re.sub(r"\\([A-Za-z]+)", r"\1", text)
    return re.sub(r"\s+", " ", text.replace("$", "").replace("`", "").replace("\\", "")).strip()


def _flatten(text: str) -> str:
    """Undo one layer of braces."""
    text = re.sub(rf"\\[dt]?frac\s*{_ARGUMENT}\s*{_ARGUMENT}", _fraction, text)
    text = re.sub(rf"\\sqrt\s*{_ARGUMENT}", lambda m: "√" + _grouped(m[1]), text)
    text = re.sub(
        rf"\\(?:text|mathrm|mathbf|mathit|mathbb|mathcal|boldsymbol|operatorname|overline)\s*{_ARGUMENT}",
        r"\1",
        text,
    )
    text = re.sub(rf"\\({'|'.join(_ACCENTS)})\s*{_ARGUMENT}", lambda m: m[2] + _ACCENTS[m[1]], text)
    text = re.sub(r"\^\{?([0-9+-]+)\}?", lambda m: m[1].translate(_SUPERSCRIPT), text)
    text = re.sub(r"_(?:\{([\d,]+)\}|(\d))", lambda m: (m[1] or m[2]).translate(_SUBSCRIPT), text)
    return re.sub(rf"([_^]){_ARGUMENT}", r"\1\2", text)


def _fraction(found: re.Match[str]) -> str:
    return f"{_grouped(found[1])}/{_grouped(found[2])}"


def _grouped(text: str) -> str:
    return text if re.fullmatch(r"[\w.°α-ωΑ-Ω√₀-₉⁰-⁹]+", text) else f"({text})"
