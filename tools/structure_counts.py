#!/usr/bin/env python3
"""Counts what should be zero in the structure of source and docs, to compare two states of them.

Usage: structure_counts.py [REPOSITORY]. Prints one line for each count.
"""

import re
import sys
from pathlib import Path

import check_layers
import check_words

SCREEN = 60  # lines of a page without a heading


def loops_among(files):
    """Groups of units that include each other, each the largest of its kind (Tarjan 1972)."""
    graph = check_layers.unit_graph(files)
    order, low, stack, loops = {}, {}, [], []

    def visit(unit):
        order[unit] = low[unit] = len(order)
        stack.append(unit)
        for other in graph.get(unit, ()):
            if other not in order:
                visit(other)
            if other in stack:
                low[unit] = min(low[unit], low[other])
        if low[unit] == order[unit]:
            loop = stack[stack.index(unit):]
            del stack[stack.index(unit):]
            if len(loop) > 1:
                loops.append(loop)

    sys.setrecursionlimit(10_000)
    for unit in graph:
        if unit not in order:
            visit(unit)
    return loops


def prose(text):
    """The lines of a page that are neither tables, code nor pictures."""
    return [line for line in text.splitlines() if not re.match(r"\||    |!\[|```", line)]


def pages_without_headings(pages):
    """Pages of which a screen or more has no heading."""
    def is_long(text):
        gap = 0
        for line in text.splitlines():
            gap = 0 if line.startswith("#") else gap + 1
            if gap > SCREEN:
                return True
        return False
    return sum(is_long(text) for text in pages)


BARE = re.compile(r"[-+]?(\d[\d'.]*(e[-+]?\d+)?|\.\d+|0x[\da-fA-F]+)[fFuUlL]*|true|false", re.IGNORECASE)
# Tables of published numbers, whose columns a comment or the source names.
EXEMPT_ROWS = ("src/*/data_*.h", "src/import/pbrt/data_*.h", "src/procedural/sky.cpp")


def without_texts(source):
    """The source without comments, and with "" for each text."""
    source = re.sub(r'R"\((.*?)\)"', '""', source, flags=re.DOTALL)
    return re.sub(r'"(?:[^"\\\n]|\\.)*"', '""', re.sub(r"//[^\n]*", "", source))


def brace_lists(source):
    """Yields (what stands before, items) of each list in braces, the inner ones first."""
    stack = []  # of [begin, items, begin of the item, depth of other brackets]
    for at, char in enumerate(source):
        if char == "{":
            stack.append([at, [], at + 1, 0])
        elif not stack:
            continue
        elif char in "([":
            stack[-1][3] += 1
        elif char in ")]":
            stack[-1][3] -= 1
        elif char in ",}" and stack[-1][3] == 0:
            begin, items, start, _ = stack[-1]
            items.append(source[start:at].strip())
            stack[-1][2] = at + 1
            if char == "}":
                stack.pop()
                outer = stack[0][0] if stack else begin
                yield source[max(0, begin - 80):begin], source[max(0, outer - 80):outer], items


def bare_rows(root):
    """Rows of three or more bare numbers or truth values for the fields of a struct, so that only
    its definition says which is which. Vectors and arrays of one kind of number are no rows."""
    files = [f for top in ("src", "apps") for f in sorted((root / top).rglob("*"))
             if f.suffix in check_layers.SUFFIXES]
    sources = {f.relative_to(root): without_texts(f.read_text(encoding="utf-8")) for f in files}
    structs = {name for text in sources.values() for name in re.findall(r"struct (\w+) {", text)}
    for file, text in sources.items():
        if any(file.match(pattern) for pattern in EXEMPT_ROWS):
            continue
        for before, outer, items in brace_lists(text):
            if any(";" in item for item in items):
                continue  # statements
            type_of = (re.search(r"(\w+)\s+\w+\s*=?\s*$", before)
                       or re.search(r"\b(\w+)\s*$", before)
                       or re.search(r"array<(\w+), \d+>\s+\w+\s*=?\s*$", outer))
            is_struct = '""' in items or bool(type_of and type_of[1] in structs)
            if is_struct and sum(bool(BARE.fullmatch(item)) for item in items) >= 3:
                yield f"{file}: {{{', '.join(items)}}}"


def words_that_left(root, rows):
    return sum(len(list(check_words.check_gone(name, text, rows)))
               for _, name, text in check_words.text_files(root))


def main(root):
    files = check_layers.read_includes(root)
    layers = check_layers.read_layers((root / "src/layers.txt").read_text(encoding="utf-8"))
    modules = root / "cmake/modules.cmake"
    needs = check_layers.read_needs(modules.read_text(encoding="utf-8")) if modules.exists() else {}
    gone = Path(__file__).parent / "words_gone.txt"
    loops = loops_among(files)
    pages = [f.read_text(encoding="utf-8") for f in sorted((root / "docs").rglob("*.md"))]
    print("words that left:", words_that_left(root, check_words.read_gone(gone.read_text())))
    print("loops among units:", len(loops), "of", sum(map(len, loops)), "units")
    print("false and missing edges of modules:",
          len(list(check_layers.check_needs(needs, files, layers[0]))))
    print("rows of bare literals:", len(list(bare_rows(root))))
    print("longest line of prose in docs:", max(len(line) for p in pages for line in prose(p)))
    print("pages with a screen without a heading:", pages_without_headings(pages))


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
