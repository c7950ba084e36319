#!/usr/bin/env python3
"""Each rule of check_links.py, broken once; and links that are right."""

import tempfile
import unittest
from pathlib import Path

from check_links import check


class CheckLinks(unittest.TestCase):
    def faults(self, **files):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in files.items():
                path = Path(folder, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            return check(Path(folder))

    def test_links_that_are_right(self):
        self.assertEqual([], self.faults(**{
            "README.md": "[a](docs/x/a.md) [b](docs/x/a.md#why-so) [c](https://example.org)\n# Top\n[d](#top)\n",
            "docs/x/a.md": "## Why so?\n[back](../../README.md)\n",
            "src/a.h": "// Why: docs/x/a.md.\n"}))

    def test_link_to_no_file(self):
        self.assertEqual(["docs/a.md:1: b.md: there is no such file"],
                         self.faults(**{"docs/a.md": "[b](b.md)\n"}))

    def test_link_to_no_heading(self):
        self.assertEqual(["a.md:2: #there: the page has no such heading"],
                         self.faults(**{"a.md": "# Here\n[x](#there)\n"}))

    def test_comment_that_names_no_page(self):
        self.assertEqual(["src/a.h:1: docs/" "none.md: there is no such page"],
                         self.faults(**{"src/a.h": "// docs/" "none.md has it\n"}))

    def test_equations_are_lines_of_code_that_end_with_their_number(self):
        page = {"docs/method/m.md": "    a = b        (3)\n\nText (4)\n"}
        cite = "// Equations: docs/" "method/m.md, eqs. {}.\n"
        self.assertEqual([], self.faults(**page, **{"src/a.h": cite.format("(3)")}))
        self.assertEqual(["src/a.h:1: docs/" "method/m.md has no equation (4)"],
                         self.faults(**page, **{"src/a.h": cite.format("(3) and (4)")}))


if __name__ == "__main__":
    unittest.main()
