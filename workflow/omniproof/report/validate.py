"""Read the finished pages back and see whether they keep their promises.

Every promise is checked on the HTML itself, not on what made it: a claim has exactly one address,
a figure has alt text and data, a link leads somewhere, a page asks for nothing outside its folder,
and the counts that it shows are those of the ledger. All that is wrong is reported at once.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

from omniproof.audit.ledger import Ledger, Verdict
from omniproof.report.anchors import anchor, unique_anchors
from omniproof.report.answered import answer_faults
from omniproof.report.cards import card_faults, opened
from omniproof.report.derived import Derived
from omniproof.report.fragments.counts import ALL, verdict_counts
from omniproof.report.fragments.rows import FOLDER, read_details
from omniproof.report.fragments.theorems import read_theorems
from omniproof.report.prose import Prose

_MARKERS = re.compile(r"\{(?:glue|ref|eq|cite|numref|doc)[^}]*\}`|\[\?\]|\?\?|Unexecuted inline")
_CSS_URL = re.compile(r"(?:url\(\s*['\"]?|@import\s+['\"])((?:https?:)?//[^'\")\s]+)")
_RAW = frozenset({"script", "style", "pre", "code", "title"})
_FETCHED = {"script": "src", "img": "src", "link": "href", "iframe": "src", "source": "src",
            "video": "src", "audio": "src", "object": "data", "embed": "src", "image": "href",
            "use": "href", "input": "src", "track": "src"}  # fmt: skip
_ALSO_FETCHED = ("poster", "background")
_NO_REQUEST = frozenset({"canonical", "search", "index", "next", "prev", "author", "copyright"})


LARGEST = 1_500_000
"""Bytes of the largest page: what a phone lays out without a wait."""


class InvalidBookError(Exception):
    """The report breaks promises; `faults` names each as `page: what`."""

    def __init__(self, faults: Iterable[str]) -> None:
        self.faults = tuple(faults)
        count = f"{len(self.faults)} fault{'s' if len(self.faults) != 1 else ''} in the report"
        super().__init__("\n".join([*self.faults, count]))


@dataclass(frozen=True)
class Figure:
    """A drawn figure on a page: its id, alt text and links."""

    address: str
    alt: str
    links: tuple[str, ...]


class Page(HTMLParser):
    """What the checks need to know of one page."""

    def __init__(self, name: str, text: str) -> None:
        super().__init__(convert_charrefs=True)
        self.name = name
        self.ids: list[str] = []
        self.links: list[str] = []
        self.requests: list[str] = []
        self.pictures_without_alt: list[str] = []
        self.figures: list[Figure] = []
        self.counts: dict[tuple[str, str], list[str]] = {}
        self.words: list[str] = []
        self.prose = Prose()
        self._open: list[str] = []
        self._figure: tuple[str, str, list[str]] | None = None
        self._count: tuple[str, str] | None = None
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Note ids, links, requests, figures and counts."""
        found = {name: value or "" for name, value in attrs}
        self.prose.enter(tag, found)
        if tag in _RAW:
            self._open.append(tag)
        if "id" in found:
            self.ids.append(found["id"])
        self._note_links(tag, found)
        self._note_figure(tag, found)
        if "data-verdict" in found:
            self._count = (found.get("data-paper", ""), found["data-verdict"])
        if "problematic" in found.get("class", "").split():
            self.words.append("[?]")

    def _note_links(self, tag: str, found: dict[str, str]) -> None:
        if tag == "a" and found.get("href"):
            self.links.append(found["href"])
            if self._figure is not None:
                self._figure[2].append(found["href"])
        target = found.get(_FETCHED.get(tag, ""), "")
        if target and not (tag == "link" and found.get("rel") in _NO_REQUEST):
            self.requests.append(target)
        self.requests += [found[name] for name in _ALSO_FETCHED if found.get(name)]
        choices = found.get("srcset", "").split(",")
        self.requests += [choice.split()[0] for choice in choices if choice.strip()]
        self.requests += _CSS_URL.findall(found.get("style", ""))
        if tag == "img" and not found.get("alt") and found.get("role") != "presentation":
            self.pictures_without_alt.append(found.get("src", ""))

    def _note_figure(self, tag: str, found: dict[str, str]) -> None:
        if tag == "figure" and "drawn" in found.get("class", "").split():
            self._figure = (found.get("id", ""), "", [])
        if tag == "svg" and self._figure is not None and not self._figure[1]:
            self._figure = (self._figure[0], found.get("aria-label", ""), self._figure[2])

    def handle_endtag(self, tag: str) -> None:
        """Close what was noted."""
        self.prose.leave(tag)
        if self._open and self._open[-1] == tag:
            self._open.pop()
        if tag == "figure" and self._figure is not None:
            address, alt, links = self._figure
            self.figures.append(Figure(address, alt.strip(), tuple(links)))
            self._figure = None
        if tag == "td":
            self._count = None

    def handle_data(self, data: str) -> None:
        """Note running text and counts."""
        self.prose.add(data)
        if self._open and self._open[-1] == "style":
            self.requests += _CSS_URL.findall(data)
        if self._count is not None:
            self.counts.setdefault(self._count, []).append(data.strip())
        if not self._open:
            self.words.append(data)


