#!/usr/bin/env python3
"""Each rule of check_files.py, broken once."""

import tempfile
import unittest
from pathlib import Path

from check_files import check


class CheckFiles(unittest.TestCase):
    def expect(self, start, name, text):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            Path(folder, "src/core").mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
            faults = check(Path(folder))
        self.assertEqual([start] if start else [], [f[:len(start)] for f in faults], faults)

    def test_good(self):
        self.expect("", "src/core/a.h", "// What it is.\nint strand();  // not std::rand\n")

    def test_no_head_comment(self):
        self.expect("src/core/a.h:1: begins without", "src/core/a.h", "#pragma once\n")

    def test_too_long(self):
        self.expect("src/core/a.h: 301 lines", "src/core/a.h", "// Long.\n" * 301)

    def test_schedule_dependent_sum(self):
        self.expect("src/core/a.h:2: std::atomic<float>", "src/core/a.h",
                    "// A.\nstd::atomic<float> flux;\n")

    def test_foreign_random_numbers(self):
        self.expect("apps/cli/a.cpp:2: std::mt19937_64", "apps/cli/a.cpp",
                    "// A.\nstd::mt19937_64 g;\n")

    def test_program(self):
        self.expect("thin: a program", "thin", "\x7fELF\x02")
        self.expect("docs/thin: a program", "docs/thin", "\x7fELF\x02")
        self.expect("", "build/bin/thin", "\x7fELF\x02")

    def test_bare_nolint(self):
        self.expect("src/core/a.h:2: NOLINT", "src/core/a.h", "// A.\nint x;  // NOLINT\n")

    def test_nolint_with_reason(self):
        self.expect("", "src/core/a.h", "// A.\nint x;  // NOLINT(misc-x): the C API wants it\n")

    def test_test_of_nothing(self):
        self.expect("tests/core/gone_test.cpp: tests no", "tests/core/gone_test.cpp", "// A.\n")
        self.expect("tests/core/a_slow_test.cpp: tests", "tests/core/a_slow_test.cpp", "// A.\n")

    def test_tests_and_benches_have_heads_and_ends(self):
        self.expect("tests/laws/a_test.cpp:1: begins", "tests/laws/a_test.cpp", "int x;\n")
        self.expect("bench/a.cpp: 301 lines", "bench/a.cpp", "// Long.\n" * 301)

    def test_tests_may_use_what_pictures_may_not(self):
        self.expect("", "tests/laws/a_test.cpp", "// A.\nstd::mt19937 g;\n")

    def test_tables_may_be_long_but_say_what_they_are(self):
        self.expect("", "src/core/a.inc", "// Numbers.\n" + "1,\n" * 1000)
        self.expect("src/core/a.inc:1: begins", "src/core/a.inc", "1, 2,\n")


if __name__ == "__main__":
    unittest.main()
