#!/usr/bin/env bash
# Runs the quick tests under the sanitizers of g++: address and undefined behaviour, then threads.
# Usage: sanitize.sh [asan|tsan]; without a word, both. Folders build/asan and build/tsan.
set -euo pipefail
cd "$(dirname "$0")/.."
jobs=$(nproc)

# The quick tests, and of those no page in a browser: Chromium is not what is looked at here.
# Programs that this build leaves out are no faults: a program that should be built and is not ends
# the script before any test starts.
tests=(--output-on-failure --no-tests=error -LE 'slow|nightly|check|browser' -E '_NOT_BUILT$')

# Everything quick. Leaks are looked for; TBB and Embree keep some memory until the very end.
run_asan() {
    cmake --preset asan
    cmake --build build/asan -j "$jobs" --target tests_quick
    ASAN_OPTIONS=detect_stack_use_after_return=1:strict_string_checks=1 \
    LSAN_OPTIONS=suppressions=$PWD/tools/lsan.supp:print_suppressions=0 \
    UBSAN_OPTIONS=print_stacktrace=1 \
        ctest --test-dir build/asan -j "$jobs" "${tests[@]}"
}

# What threads share: the loops, the sums, and every module that runs loops. The run time of g++ 12
# wants memory laid out without chance. See core/parallel.cpp for what runs the loops here.
threaded=(core camera_paths estimate photon film render library)
run_tsan() {
    cmake --preset tsan
    cmake --build build/tsan -j "$jobs" --target "${threaded[@]/#/tests_}"
    TSAN_OPTIONS=suppressions=$PWD/tools/tsan.supp:print_suppressions=0:halt_on_error=1 \
        setarch "$(uname -m)" -R \
        ctest --test-dir build/tsan -j "$jobs" "${tests[@]}" \
            -R "^($(IFS='|' && echo "${threaded[*]}"))\\."
}

case ${1:-both} in
    asan) run_asan ;;
    tsan) run_tsan ;;
    both) run_asan && run_tsan ;;
    *) echo "usage: tools/sanitize.sh [asan|tsan]" >&2 && exit 2 ;;
esac
