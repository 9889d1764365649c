#!/usr/bin/env python3
"""Writes a ctest for each suite of a test program: `module.Suite`, with the folder of its file under tests as its label.

usage: suites.py PROGRAM OUT.cmake [SUITE=LABEL...]     SUITE=LABEL: a further label
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path


def suites(program):
    """{suite: modules that its cases lie in}, without the prefixes and numbers of parameterised suites."""
    with tempfile.NamedTemporaryFile() as listed:
        subprocess.run([program, "--gtest_list_tests", f"--gtest_output=json:{listed.name}"], check=True, stdout=subprocess.DEVNULL)
        found = {}
        for suite in json.load(listed)["testsuites"]:
            words = suite["name"].split("/")
            name = next(word for word in words[1:] + words if not word.isdigit()) if len(words) > 1 else words[0]
            for case in suite["testsuite"]:
                module = Path(case["file"].rpartition("/tests/")[2]).parent
                found.setdefault(name, set()).add(str(module))
    return found


program, out, *further = sys.argv[1:]
labels_of = dict(word.split("=") for word in further)
lines = []
for name, modules in sorted(suites(program).items()):
    if len(modules) > 1:
        sys.exit(f"suites.py: the suite {name} lies in two modules: {', '.join(sorted(modules))}")
    module = modules.pop()
    cases = f"{name}.*:{name}/*:*/{name}.*:*/{name}/*"
    labels = [module, *filter(None, [labels_of.get(name)])]
    lines.append(f'add_test([=[{module}.{name}]=] "{program}" "--gtest_filter={cases}" --gtest_brief=1)')
    lines.append(f'set_tests_properties([=[{module}.{name}]=] PROPERTIES LABELS "{";".join(labels)}" TIMEOUT 900)')
Path(out).write_text("\n".join(lines) + "\n")
