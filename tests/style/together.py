#!/usr/bin/env python3
"""Source files that can be compiled as one, since none of them uses a name of its own that another one uses too.

usage: together.py [--most N] FILE...    prints the groups, a line each
"""
import argparse
import functools
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
UNNAMED = re.compile(r"^namespace \{\n(.*?)^\}  // namespace$", re.DOTALL | re.MULTILINE)
DECLARED = re.compile(r"^(?!namespace)(?:(?:struct|class|enum class|enum) (\w+)|[A-Za-z].*?([A-Za-z_]\w*)\s*[({=;\[])", re.MULTILINE)
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


@functools.cache
def declared(text):
    """The names that are declared at a line's head, as far as a glance tells."""
    return frozenset(name for name in map("".join, DECLARED.findall(text)) if not name.isupper())  # TEST is no name


@functools.cache
def read(file):
    return file.read_text()


def headers(file):
    """The headers of the project that a file includes, itself or through others."""
    found, waiting = set(), [file]
    while waiting:
        for name in INCLUDE.findall(read(waiting.pop())):
            header = ROOT / name
            if header not in found and header.exists():
                found.add(header)
                waiting.append(header)
    return found


def groups(files, most, flags=lambda file: None):
    """Files that are compiled alike and use no name for two things, at most so many together; the largest groups first."""
    made = []
    for file in files:
        own = {name for body in UNNAMED.findall(read(file)) for name in declared(body)}
        shared = set().union(*(declared(read(header)) for header in headers(file)))
        for group in made:
            alike = group["flags"] == flags(file) and len(group["files"]) < most
            if alike and not own & (group["own"] | group["shared"]) and not shared & group["own"]:
                break
        else:
            group = {"flags": flags(file), "files": [], "own": set(), "shared": set()}
            made.append(group)
        group["files"].append(file)
        group["own"] |= own
        group["shared"] |= shared
    return sorted((group["files"] for group in made), key=len, reverse=True)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--most", type=int, default=12)
    parser.add_argument("files", nargs="+", type=Path)
    arguments = parser.parse_args()
    for group in groups(arguments.files, arguments.most):
        print(*group)
