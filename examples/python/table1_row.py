#!/usr/bin/env python3
"""Reproduces the row of cognac-2 in the paper's Table I, and plots error against time.

Usage: table1_row.py SCENE.pbrt [SECONDS [PLOT.png]]    (sunfleck scene cognac-2 -o FOLDER)

SECONDS of processor time for each of the samplers random, paper and adaptive; a reference has
twenty times as much, of another seed.
"""

import sys

import numpy

import sunfleck

PAPER = {"triangles": 16456, "visible ratio": 885.2, "mutation size": 0.174}
SIZE = (128, 128)


def relative_mse(picture, reference):
    """The mean of d^2 / (R^2 + 0.01 mean(R)^2) over luminance."""
    luminance = (0.2126, 0.7152, 0.0722)
    value, truth = picture.rgb() @ luminance, reference.rgb() @ luminance
    return numpy.mean((value - truth) ** 2 / (truth ** 2 + 0.01 * truth.mean() ** 2))


def curve(scene, sampler, seconds, reference):
    """Renders for some processor time. Returns the renderer, times, and errors at these times."""
    renderer = sunfleck.Renderer(
        scene, photon_sampler=sampler, seed=1, resolution=SIZE, log=lambda *line: None)
    times, errors, step = [], [], 1
    while not times or times[-1] < seconds:
        renderer.step(step)
        times.append(renderer.progress.cpu_seconds)
        errors.append(relative_mse(renderer.picture(), reference))
        step = max(1, renderer.progress.passes // 2)
    return renderer, times, errors


def print_row(scene, statistics):
    visible = 1 / statistics["visible_fraction"]["value"]
    print(f"{'':16}{'paper':>10}{'here':>10}")
    for name, here in (("triangles", scene.triangle_count), ("visible ratio", visible),
                       ("mutation size", statistics["mutation_size"])):
        print(f"{name:16}{PAPER[name]:10}{here:10.6g}")


def plot(curves, path):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(figsize=(6, 4))
    for sampler, (times, errors) in curves.items():
        axes.loglog(times, errors, marker="o", markersize=3, label=sampler)
    axes.set(xlabel="processor time (s)", ylabel="relative MSE", title="cognac-2")
    axes.legend()
    figure.savefig(path, dpi=120, bbox_inches="tight")


def main(scene_path, seconds=20.0, plot_path=None):
    scene = sunfleck.Scene.load(scene_path)
    renderer = sunfleck.Renderer(scene, cpu_time=f"{20 * seconds}s", seed=2, resolution=SIZE)
    renderer.run()
    reference = renderer.picture()
    curves = {}
    for sampler in ("random", "paper", "adaptive"):
        renderer, times, errors = curve(scene, sampler, seconds, reference)
        curves[sampler] = times, errors
        print(f"{sampler:9} {renderer.progress.passes:5} passes, {times[-1]:.0f} s, "
              f"relative MSE {errors[-1]:.3g}")
        if sampler == "paper":
            print_row(scene, renderer.statistics())
    if plot_path:
        plot(curves, plot_path)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(sys.argv[1], *(float(word) for word in sys.argv[2:3]), *sys.argv[3:4])
