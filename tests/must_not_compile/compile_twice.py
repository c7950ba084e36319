#!/usr/bin/env python3
"""Compiles a file of this folder without its fault, which must work, and with it, which must not.

Usage: compile_twice.py FILE COMPILER [FLAGS...]. The file says in a line `// Refused with: REGEX`
what the compiler must complain of, so that it does not fail for a reason of its own.
"""

import re
import subprocess
import sys
from pathlib import Path


def compile_once(file, command):
    done = subprocess.run([*command, "-fsyntax-only", file], capture_output=True, text=True,
                          check=False)
    return done.returncode, done.stderr


def main(file, command):
    wanted = re.search(r"^// Refused with: (.+)$", Path(file).read_text(encoding="utf-8"), re.M)
    if not wanted:
        return f"{file}: no line `// Refused with: REGEX`; say what the compiler must complain of"
    code, complaint = compile_once(file, command)
    if code:
        return f"{file}: does not compile without its fault; mend the file\n{complaint}"
    code, complaint = compile_once(file, [*command, "-DFAULT"])
    if not code:
        return f"{file}: compiles with its fault; the code must refuse it"
    if not re.search(wanted[1], complaint):
        return f"{file}: is refused for another reason than `{wanted[1]}`\n{complaint}"
    return ""


if __name__ == "__main__":
    fault = main(sys.argv[1], sys.argv[2:])
    print(fault or "refused, as it must be")
    sys.exit(1 if fault else 0)