def validate_book(html: Path, ledgers: Sequence[Ledger], figures: Iterable[Path] = ()) -> None:
    """Check the report in the folder `html`.

    figures: drawings (`…/<paper>/figure-N.svg`) that some page has to show; those on a page are
    checked anyway. Raises `InvalidBookError` with everything that is wrong.
    """
    pages = {path.name: Page(path.name, _opened(path)) for path in sorted(html.glob("*.html"))}
    faults = [
        *_sum_faults(pages.get("index.html"), ledgers),
        *(fault for ledger in ledgers for fault in _chapter_faults(pages, ledger)),
        *(fault for ledger in ledgers for fault in _claim_faults(html, ledger)),
        *_theorem_faults(html, pages.values()),
        *(fault for path in figures for fault in _shown_faults(pages, path)),
        *(fault for page in pages.values() for fault in _page_faults(html, page, pages)),
        *_style_faults(html),
    ]
    if faults:
        raise InvalidBookError(faults)


def _opened(page: Path) -> str:
    """Return the HTML of a page with the details of all rows that it shows."""
    file = page.parent / FOLDER / f"{page.stem}.js"
    details = read_details(file.read_text(encoding="utf-8")) if file.is_file() else {}
    return opened(page.read_text(encoding="utf-8"), details)


def _chapter_faults(pages: dict[str, Page], ledger: Ledger) -> Iterator[str]:
    """Addresses of all rows, and counts that agree with the ledger."""
    page = pages.get(f"{ledger.paper}.html")
    if page is None:
        yield f"{ledger.paper}.html: the chapter is missing"
        return
    ids = Counter(page.ids)
    for claim, address in unique_anchors(row.id for row in ledger.rows).items():
        if ids[address] != 1:
            yield f"{page.name}: {claim} has {ids[address]} elements #{address}, expected one"
    expected = {str(v): n for v, n in verdict_counts(ledger).items()} | {"all": len(ledger.rows)}
    for shown in (page, pages.get("index.html")):
        if shown is not None:
            yield from _count_faults(shown, ledger.paper, expected)


def _claim_faults(html: Path, ledger: Ledger) -> Iterator[str]:
    """What answers and cards of a chapter lack; one that is missing has been named before."""
    page = html / f"{ledger.paper}.html"
    if page.is_file():
        text = _opened(page)
        yield from card_faults(page.name, text, ledger, Derived(ledger))
        yield from answer_faults(page.name, text, ledger)


