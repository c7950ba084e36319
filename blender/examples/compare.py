"""Renders the example scenes by the add-on, by glTF and with Cycles, and compares them.

Usage: blender -b --factory-startup --python compare.py -- FOLDER SECONDS [SCENE...]
The program sunfleck must be on PATH. Writes EXR and PNG files and a table to FOLDER.
"""

import os
import subprocess
import sys

import bpy
import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.dirname(HERE)]

import scenes  # noqa: E402
import shapes  # noqa: E402
import sunfleck_blender  # noqa: E402
from sunfleck_blender.picture_files import read_exr, to_bytes, to_srgb, write_png  # noqa: E402

BLOCK = 32
LUMENS_PER_WATT = 683  # of Blender's exporter


def pixels_of(path):
    image = bpy.data.images.load(path)
    values = np.empty(image.size[0] * image.size[1] * 4, np.float32)
    image.pixels.foreach_get(values)
    result = values.reshape(image.size[1], image.size[0], 4)[::-1, :, :3].copy()
    bpy.data.images.remove(image)
    return result


def render(engine, path, seconds):
    """Renders the scene at hand for so long, and returns its pixels."""
    scene = bpy.context.scene
    scene.render.engine = engine
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.filepath = path
    if engine == "CYCLES":
        scene.cycles.samples = 1 << 20
        scene.cycles.time_limit = seconds
        scene.cycles.use_adaptive_sampling = False
        scene.cycles.use_denoising = False
        scene.cycles.sample_clamp_indirect = 0
        scene.cycles.blur_glossy = 0
        scene.cycles.max_bounces = scene.cycles.diffuse_bounces = 64
        scene.cycles.glossy_bounces = scene.cycles.transmission_bounces = 64
    else:
        scene.sunfleck.time, scene.sunfleck.target_error = int(seconds), 0
    bpy.ops.render.render(write_still=True)
    return pixels_of(path)


def render_gltf(base, seconds):
    """Renders what Blender's exporter of glTF writes."""
    bpy.ops.export_scene.gltf(filepath=base + ".glb", export_cameras=True, export_lights=True,
                              export_apply=True)
    render_settings = bpy.context.scene.render
    size = f"{render_settings.resolution_x}x{render_settings.resolution_y}"
    said = subprocess.run(["sunfleck", "render", base + ".glb", "-o", base + ".exr", "--time",
                           f"{seconds}s", "--resolution", size, "--exposure", "0"],
                          capture_output=True, text=True)
    with open(base + ".txt", "w", encoding="utf-8") as log:
        log.write(said.stderr)
    if said.returncode != 0:
        return None
    picture = read_exr(base + ".exr")
    return np.stack([picture[channel] for channel in "RGB"], axis=-1)


def blocks(pixels):
    height, width = (n // BLOCK * BLOCK for n in pixels.shape[:2])
    cut = pixels[:height, :width].reshape(height // BLOCK, BLOCK, width // BLOCK, BLOCK, 3)
    return cut.mean(axis=(1, 3, 4))


def agreement(name, a, b):
    """Returns a line: how far the blocks of two pictures are apart."""
    first, second = blocks(a), blocks(b)
    bright = first > 0.02 * first.max()
    ratio = second[bright] / first[bright]
    within = np.mean(np.abs(ratio - 1) < 0.03)
    return (f"{name}: mean {b.mean() / a.mean():.4f}, blocks {ratio.min():.3f} to "
            f"{ratio.max():.3f}, {100 * within:.0f}% of {bright.sum()} within 3%")


def save_png(path, pixels, exposure):
    write_png(path, to_bytes(to_srgb(pixels * exposure)))


def compare(name, folder, seconds, say):
    base = os.path.join(folder, name)
    scenes.SCENES[name]()
    cycles = render("CYCLES", base + "-cycles.exr", seconds)
    whole = render("SUNFLECK", base + "-addon.exr", seconds)
    exposure = 0.35 / np.median(cycles.mean(axis=2))
    save_png(base + "-cycles.png", cycles, exposure)
    save_png(base + "-addon.png", whole, exposure)
    say(agreement(f"{name}, add-on over Cycles", cycles, whole))
    scenes.hide_caustics()
    cycles = render("CYCLES", base + "-plain-cycles.exr", seconds)
    ours = render("SUNFLECK", base + "-plain-addon.exr", seconds)
    save_png(base + "-plain-cycles.png", cycles, exposure)
    save_png(base + "-plain-addon.png", ours, exposure)
    say(agreement(f"{name} without glass and mirrors, add-on over Cycles", cycles, ours))
    scenes.hide_caustics(False)
    shapes.only_principled()
    gltf = render_gltf(base + "-gltf", seconds)
    if gltf is not None:
        gltf = gltf / LUMENS_PER_WATT
        save_png(base + "-gltf.png", gltf, exposure)
        say(agreement(f"{name}, glTF over add-on", whole, gltf))


def main(folder, seconds, names):
    os.makedirs(folder, exist_ok=True)
    sunfleck_blender.register()
    for name in names or scenes.SCENES:
        with open(os.path.join(folder, "table.txt"), "a", encoding="utf-8") as table:
            def say(line):
                print("RESULT", line, flush=True)
                table.write(line + "\n")
                table.flush()
            compare(name, folder, seconds, say)


if __name__ == "__main__":
    given = sys.argv[sys.argv.index("--") + 1:]
    main(os.path.abspath(given[0]), float(given[1]), given[2:])
