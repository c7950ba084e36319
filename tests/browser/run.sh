#!/usr/bin/env bash
# Opens a page of `sunfleck compare` and that of a render under way in Debian's Chromium, and works
# them (page_test.mjs, live_test.mjs).
# Usage: run.sh SUNFLECK FOLDER. What npm brings and the pictures go to FOLDER.
# Exit code 77, with a line why, where Chromium, node or npm are missing or npm reaches no registry.
set -euo pipefail
program=$(realpath "$1")
here=$(dirname "$(realpath "$0")")
mkdir -p "$2"
cd "$2"

for tool in chromium node npm; do
    if ! command -v "$tool" >/dev/null; then
        echo "browser test skipped: there is no $tool (tools/setup.sh browser)"
        exit 77
    fi
done
if [[ ! -d node_modules/playwright-core ]]; then
    if ! PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD=1 timeout 120 npm install --silent --no-audit --no-fund \
        --prefix . playwright-core >npm.log 2>&1; then
        echo "browser test skipped: npm does not get playwright-core"
        exit 77
    fi
fi

# Renders over time of two samplers, and beside them pictures of known values (page_test.mjs).
rm -rf renders known && mkdir renders known
"$program" scene cornell -o renders >/dev/null
render=("$program" render renders/cornell.pbrt --resolution 64x48 --photons-per-pass 2000 --quiet)
"${render[@]}" -o renders/reference.exr --passes 32 --seed 9
for sampler in uniform adaptive; do
    for seed in 1 2 3; do
        "${render[@]}" -o renders/last.exr --passes 8 --seed "$seed" --photon-sampler "$sampler" \
            --snapshots "renders/$sampler/seed-$seed"
    done
done
cp "$here"/*.mjs .
node page_test.mjs known
"$program" compare renders/reference.exr renders/uniform renders/adaptive known/bright.pfm \
    --report page.html >/dev/null
node page_test.mjs page "$(command -v chromium)" "$PWD/page.html"

node live_test.mjs "$(command -v chromium)" "$program" renders/cornell.pbrt
