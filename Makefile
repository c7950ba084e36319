# The commands of the project, one line each. CMakePresets.json says how each build is made.
SHELL := /bin/bash
.SHELLFLAGS := -e -o pipefail -c
JOBS ?= $(shell nproc)
BUILD := build/release
CTEST := ctest --test-dir $(BUILD) -j $(JOBS) --output-on-failure --no-tests=error
FUZZ_SECONDS ?= 600
N ?= 200
SEED ?= 0

.PHONY: demo test check browser blender mpi python install sanitize differential nightly bench tidy format \
  clean deps build

# Renders a glass of brandy in the sun into out/demo: two minutes of two cores.
demo: build
	$(BUILD)/bin/sunfleck scene brandy -o out/demo
	$(BUILD)/bin/sunfleck render out/demo/brandy.pbrt -o out/demo/brandy.png \
	  -o out/demo/brandy.exr --photons-per-pass 500000 --passes 112 --adaptive-pixels off \
	  --exposure -0.5

# What the README promises and .ci/run runs: all but what `browser`, `mpi` and `nightly` add.
test: build-tests
	$(CTEST) -LE "nightly|browser|mpi"

# The quick ones.
check: build-tests
	$(CTEST) -LE "slow|nightly|browser|mpi|blender"

# The page of `sunfleck compare` in Debian's Chromium; npm brings the driver from its registry.
browser: build-tests
	tools/setup.sh browser
	$(CTEST) -L browser

# The add-on inside Debian's Blender (1 GB); without it `test` skips these.
blender: build-tests
	tools/setup.sh blender
	$(CTEST) -L blender

# Several ranks under Open MPI, in a build of their own.
mpi:
	tools/setup.sh build test mpi
	cmake --preset mpi -DSUNFLECK_TESTS=ON
	cmake --build build/mpi -j $(JOBS) --target sunfleck tests_mpi
	ctest --test-dir build/mpi -L mpi --output-on-failure --no-tests=error

# The Python module, by Debian's Python, and its tests: build/release/python is for PYTHONPATH.
PYTHON ?= /usr/bin/python3
python:
	tools/setup.sh build python
	cmake --preset release -DSUNFLECK_PYTHON=ON -DPython3_EXECUTABLE=$(PYTHON)
	cmake --build $(BUILD) -j $(JOBS) --target sunfleck_python
	PYTHONPATH=$(BUILD)/python $(PYTHON) -m pytest -q -p no:cacheprovider python/tests

# Program, library, headers, man pages and completion.
PREFIX ?= /usr/local
install: build
	cmake --install $(BUILD) --prefix $(PREFIX)

# Installs what is missing of Debian for all of this.
deps:
	tools/setup.sh build test browser mpi python nightly

build:
	tools/setup.sh build
	cmake --preset release -DSUNFLECK_TESTS=OFF
	cmake --build $(BUILD) -j $(JOBS)

.PHONY: build-tests
build-tests:
	tools/setup.sh build test
	cmake --preset release -DSUNFLECK_TESTS=ON
	cmake --build $(BUILD) -j $(JOBS)

# The quick tests under the sanitizers: address, undefined behaviour, threads.
sanitize:
	tools/setup.sh build test
	tools/sanitize.sh

# Random scenes by several estimators, compared: `make differential N=200 SEED=1` (docs/develop/testing.md).
differential:
	tools/setup.sh build
	cmake --preset release
	cmake --build $(BUILD) -j $(JOBS) --target differential
	$(BUILD)/bin/differential --program $(BUILD)/bin/sunfleck --jobs $(JOBS) --scenes $(N) --seed $(SEED)

# What takes hours: everything above, lint, another compiler, long fuzzing; and the benchmarks compile.
nightly: test browser mpi sanitize tidy
	cmake --preset release -DSUNFLECK_TESTS=ON -DSUNFLECK_NIGHTLY_TESTS=ON
	cmake --build $(BUILD) -j $(JOBS)
	$(CTEST) -L nightly
	$(MAKE) differential N=1000 SEED=$$(date +%Y%m%d)
	cmake --preset clang
	cmake --build build/clang -j $(JOBS)
	ctest --test-dir build/clang -j $(JOBS) --output-on-failure --no-tests=error -LE "check|nightly|browser|mpi"
	cmake --preset bench
	cmake --build build/bench -j $(JOBS)
	tools/fuzz.sh $(FUZZ_SECONDS)

# Ratios of speed, never compared with a fixed time.
bench:
	tools/setup.sh build
	cmake --preset bench
	cmake --build build/bench -j $(JOBS)
	for program in rays scale load; do build/bench/bin/bench_$$program; done
	build/bench/bin/sunfleck scene cognac-1 -o out/bench
	build/bench/bin/bench_gain out/bench/cognac-1.pbrt
	build/bench/bin/bench_photon_maps out/bench/cognac-1.pbrt -o out/bench

tidy:
	tools/setup.sh build test nightly
	tools/tidy.sh

format:
	find src apps tests bench tools \( -name '*.h' -o -name '*.cpp' \) -exec clang-format-14 -i {} +

clean:
	rm -rf build out
