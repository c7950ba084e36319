#!/usr/bin/env python3
"""Each rule of check_words.py, broken once; and ordinary words that it must leave alone."""

import tempfile
import unittest
from pathlib import Path

from check_words import check


class CheckWords(unittest.TestCase):
    def faults(self, text, name="docs/a.md", gone=None):
        with tempfile.TemporaryDirectory() as folder:
            for file, written in ((name, text), ("tools/words_gone.txt", gone)):
                path = Path(folder, file)
                path.parent.mkdir(parents=True, exist_ok=True)
                if written is not None:
                    path.write_text(written, encoding="utf-8")
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

    GONE = "# Why\n\\bladders?\\b | src docs !src/simd/* | multilevel splitting\n"

    def test_words_that_left(self):
        for name in ("docs/a.md", "src/x/a.h"):
            with self.subTest(name):
                self.assertEqual(self.faults("one\nthe ladder\n", name, self.GONE),
                                 [f"{name}:2: ladder: this word left; say multilevel splitting"])

    def test_words_that_left_where_they_may_stay(self):
        for name in ("apps/a.cpp", "src/simd/a.h", "CHANGELOG.md", "docs/develop/glossary.md"):
            with self.subTest(name):
                self.assertEqual(self.faults("the ladder\n", name, self.GONE), [])
        self.assertEqual(self.faults("bladders\n", gone=self.GONE), [])


if __name__ == "__main__":
    unittest.main()
