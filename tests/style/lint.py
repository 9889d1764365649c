#!/usr/bin/env python3
"""clang-tidy by the rules in .clang-tidy over core and app; what was found clean is remembered by content.

usage: lint.py [--build DIR] [FILE...]     FILE: what to lint of core and app, a header with a file that includes it; all without

Files are read several at a time: most of clang-tidy's time goes into the headers, which one process then reads once.
A group in which something is found, or whose files do not go together, is halved until it is clean or one file.
"""
import argparse
import concurrent.futures
import hashlib
import json
import os
import shlex
import subprocess
import sys
import threading
from pathlib import Path

from together import INCLUDE, groups, headers

ROOT = Path(__file__).resolve().parents[2]
CLEAN = ROOT / "build/lint"
GROUP = 12
TIDY = ["clang-tidy", "--quiet", "--warnings-as-errors=*"]


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


def compiled(file):
    """The files that a compile command is of: several where they are compiled together."""
    return [Path(name) for name in INCLUDE.findall(file.read_text())] if "Unity" in file.parts else [file]


class Sources:
    """The files of core and app, with how each is compiled and what it includes."""

    def __init__(self, build):
        commands = json.loads((build / "compile_commands.json").read_text())
        self.flags = {file: flags_of(entry["command"]) for entry in commands for file in compiled(Path(entry["file"]))}
        self.included = {file: headers(file) for file in self.flags if file.exists() and file.is_relative_to(ROOT)}
        self.hashes = {}

    def all(self):
        modules = (ROOT / "core", ROOT / "app")
        return sorted(file for file in self.flags if file.exists() and any(map(file.is_relative_to, modules)))

    def unit(self, file):
        """The file itself, or the one that a header is read with: its namesake if there is one."""
        if file in self.flags:
            return file
        including = [unit for unit in self.all() if file in self.included[unit]]
        return min(including, key=lambda unit: (unit.with_suffix("") != file.with_suffix(""), unit), default=None)

    def content(self, file):
        if file not in self.hashes:
            self.hashes[file] = hashlib.sha256(file.read_bytes()).hexdigest()
        return self.hashes[file]

    def key(self, file, rules):
        """What decides whether a file is clean: rules, flags, its text and that of all of the project that it includes."""
        files = sorted({file, *self.included[file]})
        text = [rules, *self.flags[file], *(f"{name} {self.content(name)}" for name in files)]
        return hashlib.sha256("\n".join(map(str, text)).encode()).hexdigest()


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
        for results in pool.map(lambda group: lint(group, sources), groups(unknown, GROUP, sources.flags.get)):
            for file, clean, said in results:
                if clean:
                    (CLEAN / keys[file]).touch()
                else:
                    dirty += 1
                    print(said, flush=True)
    print(f"lint: {len(wanted)} files, {len(wanted) - len(unknown)} of them known clean, {dirty} not clean")
    sys.exit(bool(dirty))


main()
