#!/usr/bin/env bash
# Installs the project into a scratch folder, builds the programs of examples/ against it, and runs
# them: shared, static, and by pkg-config. Usage: clients.sh BUILD_FOLDER SOURCE_FOLDER SCRATCH_FOLDER
set -euo pipefail
build=$1 source=$2 scratch=$3
rm -rf "$scratch"
mkdir -p "$scratch"
cd "$scratch"
prefix=$scratch/prefix
cmake --install "$build" --prefix "$prefix" >install.log

fail() {
    echo "clients: $*"
    exit 1
}

# No header of the library leads into the source, and none of our flags reaches a client.
if grep -rnE '#include "' "$prefix/include"; then fail "a public header includes a private one"; fi
if grep -rnE -e '-(Werror|march|fvisibility)|module_' "$prefix"/lib*/cmake "$prefix"/lib*/*/cmake 2>/dev/null; then
    fail "a flag or a module of ours is exported"
fi
library=$(find "$prefix" -name libsunfleck.so)
if nm -D --defined-only -C "$library" | awk '{$1 = $2 = ""; print}' |
    grep -vE '^ +(typeinfo (name )?for |vtable for )?sunfleck::|^ +SUNFLECK_|operator\*\(sunfleck'; then
    fail "the shared library exports more than its interface"
fi
if nm -D --defined-only -C "$library" | grep 'sunfleck::engine::'; then fail "internals are exported"; fi

"$prefix/bin/sunfleck" scene cornell -o scene >/dev/null
sed -i -E 's/("integer [xy]resolution") [0-9]+/\1 64/g' scene/cornell.pbrt
"$prefix/bin/sunfleck" render scene/cornell.pbrt --passes 3 --quiet -o program.exr
"$build/bin/picture_hash" program.exr >program.hash

for static in OFF ON; do
    cmake -S "$source/examples" -B "examples_$static" -DCMAKE_PREFIX_PATH="$prefix" \
        -DEXAMPLES_STATIC=$static -DCMAKE_BUILD_TYPE=Release >configure.log
    cmake --build "examples_$static" -j 2 >build.log || { cat build.log; fail "examples do not build"; }
    echo "static $static"
    (
        export LD_LIBRARY_PATH
        LD_LIBRARY_PATH=$(dirname "$library")
        "examples_$static/load_and_render" scene/cornell.pbrt client.exr 3
        "examples_$static/scene_in_memory" ball.exr
        "examples_$static/progressive" scene/cornell.pbrt
    )
    "$build/bin/picture_hash" client.exr >client.hash
    diff <(cut -d' ' -f1 program.hash) <(cut -d' ' -f1 client.hash) ||
        fail "the library's picture differs from the program's"
done

mkdir other_component
cat >other_component/CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.25)
project(other CXX)
find_package(sunfleck REQUIRED COMPONENTS dynamic)
END
if cmake -S other_component -B other_build -DCMAKE_PREFIX_PATH="$prefix" >other.log 2>&1 ||
    ! grep -q "use shared or static" other.log; then fail "an unknown component is not refused"; fi

# By pkg-config, with a message for what is no scene. The shared library asks for no other package.
packages=$(dirname "$(find "$prefix" -name sunfleck.pc)")
PKG_CONFIG_LIBDIR=$packages pkg-config --cflags --libs sunfleck >flags
PKG_CONFIG_PATH=$packages pkg-config --cflags --libs sunfleck-static >static_flags
# shellcheck disable=SC2046
c++ -std=c++20 "$source/examples/load_and_render.cpp" $(cat flags) -o by_pkg_config
# shellcheck disable=SC2046
c++ -std=c++20 "$source/examples/load_and_render.cpp" $(cat static_flags) -o by_static_pkg_config
./by_static_pkg_config scene/cornell.pbrt client.exr 3 >/dev/null
"$build/bin/picture_hash" client.exr >client.hash
diff <(cut -d' ' -f1 program.hash) <(cut -d' ' -f1 client.hash) || fail "by sunfleck-static"
code=0
LD_LIBRARY_PATH=$(dirname "$library") ./by_pkg_config nowhere.pbrt none.exr 2>message || code=$?
[[ $code == 2 ]] && grep -q "nowhere.pbrt" message || fail "a missing scene: code $code, $(cat message)"
echo "clients: no faults"
