"""Installs the add-on from its .zip, renders Blender's first scene with it, and disables it.

Usage: blender -b --factory-startup --python-exit-code 1 --python install_zip.py -- FILE.zip
"""

import os
import sys
import tempfile

import bpy

NAME = "sunfleck_blender"

bpy.ops.preferences.addon_install(filepath=sys.argv[sys.argv.index("--") + 1])
bpy.ops.preferences.addon_enable(module=NAME)
scene = bpy.context.scene
scene.render.engine = "SUNFLECK"
scene.render.resolution_percentage = 2
scene.sunfleck.time, scene.sunfleck.passes = 0, 1
scene.sunfleck.aovs = {"normal", "depth"}
scene.render.image_settings.file_format = "OPEN_EXR_MULTILAYER"
with tempfile.TemporaryDirectory() as folder:
    scene.render.filepath = os.path.join(folder, "out.exr")
    bpy.ops.render.render(write_still=True)
    with open(scene.render.filepath, "rb") as file:
        written = file.read()
for channel in (b"Normal.X", b"Depth.Z"):
    assert channel in written, f"the picture lacks {channel}"
bpy.ops.preferences.addon_disable(module=NAME)
assert not hasattr(bpy.types.Scene, "sunfleck"), "the add-on leaves properties behind"
