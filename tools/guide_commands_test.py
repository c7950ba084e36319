#!/usr/bin/env python3
"""Tests guide_commands.py: each kind of fault of a page is told, with its line."""

import tempfile
import unittest
from pathlib import Path

import guide_commands

# Knows one command with one flag, and shows what it was called with.
PROGRAM = """#!/bin/bash
if [[ $2 = --help ]]; then echo "  --good TEXT"; exit 0; fi
echo "$@" >> calls
for word in "$@"; do if [[ $word = --bad ]]; then echo "no flag --bad" >&2; exit 2; fi; done
"""


class GuideCommands(unittest.TestCase):
    def faults(self, page):
        with tempfile.TemporaryDirectory() as scratch:
            folder = Path(scratch)
            (folder / "program").write_text(PROGRAM)
            (folder / "program").chmod(0o755)
            (folder / "page.md").write_text(page)
            (folder / "bin").mkdir()
            (folder / "work").mkdir()
            wrapper = folder / "bin/sunfleck"
            wrapper.write_text(guide_commands.SHORTER.replace("@PROGRAM@", str(folder / "program")))
            wrapper.chmod(0o755)
            faults = list(guide_commands.check_page(folder / "page.md", folder,
                                                    lambda command: {"--good"}))
            calls = folder / "work/calls"
            return [f.partition("page.md:")[2] for f in faults], (
                calls.read_text() if calls.exists() else "")

    def test_a_command_that_fails_is_told_with_its_line_and_its_words(self):
        faults, _ = self.faults("# Page\n\n    sunfleck info --good\n    sunfleck info --bad\n")
        self.assertEqual(faults, ["3: ends with 2: no flag --bad"])

    def test_a_render_is_shortened_whatever_its_limits(self):
        faults, calls = self.faults("# Page\n\n    sunfleck render a.pbrt --time 8h -o a.exr\n")
        self.assertEqual(faults, [])
        self.assertTrue(calls.startswith("render a.pbrt -o a.exr --passes 2 --resolution 24x16"))

    def test_commands_that_cannot_run_must_have_flags_that_there_are(self):
        page = "<!-- not run: needs a cluster -->\n\n    mpirun sunfleck render a {} \\\n      -o b\n"
        self.assertEqual(self.faults(page.format("--good"))[0], [])
        faults, calls = self.faults(page.format("--gone"))
        self.assertEqual(faults, ["3: `sunfleck render` has no flag --gone"])
        self.assertEqual(calls, "")

    def test_commands_that_cannot_run_must_be_bash(self):
        faults, _ = self.faults("<!-- not run: takes hours -->\n\n    if true; then (\n")
        self.assertIn("syntax error", faults[0])

    def test_files_and_what_comes_first_are_there_and_listings_are_left_alone(self):
        faults, calls = self.faults(
            "<!-- file a.pbrt -->\n\n    WorldBegin\n\nText.\n\n"
            "<!-- first: sunfleck scene first -->\n\n    sunfleck info $(cat a.pbrt)\n\n"
            "Text.\n\n<!-- listing -->\n\n    a.pbrt    a scene (\n")
        self.assertEqual(faults, [])
        self.assertEqual(calls, "scene first\ninfo WorldBegin\n")


if __name__ == "__main__":
    unittest.main()
