#!/usr/bin/env python3
"""Makes the add-on's .zip, which Blender installs (Edit > Preferences > Add-ons > Install).

Usage: make_zip.py FILE.zip. The same sources give the same bytes.
"""

import sys
import zipfile
from pathlib import Path

ADDON = Path(__file__).resolve().parent / "sunfleck_blender"


def make(path):
    """Writes the archive, and returns the names in it."""
    names = []
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for file in sorted(ADDON.glob("*.py")):
            name = f"{ADDON.name}/{file.name}"
            entry = zipfile.ZipInfo(name, (2000, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, file.read_bytes())
            names.append(name)
        entry = zipfile.ZipInfo(f"{ADDON.name}/LICENSE", (2000, 1, 1, 0, 0, 0))
        archive.writestr(entry, (ADDON.parents[1] / "LICENSE").read_bytes())
    return names


if __name__ == "__main__":
    if len(sys.argv) != 2 or not sys.argv[1].endswith(".zip"):
        sys.exit(__doc__.strip())
    make(sys.argv[1])
