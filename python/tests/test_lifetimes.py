"""Tests of what lets go of a renderer, of the end of Python, and of objects that hold nothing."""

import gc
import subprocess
import sys
import weakref

import pytest
from small_scene import BALL, endless

import sunfleck


def run_script(text):
    """Runs a program of its own, in which there are a scene and endless()."""
    head = ("import gc, sys, threading, time, sunfleck\n"
            f"scene = sunfleck.Scene.parse({BALL!r})\n"
            "def endless(**settings): return sunfleck.Renderer(\n"
            "    scene, passes=1000000, photon_sampler='uniform', photons_per_pass=1000)\n")
    return subprocess.run([sys.executable, "-c", head + text], capture_output=True, text=True,
                          timeout=60, check=False)


class App:
    """A program whose callbacks know the renderer."""

    def __init__(self, scene):
        self.renderer = endless(scene, log=self.log)

    def log(self, *_):
        pass

    def report(self, _):
        pass


@pytest.mark.parametrize("begin", [
    lambda app: None, lambda app: app.renderer.step(1, app.report),
    lambda app: app.renderer.start(app.report)])
def test_the_collector_frees_a_renderer_whose_callbacks_know_it(scene, begin):
    app = App(scene)
    begin(app)
    dead = weakref.ref(app)
    del app
    gc.collect()
    assert dead() is None


def test_a_renderer_may_be_left_alone_with_its_report():
    done = run_script("""
class App:
    def __init__(self):
        self.renderer = endless()
        self.renderer.start(self.report)
    def report(self, progress): pass
def alone():
    renderer = endless()
    renderer.start(lambda progress: renderer.progress)
App(); alone(); time.sleep(0.3); gc.collect(); App(); alone()
print("alive")
""")
    assert (done.stdout, done.stderr, done.returncode) == ("alive\n", "", 0)


def test_a_report_may_let_go_of_its_renderer():
    done = run_script("""
def lets_go(of, fails=False):
    def report(progress):
        of.clear()
        if fails: raise ValueError
    return report
class App:
    def __init__(self): self.me, self.renderer = self, endless()
for held in [endless()], [endless()], [App().renderer]:
    held[0].start(lets_go(held, fails=len(sys.argv) > 1))
    while held: time.sleep(0.01)
    sys.argv.append("")
App().renderer.start(lambda progress: gc.collect())
time.sleep(0.3)
print("alive")
""")
    assert (done.stdout, done.returncode) == ("alive\n", 0)
    assert done.stderr.count("ValueError") == 2  # of those that nobody waits for


# The destructor of this object runs after the module has ended, and lets other threads run.
LATE = """
class Late:
    def __del__(self, sleep=time.sleep): sleep(0.3)
late = Late()
report = lambda progress: time.sleep(0.01)
"""


@pytest.mark.parametrize("begin", [
    "renderer = endless(); renderer.start(report)",
    "renderer = endless(); renderer.start(report); sys.modules['kept'] = kept = [renderer]\n"
    "kept.append(kept)",
    "threading.Thread(target=endless().run, args=[report], daemon=True).start()",
    "def again():\n"
    "    while True:\n"
    "        endless().step(1, report)\n"
    "threading.Thread(target=again, daemon=True).start()",
    "renderer = endless(); renderer.start()\n"
    "def watch():\n"
    "    while True: renderer.picture(), renderer.progress\n"
    "threading.Thread(target=watch, daemon=True).start()"])
def test_python_ends_while_it_renders(begin):
    done = run_script(LATE + begin + "\ntime.sleep(0.2)\n")
    assert (done.stderr, done.returncode) == ("", 0)


@pytest.mark.parametrize("use", [
    lambda: sunfleck.Renderer.__new__(sunfleck.Renderer).run(),
    lambda: sunfleck.Picture.__new__(sunfleck.Picture).width,
    lambda: sunfleck.Progress.__new__(sunfleck.Progress).passes,
    lambda: sunfleck.SceneBuilder.__new__(sunfleck.SceneBuilder).film(3, 3),
    lambda: sunfleck.Transform() @ sunfleck.Transform.__new__(sunfleck.Transform),
    lambda: sunfleck.Renderer(sunfleck.Scene.__new__(sunfleck.Scene))])
def test_objects_that_were_never_made_are_refused(use):
    with pytest.raises(TypeError):
        use()
