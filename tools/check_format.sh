#!/usr/bin/env bash
# Checks that all our C++ is laid out as .clang-format says. Usage: check_format.sh [REPOSITORY].
# Exit code 0: it is; 1: clang-format says where it is not; 77: there is no clang-format 14.
set -euo pipefail
cd "${1:-.}"

format=$(command -v clang-format-14 || true)
if [[ -z $format ]]; then
    echo "format: skipped, for there is no clang-format-14; tools/setup.sh test installs it"
    exit 77
fi

folders=()
for folder in include src apps python examples tests bench tools; do
    if [[ -d $folder ]]; then folders+=("$folder"); fi
done
find "${folders[@]}" -name '*.h' -o -name '*.cpp' | sort | xargs "$format" --dry-run --Werror
echo "format: no faults"
