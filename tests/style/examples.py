#!/usr/bin/env python3
"""Holds documents to the code: a block of C++ that follows a line with (`FILE`) stands in that file as it is, every file that is
named is there, and README says of every module what it holds."""
import re
import sys
from pathlib import Path

root = Path(__file__).resolve().parents[2]
documents = [root / "README.md", root / "CONTRIBUTING.md", *sorted((root / "docs").glob("*.md"))]
wrong = []


def squeezed(text):
    """Without what clang-format may change."""
    return re.sub(r"\s+", " ", text).strip()


for document in documents:
    text = document.read_text()
    name = document.relative_to(root)
    for intro, block in re.findall(r"([^\n]*)\n\n```cpp\n(.*?)```", text, re.S):
        of = re.search(r"\(`([^`]+)`\)", intro)
        if of is None:
            wrong.append(f"{name}: a block of C++ says not which file it is from: {intro!r}")
        elif squeezed(block) not in squeezed((root / of.group(1)).read_text()):
            wrong.append(f"{name}: the block from {of.group(1)} is not as it stands there")
    for path in re.findall(r"`((?:app|core|docs|shaders|tests)/[\w./-]+\.\w+)`", text):
        if path.rpartition("/")[2].startswith("NAME."):
            path = path.rpartition("/")[0]
        if not (root / path).exists():
            wrong.append(f"{name}: there is no {path}")

readme = documents[0].read_text()
for line in (root / "tests/style/modules.txt").read_text().splitlines():
    if line.startswith(("core/", "app/")):
        for module in line.split():
            if (root / module).is_dir() and f"`{module}`" not in readme.partition("| module |")[2]:
                wrong.append(f"README.md: says nothing of the module {module}")

print("\n".join(wrong), end="\n" if wrong else "")
sys.exit(bool(wrong))
