#!/usr/bin/env python3
"""Checks that what a page or a comment points to is there: links of Markdown pages, their anchors,
names of pages (docs/....md) in all files, and the equations that comments cite.

Usage: check_links.py [REPOSITORY]. Prints one line for each fault; exit code 1 when there is one.
"""

import re
import sys
from pathlib import Path

from check_words import text_files

# Their examples name pages that there are not.
MADE_UP = {"check_links_test.py", "check_words_test.py"}
LINK = re.compile(r"\]\(([^)\s]+)\)")
PAGE = re.compile(r"(?<![\w./-])docs/[\w-][\w./-]*\.(?:md|png)")
EQUATIONS = re.compile(r"(docs/method/\w+\.md), eqs?\. ((?:\(\d+\)(?:, | and )?)+)")
HEADING = re.compile(r"^#+\s+(.*?)\s*$", re.MULTILINE)


def anchors(text):
    """The anchors that GitHub gives the headings of a page."""
    titles = (re.sub(r"[^\w\s-]", "", heading.lower()) for heading in HEADING.findall(text))
    return {title.strip().replace(" ", "-") for title in titles}


def check_link(file, target):
    """Returns what is wrong with a link of a page, or None."""
    if re.match(r"[a-z]+:", target):
        return None
    path, _, anchor = target.partition("#")
    page = file.parent / path if path else file
    if not page.exists():
        return f"{target}: there is no such file"
    if anchor and page.suffix == ".md" and anchor not in anchors(page.read_text(encoding="utf-8")):
        return f"{target}: the page has no such heading"
    return None


def has_equation(page, number):
    """Whether a line of code on the page ends with the number: that is an equation."""
    lines = page.read_text(encoding="utf-8").splitlines() if page.exists() else []
    return any(line.startswith("    ") and line.endswith(" " + number) for line in lines)


def check_file(root, file, name, text):
    for number, line in enumerate(text.splitlines(), 1):
        if file.suffix == ".md":
            for target in LINK.findall(line):
                if fault := check_link(file, target):
                    yield f"{name}:{number}: {fault}"
        for page in [] if file.name in MADE_UP else PAGE.findall(line):
            if not (root / page).exists():
                yield f"{name}:{number}: {page}: there is no such page"
        for page, cited in EQUATIONS.findall(line):
            for equation in re.findall(r"\(\d+\)", cited):
                if not has_equation(root / page, equation):
                    yield f"{name}:{number}: {page} has no equation {equation}"


def check(root):
    return [fault for file, name, text in text_files(root)
            for fault in check_file(root, file, name, text)]


if __name__ == "__main__":
    found = check(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
    print("\n".join(found) or "links: no faults")
    sys.exit(1 if found else 0)
