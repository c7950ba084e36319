#!/usr/bin/env python3
"""Each rule of check_words.py, broken once; and ordinary words that it must leave alone."""

import tempfile
import unittest
from pathlib import Path

from check_words import check


class CheckWords(unittest.TestCase):
    def faults(self, text, name="docs/a.md"):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
            return check(Path(folder))

    def test_each_rule(self):
        for words in ("see /wo" "rk/main", "from /ho" "me/ada/x", "in /tm" "p/x.exr",
                      "apt at deb." "debian.org", "pip from pypi" ".org", "registry" ".example.com",
                      "the last sess" "ion", "in this sess" "ion", "Co-auth" "ored-by: x",
                      "TO" "DO: later"):
            with self.subTest(words):
                faults = self.faults("# A\n" + words + "\n")
                self.assertEqual([f[:12] for f in faults], ["docs/a.md:2:"], faults)

    def test_ordinary_words(self):
        for words in ("a file src/work/x.h", "one workgroup", "an interactive session", "/usr/bin/make",
                      "registry", "https://example.org/paper", "a homeomorphism", "${TMPDIR:-/tmp}/x",
                      "units of W/sr", "todo lists"):
            with self.subTest(words):
                self.assertEqual(self.faults(words), [])

    def test_made_files_and_pictures_are_left_alone(self):
        self.assertEqual(self.faults("/wo" "rk/main", "build/a.md"), [])
        self.assertEqual(self.faults("/wo" "rk/main", "docs/a.png"), [])


if __name__ == "__main__":
    unittest.main()