def _theorem_faults(html: Path, pages: Iterable[Page]) -> Iterator[str]:
    """A theorem stands on one page, where it has its number."""
    shown = Counter(name for page in pages for name in page.ids)
    for theorem in read_theorems(html / "theorems.json"):
        if (count := shown[anchor(theorem.id)]) != 1:
            yield f"theorems.json: {theorem.id} stands in {count} places, expected one"


def _sum_faults(index: Page | None, ledgers: Sequence[Ledger]) -> Iterator[str]:
    """The sums over all papers on the first page."""
    if index is None:
        yield "index.html: the first page is missing"
        return
    total = sum(map(verdict_counts, ledgers), Counter[Verdict]())
    expected = {str(verdict): number for verdict, number in total.items()}
    yield from _count_faults(index, ALL, expected | {"all": sum(total.values())})


def _count_faults(page: Page, paper: str, expected: dict[str, int]) -> Iterator[str]:
    for verdict, number in expected.items():
        shown = page.counts.get((paper, verdict), [])
        if not shown:
            yield f"{page.name}: no count of {paper}, {verdict}; the ledger has {number}"
        for text in shown:
            if text != str(number):
                yield f"{page.name}: {paper}, {verdict}: shows {text}, the ledger has {number}"


def _shown_faults(pages: dict[str, Page], drawing: Path) -> Iterator[str]:
    link = f"figures/{drawing.parent.name}/{drawing.name}"
    if not any(link in figure.links for page in pages.values() for figure in page.figures):
        yield f"{link}: no page shows it"


def _page_faults(html: Path, page: Page, pages: dict[str, Page]) -> Iterator[str]:
    if (size := (html / page.name).stat().st_size) > LARGEST:
        yield f"{page.name}: has {size} bytes, more than {LARGEST}"
    for number in page.prose.typed_numbers():
        yield f"{page.name}: a typed number: {number} (mark a choice: [{number}]{{.given}})"
    yield from (f"{page.name}: the id {i} occurs {n} times" for i, n in _repeated(page.ids))
    yield from (f"{page.name}: an image without alt text: {src}" for src in
                page.pictures_without_alt)  # fmt: skip
    for figure in page.figures:
        if not figure.alt:
            yield f"{page.name}: #{figure.address} has no alt text"
        for suffix, what in ((".csv", "data"), (".svg", "drawing")):
            if not any(link.endswith(suffix) for link in figure.links):
                yield f"{page.name}: #{figure.address} has no link to its {what}"
    for target in page.requests:
        if urlsplit(target).scheme in {"http", "https"} or target.startswith("//"):
            yield f"{page.name}: asks for {target}, outside its folder"
    for target in dict.fromkeys([*page.links, *page.requests]):
        yield from _link_faults(html, page, target, pages)
    for marker in sorted(set(_MARKERS.findall(" ".join(page.words)))):
        yield f"{page.name}: an unresolved reference: {marker}"


def _repeated(ids: Sequence[str]) -> list[tuple[str, int]]:
    return [(name, count) for name, count in Counter(ids).items() if count > 1]


def _link_faults(html: Path, page: Page, target: str, pages: dict[str, Page]) -> Iterator[str]:
    parts = urlsplit(target)
    if parts.scheme or parts.netloc:
        return
    path, anchor = unquote(parts.path), unquote(parts.fragment)
    file = html / path if path else html / page.name
    if not file.resolve().is_relative_to(html.resolve()) or not file.exists():
        yield f"{page.name}: the link {target} leads nowhere"
        return
    goal = pages.get(file.name) if file.parent.resolve() == html.resolve() else None
    if anchor and goal is not None and anchor not in goal.ids:
        yield f"{page.name}: the link {target} leads to no element"


def _style_faults(html: Path) -> Iterator[str]:
    for path in sorted(html.rglob("*.css")):
        for url in _CSS_URL.findall(path.read_text(encoding="utf-8", errors="replace")):
            yield f"{path.relative_to(html)}: asks for {url}, outside its folder"
