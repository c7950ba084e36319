#!/usr/bin/env python3
"""Checks that files speak of the project alone: not of the place or the day they were written in;
and that words which left (tools/words_gone.txt) stay away.

Usage: check_words.py [REPOSITORY]. Prints one line for each fault; exit code 1 when there is one.
A word that a user needs after all stands in ALLOWED with the file that may say it.
"""

import re
import sys
from fnmatch import fnmatch
from pathlib import Path

# Folders that are made, not written.
SKIPPED = {".git", "build", "out", ".cache", "__pycache__"}
SUFFIXES = {"", ".h", ".cpp", ".py", ".sh", ".md", ".txt", ".cmake", ".json", ".pbrt",
            ".html", ".css", ".js", ".yml", ".yaml", ".toml", ".dict"}
# Patterns are broken up where they would find themselves.
BANNED = [(re.compile(pattern, re.IGNORECASE), why) for pattern, why in (
    (r"(?<![\w./])/(work|home|root|Users|mnt|opt)/\w", "a path of one machine; write it relative"),
    (r"/tmp/(?!\$|\{|sunfleck)\w", "a path of one machine; let mktemp choose"),
    (r"\b(deb|snapshot|security|ftp)[.]debian[.]org\b|\bpypi[.]org\b|\bregistry[.][a-z]"
     r"|\bdocker[.]io\b|\bghcr[.]io\b|\bcrates[.]io\b|\bnpmjs\b",
     "a registry; the user's system knows its own"),
    (r"\b(my|this|our|the|previous|next|last|earlier|another) sess" r"ions?\b|\bsess" r"ions? (of|ago)\b",
     "say what is, not when it was made"),
    (r"\b(chat" r"bot|lang" r"uage mod" r"el|co-auth" r"ored|sand" r"box|work" r"place)\b",
     "it is no part of the project"),
    (r"(?-i:\b(TO" r"DO|FIX" r"ME|XX" r"X)\b)", "do it, or open an issue"),
)]
ALLOWED = {("LICENSE", "registry")}
# These say what the old names were.
HISTORY = ("CHANGELOG.md", "docs/develop/glossary.md", "docs/reference/old_names.md",
           "src/flags/renamed_flags.h", "tests/app/renamed_flags_test.cpp",
           "tools/words_gone.txt", "tools/check_words_test.py")


def read_gone(text):
    """Returns [(pattern, where, but not where, what is said instead)]."""
    rows = []
    for line in text.splitlines():
        if not line.strip() or line.startswith("#"):
            continue
        pattern, where, instead = line.rsplit(" | ", 2)
        places = where.split()
        rows.append((re.compile(pattern), [p for p in places if not p.startswith("!")],
                     [p[1:] for p in places if p.startswith("!")], instead))
    return rows


def is_in(name, places):
    """Is the file one of these, or in a folder of these? "." is the whole repository."""
    return any(p == "." or name == p or name.startswith(p + "/") or fnmatch(name, p)
               for p in places)


def check_gone(name, text, rows):
    rows = [row for row in rows if is_in(name, row[1]) and not is_in(name, row[2])]
    if name in HISTORY or not rows:
        return
    for number, line in enumerate(text.splitlines(), 1):
        for pattern, _, _, instead in rows:
            if match := pattern.search(line):
                yield f"{name}:{number}: {match[0]}: this word left; say {instead}"


def check_file(name, text):
    for number, line in enumerate(text.splitlines(), 1):
        for pattern, why in BANNED:
            match = pattern.search(line)
            if match and (name, match[0]) not in ALLOWED:
                yield f"{name}:{number}: {match[0]}: {why}"


def text_files(root):
    """Yields (file, its name in the repository, its text) of all that is written, not made."""
    for file in sorted(root.rglob("*")):
        name = file.relative_to(root)
        if file.suffix in SUFFIXES and not SKIPPED & set(name.parts) and file.is_file():
            yield file, str(name), file.read_text(encoding="utf-8", errors="replace")


def check(root):
    faults = []
    gone = root / "tools/words_gone.txt"
    rows = read_gone(gone.read_text(encoding="utf-8")) if gone.exists() else []
    for _, name, text in text_files(root):
        faults += check_file(name, text)
        faults += check_gone(name, text, rows)
    return faults


if __name__ == "__main__":
    found = check(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
    print("\n".join(found) or "words: no faults")
    sys.exit(1 if found else 0)
