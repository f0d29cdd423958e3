"""The Python blocks of the book run, and print what the page shows below them.

`SEAMWRIGHT_BLESS=1` writes what they print into the page.
"""

import contextlib
import io
import os
import re

import pytest

from conftest import ROOT

PAGES = sorted(
    path.relative_to(ROOT) for path in (ROOT / "docs").rglob("*.md") if "\nimport seamwright\n" in path.read_text(encoding="utf-8")
)
#: A block, and the block of text right below it if there is one.
BLOCK = re.compile(r"^```python\n(?P<code>.*?)^```\n(?:\n```text\n(?P<shown>.*?)^```\n)?", re.S | re.M)


def test_there_are_pages():
    assert PAGES


@pytest.mark.parametrize("page", PAGES, ids=str)
def test_blocks_print_what_the_page_shows(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text, names = (ROOT / page).read_text(encoding="utf-8"), {}

    def run(block):
        printed = io.StringIO()
        line = text.count("\n", 0, block.start()) + 1
        code = compile("\n" * line + block["code"], str(page), "exec")
        with contextlib.redirect_stdout(printed):
            exec(code, names)
        if block["shown"] is None:
            assert not printed.getvalue(), f"line {line} prints, and no text is shown"
            return block[0]
        return f"```python\n{block['code']}```\n\n```text\n{printed.getvalue()}```\n"

    found = BLOCK.sub(run, text)
    if os.environ.get("SEAMWRIGHT_BLESS") == "1":
        (ROOT / page).write_text(found, encoding="utf-8")
    else:
        assert found == text
