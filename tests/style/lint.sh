#!/usr/bin/env bash
# clang-tidy by the rules in .clang-tidy, over the sources of core and app.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
build=${1:-build/release}
git ls-files --cached --others --exclude-standard -- 'core/*.cpp' 'app/*.cpp' |
    xargs --max-args=1 --max-procs="$(nproc)" clang-tidy -p "$build" --quiet --warnings-as-errors='*' 2> >(grep -v 'warnings generated' >&2)
