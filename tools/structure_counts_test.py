#!/usr/bin/env python3
"""Tests of structure_counts.py on small sources of their own."""

import tempfile
import unittest
from pathlib import Path

import structure_counts


class BareRows(unittest.TestCase):
    def rows(self, source, name="src/table.cpp"):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, name)
            file.parent.mkdir(parents=True)
            file.write_text(source)
            return list(structure_counts.bare_rows(Path(folder)))

    def test_a_row_of_a_struct_is_counted(self):
        for source in ("struct Axis {\n};\nAxis x{true, 0, 1e-3F};",
                       "struct Axis {\n};\nAxis x = {1, 2, size, 3};",
                       "struct Axis {\n};\nuse(Axis{-1, 2, 3});",
                       "struct Axis {\n};\nstd::array<Axis, 1> all = {{\n    {1, 2, 3},\n}};",
                       'Row row{"text, and more", 16, 2.5, 90};',
                       'call({R"(raw {1})", 512, 512, 3});'):
            self.assertEqual(len(self.rows(source)), 1, source)

    def test_named_fields_vectors_and_arrays_are_not(self):
        for source in ("struct Axis {\n};\nAxis x{.low = 1, .high = 2, .from = 3};",
                       "struct Axis {\n};\nAxis x{1, 2, high};",
                       "const Vec3d up{0, 0, 1};",
                       "std::array<double, 4> kAll = {1, 2, 3, 4};",
                       "// Axis x{1, 2, 3};",
                       'void f() { say(""); x = 1, y = 2; }'):
            self.assertEqual(self.rows(source), [], source)

    def test_measured_tables_are_exempt(self):
        source = 'Glass glass{"BK7", 1.5, 1.6, 1.7};'
        self.assertEqual(self.rows(source, "src/math/data_glass.h"), [])
        self.assertEqual(len(self.rows(source, "src/math/glass.h")), 1)


if __name__ == "__main__":
    unittest.main()
