#!/usr/bin/env python3
"""Writes the number tables of src/math/data_*.h: the CIE observer, illuminants, metals, glasses.

Usage: make_spectra_tables.py OBSERVER_CSV PBRT_SPECTRUM_CPP OUTPUT_FOLDER

OBSERVER_CSV: wavelength_nm,x_bar,y_bar,z_bar at 1 nm, 360..830 (CIE 1931 2 degree observer).
PBRT_SPECTRUM_CPP: src/pbrt/util/spectrum.cpp of pbrt-v4, of which only the numbers are read
(wavelength, value pairs), so that named spectra have the same points here and there.
The tables are committed; run this again only to change their form.
"""

import csv
import re
import sys
from pathlib import Path

NAMESPACE = "sunfleck::spectra_data"
ILLUMINANTS = {"A": "CIE_Illum_A", "AcesD60": "ACES_Illum_D60",
               "D65": "CIE_Illum_D6500", **{f"F{i}": f"CIE_Illum_F{i}" for i in range(1, 13)}}
METALS = ("Ag", "Al", "Au", "Cu", "CuZn", "MgO", "TiO2")
GLASSES = ("BK7", "BAF10", "FK51A", "LASF9", "SF5", "SF10", "SF11")


def number(value):
    text = f"{value:.8g}"
    return text.replace("e-0", "e-")


def array(name, values):
    """A constexpr array of doubles, lines of at most 100 columns."""
    lines, line = [], "   "
    for value in values:
        item = " " + number(value) + ","
        if len(line) + len(item) > 99:
            lines.append(line)
            line = "   "
        line += item
    lines.append(line.rstrip(","))
    body = "\n".join(lines)
    return f"inline constexpr std::array<double, {len(values)}> {name} = {{\n{body}}};\n"


def write(folder, name, head, arrays):
    note = ("//\n// Made by tools/make_spectra_tables.py.\n"
            "#pragma once\n\n#include <array>\n\n// clang-format off\n")
    text = head + note + f"namespace {NAMESPACE} {{\n" + "".join(arrays) + "}\n"
    (folder / name).write_text(text, encoding="utf-8")


def pairs(source, name):
    """The wavelengths and values of one interleaved table, without the noise of single floats."""
    body = re.search(rf"const Float {name}\[\] = {{(.*?)}};", source, re.S)[1]
    numbers = [float(word) for word in re.sub(r"//.*", "", body).replace(",", " ").split()]
    digits = 8 if name.startswith("Glass") else 6
    return numbers[0::2], [float(f"{v:.{digits}g}") for v in numbers[1::2]]


def daylight(source, kelvin):
    """The CIE's D illuminant of a nominal temperature, at 5 nm from 300 nm (CIE 15:2004, 3.1)."""
    basis = []
    for i in range(3):
        body = re.search(rf"const Float CIE_S{i}\[nCIES\] = {{(.*?)}};", source, re.S)[1]
        basis.append([float(word) for word in body.replace(",", " ").split()])
    t = kelvin * 1.4388 / 1.4380  # the second radiation constant has changed since it was named
    x = 0.244063 + 0.09911e3 / t + 2.9678e6 / t**2 - 4.6070e9 / t**3  # up to 7000 K
    y = -3.0 * x * x + 2.87 * x - 0.275
    m = 0.0241 + 0.2562 * x - 0.7341 * y
    m1 = round((-1.3515 - 1.7703 * x + 5.9114 * y) / m, 3)
    m2 = round((0.03 - 31.4424 * x + 30.0717 * y) / m, 3)
    return [round(s0 + m1 * s1 + m2 * s2, 5) for s0, s1, s2 in zip(*basis)]


def uniform(nm):
    step = nm[1] - nm[0]
    return all(b - a == step for a, b in zip(nm, nm[1:]))


def main(observer_csv, pbrt_spectrum, folder):
    with open(observer_csv, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    write(folder, "data_observer.h",
          "// CIE 1931 2 degree observer at 1 nm, 360..830 nm. Source: CIE 15:2004 (ISO 11664-1).\n",
          [array(f"kObserver{c.upper()}", [float(row[f"{c}_bar"]) for row in rows]) for c in "xyz"])

    source = Path(pbrt_spectrum).read_text(encoding="utf-8")
    # pbrt-v4's own D50 is not the CIE's: its x, y is 0.337, 0.358, too little red above 560 nm.
    arrays = [array("kIlluminantD50", daylight(source, 5000))]
    for name, table in ILLUMINANTS.items():
        nm, values = pairs(source, table)
        first = 380 if name.startswith("F") else 300
        assert uniform(nm) and nm[0] == first and nm[1] == first + 5, name
        arrays.append(array(f"kIlluminant{name}", values))
    write(folder, "data_illuminants.h",
          "// Standard illuminants at 5 nm: A and D from 300, F from 380 nm. Source: CIE 15:2004,\n"
          "// illuminant D60 of ACES (AMPAS TB-2018-001); the numbers as pbrt-v4 has them, but D50 from\n"
          "// the CIE's daylight basis.\n", arrays)

    arrays, grids = [], {}
    for metal in METALS:
        for part in ("eta", "k"):
            nm, values = pairs(source, f"{metal}_{part}")
            if tuple(nm) not in grids:
                grids[tuple(nm)] = metal
                arrays.append(array(f"k{metal}Nm", nm))
            arrays.append(array(f"k{metal}{part.capitalize()}", values))
    shared = ", ".join(f"{metal}" for metal in grids.values())
    write(folder, "data_metals.h",
          "// Complex refractive indices of metals and oxides. Source: the SOPRA and Luxpop data as\n"
          f"// pbrt-v4 has them. Own wavelengths: {shared}; the other metals share those of Ag.\n",
          arrays)

    arrays = []
    for glass in GLASSES:
        nm, values = pairs(source, f"Glass{glass}_eta")
        arrays += [array(f"k{glass}Nm", nm), array(f"k{glass}Eta", values)]
    write(folder, "data_glass.h",
          "// Refractive indices of optical glasses. Source: Schott's catalogue at the points that\n"
          "// pbrt-v4 has, so that the lines between them are the same.\n", arrays)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], Path(sys.argv[3]))
