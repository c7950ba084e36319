"""Sunfleck from Python: scenes, renders, and pictures as NumPy arrays.

    import sunfleck
    scene = sunfleck.Scene.load("scene.pbrt")
    renderer = sunfleck.Renderer(scene, passes=64)
    renderer.run(lambda progress: print(progress.passes))
    picture = renderer.picture()
    print(picture["R"].mean(), picture["error.Y"].max())
"""

import functools
import json
import sys
import warnings
import weakref

import numpy

from . import _sunfleck
from ._sunfleck import (
    Error, LightInfo, Picture, Progress, Scene, SceneBuilder, SettingInfo, Transform, __version__,
    settings)

__all__ = [
    "Error", "LightInfo", "Picture", "Progress", "Renderer", "Scene", "SceneBuilder", "SettingInfo",
    "Transform", "__version__", "settings"]


class Renderer(_sunfleck._Renderer):
    """Renders a scene: at once, pass by pass, or in the background.

    Renderer(scene, *, threads=0, log=None, **settings). Settings have the names of the flags of
    `sunfleck render`, with "_" for "-": Renderer(scene, passes=64, photon_sampler="uniform",
    resolution=(640, 480), aovs=["caustic", "depth"]). settings() lists them. log(severity, line) is
    called with warnings; without it they are Python's.

    run(report), step(passes, report) and wait() return whether the render came to its end, and was
    not cancelled. report(progress) is called after each pass, on another thread. Other threads of
    Python run meanwhile; Ctrl-C and what a callback raises end the render, which can go on. A
    second Ctrl-C leaves a report that does not return.
    """

    def __init__(self, scene, *, threads=0, log=None, **settings):
        self._log, called = _callback(_warn if log is None else log)
        super().__init__(scene, threads=threads, log=called, **settings)

    def start(self, report=None):
        """Renders in the background; wait() waits for its end."""
        held, called = (None, None) if report is None else _callback(report)
        super().start(called)
        self._report = held

    def statistics(self):
        """The statistics of the render so far, as `sunfleck render --stats` writes them."""
        return json.loads(self._statistics())


def _callback(function):
    """Returns what the renderer keeps, and what the library calls, which does not keep it alive.

    A report that knows its renderer is thus a circle that Python's collector sees.
    """
    held = functools.partial(function)
    reference = weakref.ref(held)

    def call(*arguments):
        alive = reference()
        if alive is not None:
            alive(*arguments)

    return held, call


def _warn(_, line):
    """Warns of the line at the place that has called the package."""
    frame, level = sys._getframe(), 1
    while frame is not None and frame.f_code.co_filename == __file__:
        frame, level = frame.f_back, level + 1
    warnings.warn(line, stacklevel=level)


def _rgb(self, aov=""):
    """The three channels of the picture, or of an AOV, as one array (height, width, 3): a copy."""
    names = [f"{aov}.{c}" if aov else c for c in "RGB"]
    return numpy.stack([self[name] for name in names], axis=-1)


Picture.rgb = _rgb
