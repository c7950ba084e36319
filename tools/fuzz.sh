#!/usr/bin/env bash
# Builds the fuzz targets and runs them. Usage: fuzz.sh build, or fuzz.sh SECONDS [NAME...].
# Each run starts from tests/fuzz/corpus/NAME and keeps what it learns in build/fuzz/corpus/NAME;
# an input that fails is left in build/fuzz/found. Exit code 77: there is no clang 14 to build with.
set -euo pipefail
cd "$(dirname "$0")/.."
usage="usage: tools/fuzz.sh build | SECONDS [NAME...]"
what=${1:?$usage}
shift

if ! command -v clang++-14 >/dev/null; then
    echo "fuzz: skipped, for there is no clang++-14; tools/setup.sh test installs it"
    exit 77
fi

if [[ $what == build || $# == 0 ]]; then
    cmake --preset fuzz >/dev/null
    cmake --build build/fuzz --target fuzzers
fi
if [[ $what == build ]]; then exit; fi

names=("$@")
if [[ $# == 0 ]]; then
    for source in tests/fuzz/fuzz_*.cpp; do
        name=${source#tests/fuzz/fuzz_}
        names+=("${name%.cpp}")
    done
fi
for name in "${names[@]}"; do
    corpus=build/fuzz/corpus/$name
    mkdir -p "$corpus" build/fuzz/found
    flags=(-seed=1 -max_total_time="$what" -timeout=20 -rss_limit_mb=2048 -verbosity=0
        -print_final_stats=1 -artifact_prefix="build/fuzz/found/$name-")
    if [[ -f tests/fuzz/$name.dict ]]; then flags+=(-dict="tests/fuzz/$name.dict"); fi
    echo "fuzz: $name for $what s"
    # Seeds are read first: a reader that fails on one of them fails at once.
    "build/fuzz/bin/fuzz_$name" "${flags[@]}" "$corpus" "tests/fuzz/corpus/$name" 2>&1 |
        sed '/^###### Recommended/,/^###### End/d'
done
