#!/usr/bin/env bash
# Renders a fixed list of scenes and prints the hash of each picture's values: two programs that
# print the same table make the same pictures.
# Usage: picture_hashes.sh [--quick] [PROGRAM]    (default program: build/release/bin/sunfleck)
#   --quick  one seed, 6 passes, the half of the list that is quickest: two minutes
# Builds build/release's picture_hash where it is missing. Public scenes are rendered where
# ../shared/data has them.
set -euo pipefail
cd "$(dirname "$0")/.."
quick=0
if [[ ${1:-} == --quick ]]; then quick=1 && shift; fi
program=$(realpath "${1:-build/release/bin/sunfleck}")
hasher=build/release/bin/picture_hash
if [[ ! -x $hasher ]]; then cmake --build build/release --target picture_hash >&2; fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

if [[ $quick == 1 ]]; then
    scenes=(cornell cognac-1 window-room watch keyhole-6)
    seeds=(1)
    passes=6
else
    scenes=(cornell cognac-1 cognac-4 window-room iced-tea watch statue-near useless-light
        keyhole-6 two-windows)
    seeds=(1 2)
    passes=20
fi
integrators=("--mode paper" "--integrator path" "--integrator bdpt" "--integrator mlt"
    "--integrator light")
public=(TestShapes/test_curve_bezier_types TestMaterials/test_mix_material
    TestInstance/test_full_instance)

# Renders SCENE with FLAGS and prints the hash before NAME.
print_hash() {
    local name=$1 scene=$2
    shift 2
    "$program" render "$scene" -o "$folder/picture.exr" --resolution 96x96 --passes $passes \
        --log-level quiet "$@"
    printf '%s  %s\n' "$("$hasher" "$folder/picture.exr" | cut -c 1-16)" "$name"
}

for scene in "${scenes[@]}"; do
    "$program" scene "$scene" -o "$folder" >/dev/null
    for seed in "${seeds[@]}"; do
        print_hash "$scene $seed" "$folder/$scene.pbrt" --seed "$seed"
    done
done
for flags in "${integrators[@]}"; do
    # shellcheck disable=SC2086  # two words
    print_hash "cornell $flags" "$folder/cornell.pbrt" $flags --seed 1
done
for file in "${public[@]}"; do
    scene=../shared/data/pbrt-conformance/scenes/$file.pbrt
    if [[ -e $scene ]]; then print_hash "$(basename "$file")" "$scene" --seed 1; fi
done
