#!/usr/bin/env bash
# Runs the add-on's tests: those without Blender, those inside it, and an installation of the .zip.
# Usage: run.sh PROGRAM pure|blender|zip. Exit code 77 (skipped) where Blender or numpy is missing.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "$1")
python=/usr/bin/python3
[[ -x $python ]] || python=python3

if [[ $2 == pure ]]; then
    if ! "$python" -c "import numpy" 2>/dev/null; then
        echo "skipped: $python has no numpy (python3-numpy)"
        exit 77
    fi
    exec "$python" -m unittest discover -s "$here" -p "test_pure.py"
fi
if ! command -v blender >/dev/null; then
    echo "skipped: Blender is not installed (tools/setup.sh blender)"
    exit 77
fi
# A home of its own: neither the user's add-ons nor settings count, nor are they touched.
home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
export HOME=$home BLENDER_USER_CONFIG=$home/config BLENDER_USER_SCRIPTS=$home/scripts
if ! blender -b --factory-startup --python-exit-code 1 --python-expr "import numpy" >/dev/null 2>&1
then
    echo "skipped: Blender's Python has no numpy (python3-numpy)"
    exit 77
fi
if [[ $2 == zip ]]; then
    "$python" "$here/../make_zip.py" "$home/sunfleck_blender.zip"
    PATH=$(dirname "$program"):$PATH blender -b --factory-startup --python-exit-code 1 \
        --python "$here/install_zip.py" -- "$home/sunfleck_blender.zip"
    exit
fi
blender -b --factory-startup --python-exit-code 1 --python "$here/test_in_blender.py" -- "$program"
