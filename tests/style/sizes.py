#!/usr/bin/env python3
"""No source file has more than 350 lines, and only tables are functions of more than 60; sizes.txt holds the exceptions.

clang-tidy counts the lines of functions. Here is counted where it is told not to.
"""
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MOST_LINES = 350
UNCOUNTED = re.compile(r"NOLINT\w*\(.*readability-function-size.*\)(?!: a table)")


def source_files():
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard", "core", "app", "tests"],
        cwd=ROOT, capture_output=True, text=True, check=True).stdout.split()
    return [file for file in listed if file.endswith((".h", ".cpp", ".inc")) and (ROOT / file).exists()]


def offences():
    """The lines that sizes.txt would have to hold, with what is wrong."""
    found = {}
    for file in source_files():
        text = (ROOT / file).read_text()
        lines = text.count("\n")
        if lines > MOST_LINES:
            found[f"file {file}"] = f"{file} has {lines} lines, more than {MOST_LINES}"
        if UNCOUNTED.search(text):
            found[f"function {file}"] = f"{file} has a function that is too long and no table"
    return found


excepted = {line for line in (ROOT / "tests/style/sizes.txt").read_text().splitlines() if line and not line.startswith("#")}
found = offences()
faults = [said for line, said in found.items() if line not in excepted]
faults += [f"tests/style/sizes.txt excepts {line}, which is not needed" for line in sorted(excepted - set(found))]
print("\n".join(faults), file=sys.stderr)
sys.exit(bool(faults))
