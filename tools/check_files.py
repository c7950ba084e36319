#!/usr/bin/env python3
"""Checks what each C++ file must be: short and introduced; in src/ and apps/ deterministic, too;
in tests/ named after a file of src/. Number tables (.inc) may be long. And there are no programs:
these are built.

Usage: check_files.py [REPOSITORY]. Prints one line for each fault; exit code 1 when there is one.
"""

import os
import re
import sys
from pathlib import Path

LINE_CEILING = 300
SUFFIXES = {".h", ".cpp"}
TABLES = {".inc"}
PRODUCT = ("include", "src", "apps", "python")
OTHERS = ("tests", "bench", "tools", "examples")
# Tests of the library and of its public headers stand together.
PUBLIC = {"tests/library": "include/sunfleck"}
# Tests of whole pictures: named after what they show, not after a file.
UNMIRRORED = {"tests/render"}
# Only calls of what the library's user has given may end in anything.
CATCH_ALL = r"\bcatch \(\.\.\.\)"
CALLS_BACK = Path("src/library/guarded.h")
# What would make a picture depend on the machine, the day or the schedule, or hide a fault.
BANNED = [(re.compile(pattern), why) for pattern, why in (
    (r"\bstd::(mt19937\w*|random_device|rand|uniform_\w+_distribution)\b",
     "numbers come from a RandomStream"),
    (r"\bstd::atomic<(float|double)>", "its sum depends on the schedule; use ordered_sum"),
    (r"\bstd::(reduce|transform_reduce)\b", "its order is not fixed; use ordered_sum"),
    (r"\bstd::lgamma\b", "it writes a global, and its last bits differ between libraries"),
    (CATCH_ALL, "catch what you can mend; the rest reaches main"),
    (r"\busing namespace\b", "name what you use"),
    (r"\bNOLINT\b(?!.*:)", "say which check and why: NOLINT(check): reason"),
)]


def check_file(root, file):
    name = file.relative_to(root)
    lines = file.read_text(encoding="utf-8").splitlines()
    if not lines or not lines[0].startswith("// "):
        yield f"{name}:1: begins without a comment; say what the file is for"
    if len(lines) > LINE_CEILING and file.suffix not in TABLES:
        yield f"{name}: {len(lines)} lines, ceiling {LINE_CEILING}; move the second idea out"
    if name.parts[0] not in PRODUCT:
        return
    for number, line in enumerate(lines, 1):
        for pattern, why in BANNED:
            if name == CALLS_BACK and pattern.pattern == CATCH_ALL:
                continue
            if match := pattern.search(line.split("// ")[0] if "NOLINT" not in line else line):
                yield f"{name}:{number}: {match[0]}: {why}"


def programs(root):
    for folder, folders, names in os.walk(root):
        folders[:] = [f for f in folders if f not in (".git", "out") and not f.startswith("build")]
        for name in names:
            file = Path(folder, name)
            if not file.is_file():
                continue
            with file.open("rb") as opened:
                if opened.read(4) == b"\x7fELF":
                    yield f"{file.relative_to(root)}: a program; build it instead"


def check(root):
    files = [f for top in PRODUCT + OTHERS for f in sorted((root / top).rglob("*"))
             if f.suffix in SUFFIXES | TABLES]
    faults = [fault for file in files for fault in check_file(root, file)]
    faults += programs(root)
    for test in sorted((root / "tests").rglob("*_test.cpp")):
        if str(test.parent.relative_to(root)) in UNMIRRORED:
            continue
        module = root / "src" / test.parent.relative_to(root / "tests")
        subject = test.name.removesuffix("_test.cpp").removesuffix("_slow")
        public = root / PUBLIC.get(str(test.parent.relative_to(root)), "none")
        subjects = [place / (subject + s) for place in (module, public) for s in SUFFIXES]
        if module.is_dir() and not any(file.exists() for file in subjects):
            faults.append(f"{test.relative_to(root)}: tests nothing that src/ has by that name")
    return faults


if __name__ == "__main__":
    found = check(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
    print("\n".join(found) or "files: no faults")
    sys.exit(1 if found else 0)
