#!/usr/bin/env python3
"""Adds a toy BSDF, light and photon sampler to a copy of the tree, each by a patch of tests/toys/
that touches the places of docs/develop/adding.md and no others; builds the copy and runs the toys.

Usage: check_toys.py [--build FOLDER] [REPOSITORY]. Prints how many files of the tree each patch
touches, beside its new files; exit code 1 where one does not fit or touches more than three. Then
--build copies the tree to FOLDER/tree, builds it, runs the laws over the toys, and compares a
picture by the toy sampler with one by `uniform`. A FOLDER that is there is built on.
"""

import argparse
import filecmp
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

MOST_PLACES = 3
TOYS = ["bsdf", "light", "sampler"]
LEFT_OUT = {"build", "out"}


def run(*command, **options):
    """Runs a command to its end; a failure ends the program with what was printed."""
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=False, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout[-4000:]}")
    return done.stdout


def files_of(patch):
    """The files that a patch writes, as paths from the root of the tree."""
    return re.findall(r"^\+\+\+ b/(\S+)$", patch.read_text(encoding="utf-8"), re.MULTILINE)


def copy_changed(source, target):
    """Makes target like source; files that are alike already keep their time."""
    wanted = {file.relative_to(source) for file in source.rglob("*") if file.is_file()}
    for file in [f for f in target.rglob("*") if f.is_file()]:
        if file.relative_to(target) not in wanted:
            file.unlink()
    for file in wanted:
        if not (target / file).exists() or not filecmp.cmp(source / file, target / file, False):
            (target / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source / file, target / file)


def patched_copy(root, folder):
    """Writes the tree with all toys to folder/tree, by way of folder/new."""
    new = folder / "new"
    shutil.rmtree(new, ignore_errors=True)
    new.mkdir(parents=True)
    for entry in root.iterdir():
        if entry.name in LEFT_OUT or entry.name.startswith("."):
            continue
        (shutil.copytree if entry.is_dir() else shutil.copyfile)(entry, new / entry.name)
    for toy in TOYS:
        patch = (root / "tests/toys" / toy).with_suffix(".patch")
        run("patch", "-p1", "--no-backup-if-mismatch", "-d", new, "-i", patch)
    copy_changed(new, folder / "tree")
    shutil.rmtree(new)
    for script in (folder / "tree").rglob("*.sh"):
        script.chmod(0o755)
    return folder / "tree"


def check_places(root):
    """Prints the count of places of each toy. Returns whether all are few enough and fit."""
    good = True
    for toy in TOYS:
        patch = root / "tests/toys" / f"{toy}.patch"
        places = [file for file in files_of(patch) if (root / file).exists()]
        print(f"toy {toy}: {len(places)} files touched ({', '.join(places)})")
        good = good and len(places) <= MOST_PLACES
        run("patch", "-p1", "--dry-run", "-d", root, "-i", patch.resolve())
    return good


def run_laws(tests):
    """Runs the laws over the toys; each toy must be met by several."""
    out = run(tests, "--gtest_brief=1", "--gtest_filter=*/toy:*Examples.cover*")
    passed = int(re.search(r"\[  PASSED  \] (\d+) test", out)[1])
    if passed < 15:
        sys.exit(f"only {passed} laws ran over the toys")
    print(f"laws over the toys: {passed} passed")


def compare_samplers(program, folder):
    """Renders one scene by the toy sampler and by `uniform`: equally bright within 1%."""
    run(program, "scene", "cornell", "-o", folder)
    means = {}
    for sampler in ["toy", "uniform"]:
        stats = folder / f"{sampler}.json"
        run(program, "render", folder / "cornell.pbrt", "-o", folder / f"{sampler}.exr", "--quiet",
            "--photon-sampler", sampler, "--resolution", "64x64", "--passes", "16", "--stats",
            stats)
        means[sampler] = json.loads(stats.read_text(encoding="utf-8"))["image"]["mean"]
    ratio = means["toy"] / means["uniform"]
    print(f"cornell by the toy sampler over uniform: {ratio:.4f}")
    if not 0.99 < ratio < 1.01:
        sys.exit("the toy sampler gives another picture")


def build_and_run(root, folder):
    tree = patched_copy(root, folder)
    build = folder / "build"
    run("cmake", "-S", tree, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release")
    run("cmake", "--build", build, "--target", "tests_laws", "sunfleck")
    run_laws(build / "bin/tests_laws")
    compare_samplers(build / "bin/sunfleck", folder)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", type=Path, metavar="FOLDER")
    parser.add_argument("repository", type=Path, nargs="?", default=Path("."))
    arguments = parser.parse_args()
    if not check_places(arguments.repository):
        sys.exit(f"a toy touches more than {MOST_PLACES} files")
    if arguments.build:
        build_and_run(arguments.repository.resolve(), arguments.build.resolve())
