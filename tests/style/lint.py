#!/usr/bin/env python3
"""clang-tidy by the rules in .clang-tidy over core and app; what was found clean is remembered by content.

usage: lint.py [--build DIR] [FILE...]     FILE: what to lint of core and app, a header with a file that includes it; all without

Files are read several at a time: most of clang-tidy's time goes into the headers, which one process then reads once.
A group in which something is found, or whose files do not go together, is halved until it is clean or one file.
"""
import argparse
import concurrent.futures
import functools
import hashlib
import json
import os
import re
import shlex
import subprocess
import sys
import threading
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CLEAN = ROOT / "build/lint"
GROUP = 12
TIDY = ["clang-tidy", "--quiet", "--warnings-as-errors=*"]
OUTPUT = re.compile(r" -o (\S+)")
UNNAMED = re.compile(r"^namespace \{\n(.*?)^\}  // namespace$", re.DOTALL | re.MULTILINE)
DECLARED = re.compile(r"^(?!namespace)(?:(?:struct|class|enum class|enum) (\w+)|[A-Za-z].*?([A-Za-z_]\w*)\s*[({=;\[])", re.MULTILINE)


def flags_of(command):
    """What clang-tidy needs to know of a compile command."""
    words = iter(shlex.split(command))
    kept = []
    for word in words:
        if word in ("-isystem", "-I", "-D", "-include"):
            kept += [word, next(words)]
        elif word.startswith(("-I", "-D", "-std=", "-f")) and not word.startswith("-fsanitize"):
            kept.append(word)
    return tuple(kept)


class Sources:
    """The files of core and app, with how each is compiled and what it includes."""

    def __init__(self, build):
        self.build = build
        commands = json.loads((build / "compile_commands.json").read_text())
        objects = {OUTPUT.search(entry["command"])[1]: Path(entry["file"]) for entry in commands}
        self.flags = {Path(entry["file"]): flags_of(entry["command"]) for entry in commands}
        self.included = {}
        file = None
        for line in subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True).stdout.splitlines():
            if line.startswith(" "):
                if file is not None:
                    self.included[file].append(Path(os.path.normpath(build / line.strip())))
            elif ": #deps" in line:
                file = objects.get(line.split(":")[0])
                self.included.setdefault(file, [])
        self.hashes = {}

    def all(self):
        modules = (ROOT / "core", ROOT / "app")
        return sorted(file for file in self.flags if file.exists() and any(map(file.is_relative_to, modules)))

    def unit(self, file):
        """The file itself, or the one that a header is read with: its namesake if there is one."""
        if file in self.flags:
            return file
        including = [unit for unit in self.all() if file in self.included.get(unit, [])]
        return min(including, key=lambda unit: (unit.with_suffix("") != file.with_suffix(""), unit), default=None)

    def content(self, file):
        """A file's hash; headers of the system are known by size and time."""
        if file not in self.hashes:
            if not file.exists():
                self.hashes[file] = "none"
            elif file.is_relative_to(ROOT):
                self.hashes[file] = hashlib.sha256(file.read_bytes()).hexdigest()
            else:
                self.hashes[file] = f"{file.stat().st_size} {file.stat().st_mtime_ns}"
        return self.hashes[file]

    def key(self, file, rules):
        """What decides whether a file is clean: rules, flags, its text and that of all it includes."""
        files = sorted({file, *self.included.get(file, [])})
        text = [rules, *self.flags[file], *(f"{name} {self.content(name)}" for name in files)]
        return hashlib.sha256("\n".join(map(str, text)).encode()).hexdigest()


def declared(text):
    """The names that are declared at a line's head, as far as a glance tells."""
    return {one or other for one, other in DECLARED.findall(text)}


def groups(files, sources):
    """Files that are compiled alike and use no name for two things, at most GROUP together."""
    in_header = functools.cache(lambda header: declared(header.read_text()))
    made = []
    for file in files:
        own = {name for body in UNNAMED.findall(file.read_text()) for name in declared(body)}
        headers = [name for name in sources.included.get(file, []) if name.is_relative_to(ROOT) and name != file and name.exists()]
        shared = set().union(*map(in_header, headers))
        for group in made:
            alike = group["flags"] == sources.flags[file] and len(group["files"]) < GROUP
            if alike and not own & (group["own"] | group["shared"]) and not shared & group["own"]:
                break
        else:
            group = {"flags": sources.flags[file], "files": [], "own": set(), "shared": set()}
            made.append(group)
        group["files"].append(file)
        group["own"] |= own
        group["shared"] |= shared
    return sorted((group["files"] for group in made), key=len, reverse=True)


def tidy(file, flags):
    run = subprocess.run([*TIDY, file, "--", *flags], capture_output=True, text=True, cwd=ROOT)
    return run.returncode == 0, run.stdout


def lint(group, sources):
    """A list of (file, clean, what clang-tidy said) for the files of a group; one that is not clean is halved."""
    flags = sources.flags[group[0]]
    if len(group) == 1:
        return [(group[0], *tidy(group[0], flags))]
    together = CLEAN / f"group-{threading.get_ident()}.cpp"
    together.write_text("".join(f'#include "{file}"  // NOLINT\n' for file in group))
    if tidy(together, flags)[0]:
        return [(file, True, "") for file in group]
    half = len(group) // 2
    return lint(group[:half], sources) + lint(group[half:], sources)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", type=Path, default=ROOT / "build/release")
    parser.add_argument("files", nargs="*", type=lambda name: Path(name).resolve())
    arguments = parser.parse_args()
    CLEAN.mkdir(parents=True, exist_ok=True)
    sources = Sources(arguments.build.resolve())
    rules = (ROOT / ".clang-tidy").read_text() + subprocess.run(["clang-tidy", "--version"], capture_output=True, text=True).stdout
    wanted = sources.all()
    if arguments.files:
        wanted = sorted(set(wanted) & {sources.unit(file) for file in arguments.files})
    keys = {file: sources.key(file, rules) for file in wanted}
    unknown = [file for file in wanted if not (CLEAN / keys[file]).exists()]
    dirty = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for results in pool.map(lambda group: lint(group, sources), groups(unknown, sources)):
            for file, clean, said in results:
                if clean:
                    (CLEAN / keys[file]).touch()
                else:
                    dirty += 1
                    print(said, flush=True)
    print(f"lint: {len(wanted)} files, {len(wanted) - len(unknown)} of them known clean, {dirty} not clean")
    sys.exit(bool(dirty))


main()
