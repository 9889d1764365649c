#!/usr/bin/env python3
"""Builds and tests what a change can have broken, and says where the time went.

usage: check.py [--all] [FILE...]    FILE: what has changed; without one, what differs from main, and what git does not know yet

Of the changed files: format, clang-tidy, the order of modules. Then the tests of their modules and of the modules that include them,
the contracts, the short digests and the allocations. --all: every test but `long` and `window`, and clang-tidy of everything.
"""
import argparse
import os
import re
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
BUILD = ROOT / "build/release"
SOURCE = (".h", ".cpp", ".inc")
# What holds for all of core.
CORE_ALWAYS = {"contracts", "allocation", "digests"}
PROGRAMS = {"core": "core", "app": "app", "contracts": "contract", "golden": "golden", "digests": "golden", "allocation": "allocation", "e2e": "cli"}
took = {}


def git(*arguments):
    run = subprocess.run(["git", *arguments], cwd=ROOT, capture_output=True, text=True)
    return run.stdout.split() if run.returncode == 0 else []


def changed_files():
    base = (git("merge-base", "HEAD", "main") or ["HEAD"])[0]
    return set(git("diff", "--name-only", base)) | set(git("ls-files", "--others", "--exclude-standard"))


def module_of(file):
    """The folder of a module: core/grid of core/grid/field.h and of tests/core/grid/field_test.cpp."""
    parts = Path(file).parts
    if parts[0] == "tests":
        parts = parts[1:]
    return "/".join(parts[:2] if parts[0] in ("core", "app") else parts[:1])


def modules_of(changed):
    """The modules of the changed files, and those that include one of them or the header of one."""
    headers = {re.sub(r"\.cpp$", ".h", file) for file in changed}
    pattern = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)
    modules = {module_of(file) for file in changed}
    for file in git("ls-files", "--cached", "--others", "--exclude-standard", "core", "app", "tests"):
        if file.endswith(SOURCE) and (ROOT / file).exists():
            if headers & set(pattern.findall((ROOT / file).read_text())):
                modules.add(module_of(file))
    if "app/cli" in modules or "app/main.cpp" in modules:
        modules.add("e2e")
    if any(module.startswith("core/") for module in modules):
        modules |= CORE_ALWAYS
    return modules


def part(name, *command):
    """Runs a part, whose time is told at the end; whether it went well."""
    began = time.monotonic()
    good = subprocess.run([*map(str, command)], cwd=ROOT).returncode == 0
    took[name] = took.get(name, 0) + time.monotonic() - began
    if not good:
        print(f"check: {name} FAILED", file=sys.stderr)
    return good


def ctest(*selection):
    return part("tests", "ctest", "--test-dir", BUILD, "--output-on-failure", f"--parallel={os.cpu_count()}", "--no-label-summary", *selection)


def check_all():
    return (part("build", "cmake", "--build", BUILD)
            & ctest("--label-exclude", "^(long|window)$")
            & part("lint", "tests/style/lint.py"))


def check(changed):
    sources = sorted(file for file in changed if file.endswith(SOURCE) and (ROOT / file).exists())
    modules = modules_of(sources)
    print("check:", *(sources or ["no source file has changed"]))
    good = all([part("style", f"tests/style/{name}") for name in ("modules.py", "sizes.py")])
    if not sources:
        return good
    good &= part("style", "clang-format", "--dry-run", "-Werror", *sources)
    programs = {PROGRAMS[module.split("/")[0]] for module in modules if module.split("/")[0] in PROGRAMS}
    if not programs:
        return part("build", "cmake", "--build", BUILD) and good
    if not part("build", "cmake", "--build", BUILD, "--target", *(f"whorl_{name}_tests" for name in sorted(programs))):
        return False
    labels = "|".join(sorted(modules))
    return good & ctest("--label-regex", f"^({labels})$", "--label-exclude", "^(long|window)$") & part("lint", "tests/style/lint.py", *sources)


parser = argparse.ArgumentParser()
parser.add_argument("--all", action="store_true")
parser.add_argument("files", nargs="*", type=lambda name: str(Path(name).resolve().relative_to(ROOT)))
arguments = parser.parse_args()
good = check_all() if arguments.all else check(set(arguments.files) or changed_files())
print("check:", ", ".join(f"{name} {seconds:.0f} s" for name, seconds in took.items()) + f": {sum(took.values()):.0f} s in all")
sys.exit(not good)
