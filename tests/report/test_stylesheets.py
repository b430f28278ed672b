"""Style sheets keep every rule that a page can meet, and lose the others."""

from __future__ import annotations

import pytest

from omniproof.report.stylesheets import used_rules


@pytest.mark.parametrize(
    ("css", "expected"),
    [
        pytest.param(".a{x:1}.b{x:2}", ".a{x:1}", id="a class that no element has"),
        pytest.param(".a,.b p{x:1}", ".a{x:1}", id="one of two selectors"),
        pytest.param(".a .b{x:1}", "", id="inside of such an element"),
        pytest.param("p,#id,[x=y]{x:1}", "p,#id,[x=y]{x:1}", id="no class"),
        pytest.param(".a:not(.b){x:1}", ".a:not(.b){x:1}", id="a class that must not be there"),
        pytest.param(":is(.a,.b){x:1}", ":is(.a,.b){x:1}", id="one of several"),
        pytest.param("@media print{.b{x:1}.a{x:2}}", "@media print{.a{x:2}}", id="in a query"),
        pytest.param("@media print{.b{x:1}}", "", id="nothing left of a query"),
        pytest.param('@charset "u";.a{x:1}', '@charset "u";.a{x:1}', id="a statement"),
        pytest.param('@import url("b.css");', '@import url("b.css");', id="nothing else"),
        pytest.param("@font-face{src:url(b.woff)}", "@font-face{src:url(b.woff)}", id="a font"),
        pytest.param('.a{x:"}"}.b{x:"{"}', '.a{x:"}"}', id="braces in a text"),
        pytest.param("/* { */.a{x:1}", ".a{x:1}", id="a comment"),
    ],
)
def test_used_rules(css: str, expected: str) -> None:
    assert used_rules(css, {"a"}) == expected
