"""The render engine: exports the scene, runs the program, and shows its picture as it grows."""

import os
import shutil
import tempfile
import time

import bpy

from . import program
from .export_scene import export_scene
from .passes import group_passes, pass_list, show
from .program import ProgramFault, Render
from .scene_text import SceneFault

WAIT = 0.2  # seconds between looks at the program
PATIENCE = 5, 30  # least and most seconds that an interrupted program may take for its last pass


class Stopped(Exception):
    """Esc was pressed before there was any picture."""


def settings_of(scene):
    """Returns the scene's settings as program.render_arguments wants them."""
    own = scene.sunfleck
    return {"time": own.time, "target_error": own.target_error, "passes": own.passes,
            "threads": own.threads, "seed": own.seed,
            "aovs": [name for name, _, _ in aov_rows() if name in own.aovs], "light_groups": []}


def aov_rows():
    from .properties import AOVS
    return AOVS


def light_groups(scene, view_layer, lights):
    """Returns [(name, numbers)] of the light groups that the scene asks for."""
    choice = scene.sunfleck.light_groups
    if choice == "NONE":
        return []
    if choice == "EACH":
        return program.groups_of(lights, lambda name: name)
    known = {group.name for group in view_layer.lightgroups}
    chosen = {}
    for one in scene.objects:
        if one.lightgroup in known:
            chosen[one.name_full] = one.lightgroup
    if scene.world and scene.world.lightgroup in known:
        chosen[f"world {scene.world.name}"] = scene.world.lightgroup
    return program.groups_of(lights, chosen.get)


def image_path(image):
    """Returns where an image's file is; paths of linked files count from their library."""
    return bpy.path.abspath(image.filepath, library=image.library) if image.filepath else ""


class SunfleckEngine(bpy.types.RenderEngine):
    """Renders a scene with the program sunfleck."""
    bl_idname = "SUNFLECK"
    bl_label = "Sunfleck"
    bl_use_preview = False
    bl_use_eevee_viewport = True
    bl_use_shading_nodes_custom = False
    _told = ""

    def render(self, depsgraph):
        scene = depsgraph.scene
        folder = tempfile.mkdtemp(prefix="sunfleck-", dir=bpy.app.tempdir)
        try:
            self._render(depsgraph, folder)
            if scene.sunfleck.folder:
                keep(folder, bpy.path.abspath(scene.sunfleck.folder), scene.frame_current)
        except (ProgramFault, SceneFault) as fault:
            self.fail(str(fault))
        except Stopped:
            pass
        except OSError as fault:
            self.fail(f"{fault.filename or folder}: {fault.strerror}")
        finally:
            shutil.rmtree(folder, ignore_errors=True)

    def update_render_passes(self, scene=None, renderlayer=None):
        self.register_pass(scene, renderlayer, "Combined", 4, "RGBA", "COLOR")
        for name, letters, kind, _ in pass_list(settings_of(scene)["aovs"]):
            self.register_pass(scene, renderlayer, name, len(letters), letters, kind)

    def fail(self, text):
        """Shows a fault: in the render window, and in Blender's list of reports."""
        self.error_set(text)
        self.report({"ERROR"}, text)

    def _render(self, depsgraph, folder):
        preferences = bpy.context.preferences.addons.get(__package__)
        path = program.find_program(preferences.preferences.program if preferences else "")

        def progress(text):
            self.update_stats("", f"Sunfleck: {text}")
            if self.test_break():
                raise Stopped
        scene = depsgraph.scene
        exported = export_scene(depsgraph, folder, image_path, scene.sunfleck.max_depth,
                                lambda text: self.report({"WARNING"}, text), progress)
        settings = settings_of(scene)
        settings["light_groups"] = light_groups(scene, depsgraph.view_layer_eval,
                                                exported.text.lights)
        flags = program.render_arguments(settings)
        render = Render(path, exported.file, flags, folder)
        try:
            self._watch(render, exported, settings, depsgraph.view_layer_eval.name)
        finally:
            render.kill()

    def _watch(self, render, exported, settings, layer):
        """Shows snapshots until the program ends or Esc is pressed; then the last picture."""
        extra = pass_list(settings["aovs"]) + group_passes(
            [name for name, _ in settings["light_groups"]])
        for name, letters, _, _ in extra:
            self.add_pass(name, len(letters), letters, layer=layer)
        start, passes, error, stopped = time.monotonic(), 0, None, None
        newest, patience = None, PATIENCE[1]
        while render.is_running():
            time.sleep(WAIT)
            if self.test_break() and stopped is None:
                stopped = time.monotonic()
                patience = min(max(PATIENCE[0], 2 * (stopped - start) / max(passes, 1)),
                               PATIENCE[1])
                render.interrupt()
            if stopped is not None and time.monotonic() - stopped > patience:
                break
            snapshot = render.newest_snapshot()
            if snapshot:
                newest, passes = snapshot
                error = _error_of(render.statistics(newest)) or error
                show(self, newest, exported.size, layer, extra)
            self._tell(render, settings, time.monotonic() - start, passes, error, stopped)
        if not render.is_running() and render.exit_code() not in (0, 130):
            raise ProgramFault("; ".join(map(exported.text.explain,
                                             program.faults_of(render.said()))))
        last = render.output if os.path.isfile(render.output) else newest
        if last:
            show(self, last, exported.size, layer, extra)
        for warning in program.warnings_of(render.said()):
            self.report({"WARNING"}, exported.text.explain(warning))

    def _tell(self, render, settings, seconds, passes, error, stopped):
        line = program.progress_of(render.said())
        text = f"{passes} passes, {seconds:.0f} s"
        if error:
            text += f", error {error:.2g}%"
        if stopped is not None:
            text = f"ending after this pass; {text}"
        elif not passes:
            text = f"{(render.said() or ['starting'])[-1]}; {seconds:.0f} s"
        elif line:
            text = line if int(line.split()[0]) > passes else text
        if text != self._told:
            self.update_stats("", f"Sunfleck: {text}")
            self._told = text
        self.update_progress(program.fraction_done(settings, seconds, passes, error))


def _error_of(statistics):
    """Returns the error in percent that statistics say, or None."""
    error = statistics.get("image", {}).get("target_error")
    return 100 * error if error else None


def keep(folder, target, frame):
    """Copies an exported scene to a folder that stays, one for each frame."""
    shutil.copytree(folder, os.path.join(target, f"frame-{frame:04d}"), dirs_exist_ok=True)


def register():
    bpy.utils.register_class(SunfleckEngine)


def unregister():
    bpy.utils.unregister_class(SunfleckEngine)
