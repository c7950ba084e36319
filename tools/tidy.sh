#!/usr/bin/env bash
# Runs clang-tidy 14 over our C++. Usage: tidy.sh [FILE...]; without files, all of src/, apps/,
# tests/ and tools/ that the release build compiles. Warnings that g++ alone knows are let pass; so that g++'s
# compiled headers are not looked for, the commands stand in a folder of their own, build/tidy.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release -B build/tidy -DSUNFLECK_TESTS=ON \
    -DSUNFLECK_TOGETHER=OFF -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null

files=("$@")
if [[ $# == 0 ]]; then
    mapfile -t files < <(sed -n "s|^ *\"file\": \"$PWD/\(.*\)\",*$|\1|p" \
        build/tidy/compile_commands.json | grep -E '^(src|apps|tests|tools)/' | sort -u)
fi
jobs=$(nproc)
printf '%s\n' "${files[@]}" |
    xargs -P "$((jobs < 4 ? jobs : 4))" -n 4 \
        clang-tidy-14 -p build/tidy --quiet --extra-arg=-Wno-unknown-warning-option
echo "tidy: no faults in ${#files[@]} files"
