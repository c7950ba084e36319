#!/usr/bin/env python3
"""Runs the commands of the guide, shortened, so that none is there that does not work.

Usage: guide_commands.py PROGRAM PAGE...

Each indented block of a page is commands for bash, unless a comment stands above it:
    <!-- file NAME -->          the block is a file of that name
    <!-- listing -->            the block is no commands
    <!-- not run: REASON -->    only the block's syntax and its flags are checked
    <!-- first: COMMANDS -->    before the block, what the page takes for granted is made
Blocks of a page run in its order, in one new folder. `sunfleck` is PROGRAM there, with small
pictures and few passes: see SHORTER. Prints one line for each fault; exit code 1 when there is one.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

COMMENT = re.compile(r"<!-- (file|listing|not run|first):?(?: (.*?))? -->", re.DOTALL)
BLOCK = re.compile(r"(?:(?<=\n\n) {4}.*\n)(?:\n*(?: {4}.*\n))*")
FLAG = re.compile(r"(?<!\S)(--[a-z][a-z-]*)")
LIMIT = 60  # seconds of a page

# A script in place of `sunfleck`: it replaces the limits of renders and experiments by small ones.
SHORTER = """#!/bin/bash
program=@PROGRAM@
command=$1
arguments=()
passes=(--passes 2)
while (($#)); do
  case $command$1 in
    render--time | render--cpu-time | render--target-error | render--passes | \\
      render--resolution | experiment--minutes) shift ;;
    render--pass-range) passes=() arguments+=("$1") ;;
    *) arguments+=("$1") ;;
  esac
  shift
done
case $command in
  render) arguments+=("${passes[@]}" --resolution 24x16 --photons-per-pass 2000 --quiet) ;;
  experiment) ((${#arguments[@]} > 1)) &&
      arguments+=(--passes 2 --seeds 1 --scale 0.04 --reference-budget 1) ;;
esac
exec "$program" "${arguments[@]}"
"""


def blocks(text):
    """The indented blocks of a page, each with its line number and kind and text of its comment."""
    for block in BLOCK.finditer(text):
        above = text[:block.start()]
        comment = COMMENT.search(above[above.rfind("<!--"):]) if above.endswith("-->\n\n") else None
        lines = (line[4:] for line in block[0].splitlines())
        yield above.count("\n") + 1, comment and comment.groups(), "\n".join(lines) + "\n"


def check_without_running(block, flags):
    """What is wrong with commands that cannot run here, or None."""
    syntax = subprocess.run(["bash", "-n"], input=block, text=True, capture_output=True)
    if syntax.returncode:
        return syntax.stderr.strip()
    for command in re.sub(r"\\\n", " ", block).splitlines():
        call = re.search(r"\bsunfleck (\w+)(.*)", command)
        for flag in FLAG.findall(call[2]) if call else ():
            if flag not in flags(call[1]):
                return f"`sunfleck {call[1]}` has no flag {flag}"
    return None


def run(block, folder):
    """What a block says when it fails, or None."""
    environment = {"PATH": f"{folder}/bin:/usr/bin:/bin", "HOME": str(folder)}
    try:
        done = subprocess.run(["bash", "-e", "-o", "pipefail", "-c", block], cwd=folder / "work",
                              env=environment, text=True, capture_output=True, timeout=LIMIT)
    except subprocess.TimeoutExpired:
        return f"takes more than {LIMIT} s"
    if done.returncode == 0:
        return None
    return f"ends with {done.returncode}: " + (done.stderr.strip() or done.stdout.strip())


def check_page(page, folder, flags):
    """Yields the faults of one page."""
    for line, comment, block in blocks(page.read_text(encoding="utf-8")):
        kind, text = comment or (None, None)
        fault = None
        if kind == "file":
            (folder / "work" / text).write_text(block, encoding="utf-8")
        elif kind == "not run":
            fault = check_without_running(block, flags)
        elif kind != "listing":
            fault = (kind == "first" and run(text, folder)) or run(block, folder)
        if fault:
            yield f"{page}:{line}: {fault}"


def main(program, pages):
    """Checks all pages; returns the exit code."""
    known = {}

    def flags(command):
        if command not in known:
            answer = subprocess.run([program, command, "--help"], text=True, capture_output=True)
            known[command] = set(re.findall(r"--[a-z][a-z-]*", answer.stdout))
        return known[command]

    faults = []
    for page in pages:
        with tempfile.TemporaryDirectory() as scratch:
            folder = Path(scratch)
            (folder / "bin").mkdir()
            (folder / "work").mkdir()
            (folder / "bin/sunfleck").write_text(SHORTER.replace("@PROGRAM@", program))
            (folder / "bin/sunfleck").chmod(0o755)
            faults += check_page(Path(page), folder, flags)
    print("\n".join(faults) or f"{len(pages)} pages: every command works")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(str(Path(sys.argv[1]).resolve()), sys.argv[2:]))
