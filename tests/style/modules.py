#!/usr/bin/env python3
"""Holds every include of core and app to the order of modules in modules.txt; prints the two files where one breaks it."""
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
INCLUDE = re.compile(r'^\s*#\s*include\s*"((?:core|app)/[^"]+)"', re.MULTILINE)


def read_rules(text):
    """The level of each module, and the excepted (file, included) pairs."""
    levels, excepted = {}, set()
    for number, line in enumerate(text.splitlines()):
        words = line.split("#")[0].split()
        if words[:1] == ["except"]:
            excepted.add((words[1], words[2]))
        else:
            levels.update(dict.fromkeys(words, number))
    return levels, excepted


def module_of(file, levels):
    """The module that a file lies in: a folder, or the file itself; None if it lies in none."""
    return next((module for module in (file, *map(str, Path(file).parents)) if module in levels), None)


def source_files():
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard", "core", "app"],
        cwd=ROOT, capture_output=True, text=True, check=True).stdout.split()
    return [file for file in listed if file.endswith((".h", ".cpp", ".inc")) and (ROOT / file).exists()]


def faults():
    levels, excepted = read_rules((ROOT / "tests/style/modules.txt").read_text())
    unused = set(excepted)
    for file in source_files():
        module = module_of(file, levels)
        if module is None:
            yield f"{file} is in no module of tests/style/modules.txt"
            continue
        for included in INCLUDE.findall((ROOT / file).read_text()):
            other = module_of(included, levels)
            if other is None or other == module or levels[other] < levels[module]:
                continue
            permits = {(file, included), (file, other)} & excepted
            unused -= permits
            if not permits:
                yield f"{file} includes {included}, but {module} does not come after {other}"
    for file, included in sorted(unused):
        yield f"tests/style/modules.txt excepts {file} {included}, which is not needed"


found = list(faults())
print("\n".join(found), file=sys.stderr)
sys.exit(bool(found))
