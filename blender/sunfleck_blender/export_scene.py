"""Writes an evaluated scene of Blender as a folder with scene.pbrt, meshes and pictures."""

import os
from dataclasses import dataclass

from .export_camera import region, write_camera
from .export_materials import MaterialBook
from .export_objects import Objects
from .export_world import write_air, write_world
from .image_files import ImageFiles
from .scene_text import SceneText


@dataclass
class Exported:
    """A scene in a folder. text: the SceneText, which explains errors. size: rendered pixels."""
    file: str
    text: SceneText
    size: tuple
    objects: int


def name_missing(render, warn):
    """Names what the scene's render settings ask for and is not simulated."""
    for name, text in (("film_transparent", "a transparent film: the world is seen instead"),
                       ("use_motion_blur", "motion blur: things stand as in the frame"),
                       ("use_multiview", "stereoscopy: one picture is rendered")):
        if getattr(render, name, False):
            warn(f"scene: {text}")


def export_scene(depsgraph, folder, resolve, max_depth, warn, progress=lambda text: None):
    """Writes the scene that `depsgraph` has evaluated.

    resolve: returns the path of an image's file. warn: called with a text once for each loss.
    progress: called with what is done; what it raises ends the export.
    """
    told = set()

    def warn_once(text):
        if text not in told:
            told.add(text)
            warn(text)
    scene = depsgraph.scene_eval
    name_missing(scene.render, warn_once)
    text = SceneText()
    camera = scene.camera.evaluated_get(depsgraph) if scene.camera else None
    images = ImageFiles(folder, resolve)
    air = write_air(text, scene.world, images, warn_once)
    write_camera(text, scene, camera, "picture.exr", warn_once)
    text.say("Integrator", "sppm", {"integer maxdepth": max_depth})
    text.say("WorldBegin")
    write_world(text, folder, scene.world, images, air, warn_once)
    book = MaterialBook(text, images, warn_once)
    objects = Objects(text, folder, book, air, warn_once, progress)
    objects.collect(depsgraph)
    objects.write()
    file = os.path.join(folder, "scene.pbrt")
    with open(file, "w", encoding="utf-8", newline="\n") as opened:
        opened.write(text.text())
    x0, x1, y0, y1 = region(scene.render)
    return Exported(file, text, (x1 - x0, y1 - y0), len(objects.placed))
