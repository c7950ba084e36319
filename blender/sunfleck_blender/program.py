"""Calls the program `sunfleck`: its arguments, what it says, and the pictures that it leaves."""

import glob
import json
import os
import re
import shutil
import signal
import subprocess

PROGRESS = re.compile(r"^(\d+) pass(?:es)?, .*$")
ERROR = re.compile(r"\berror (\d[\d.]*)%")
TALK = re.compile(r"^(reading|learning|first pass|maximum depth|\d+ pass)|: warning: ")
SNAPSHOT = re.compile(r"passes-(\d+)\.exr$")


class ProgramFault(Exception):
    """The program is missing, or ended with a fault; the text is for the user."""


def find_program(given):
    """Returns the path of the program: what preferences say, else what PATH has."""
    if given:
        path = os.path.expanduser(given)
        if os.path.isfile(path) and os.access(path, os.X_OK):
            return path
        raise ProgramFault(f'there is no program "{path}": mend the path in Edit > Preferences > '
                           "Add-ons > Sunfleck")
    found = shutil.which("sunfleck")
    if found is None:
        raise ProgramFault("the program sunfleck is not on PATH: install it, or say where it is in "
                           "Edit > Preferences > Add-ons > Sunfleck")
    return found


def render_arguments(settings):
    """Returns the flags of a render.

    settings: dict with time (s), target_error (%), passes (0: no limit each), threads (0: all),
    seed, aovs (names), light_groups (list of (name, light numbers)).
    """
    flags = []
    if settings["time"] > 0:
        flags += ["--time", f"{settings['time']:g}s"]
    if settings["target_error"] > 0:
        flags += ["--target-error", f"{settings['target_error']:g}%"]
    if settings["passes"] > 0:
        flags += ["--passes", str(settings["passes"])]
    if settings["threads"] > 0:
        flags += ["--nthreads", str(settings["threads"])]
    if settings["seed"] != 0:
        flags += ["--seed", str(settings["seed"])]
    if settings["aovs"]:
        flags += ["--aovs", ",".join(settings["aovs"])]
    for name, numbers in settings["light_groups"]:
        flags += ["--light-group", f"{name}=" + ",".join(str(n) for n in numbers)]
    return flags


def group_name(name):
    """Returns a name that an EXR channel may have."""
    return re.sub(r"[^A-Za-z0-9_-]+", "_", name).strip("_") or "light"


def groups_of(lights, chosen):
    """Returns [(name, numbers)] of light groups.

    lights: names in the program's order. chosen: function of a name that returns its group or None.
    """
    groups = {}
    for number, name in enumerate(lights, 1):
        group = chosen(name)
        if group is not None:
            groups.setdefault(group_name(group), []).append(number)
    return list(groups.items())[:64]


class Render:
    """A running render in a folder."""

    def __init__(self, program, scene, flags, folder):
        self.snapshots = os.path.join(folder, "snapshots")
        self.output = os.path.join(folder, "result.exr")
        self._log = os.path.join(folder, "log.txt")
        arguments = [program, "render", scene, "-o", self.output, "--snapshots", self.snapshots,
                     *flags]
        try:
            with open(self._log, "wb") as log:
                # A group of its own: Ctrl-C in the terminal is Blender's.
                self._process = subprocess.Popen(arguments, stdin=subprocess.DEVNULL, stdout=log,
                                                 stderr=log, cwd=folder, start_new_session=True)
        except OSError as fault:
            raise ProgramFault(f"{program} cannot be started: {fault.strerror}") from fault
        self._shown = 0

    def is_running(self):
        return self._process.poll() is None

    def interrupt(self):
        """Asks the program to finish its pass and write the picture."""
        if self.is_running():
            self._process.send_signal(signal.SIGINT)

    def kill(self):
        """Ends the program without a picture, and waits for its end."""
        if self.is_running():
            self._process.kill()
        self._process.wait()

    def exit_code(self):
        return self._process.returncode

    def said(self):
        """Returns all lines that the program has written."""
        with open(self._log, encoding="utf-8", errors="replace") as file:
            return [line for line in re.split(r"[\r\n]+", file.read()) if line.strip()]

    def newest_snapshot(self):
        """Returns (path, passes) of a snapshot that was not returned before, or None."""
        found = [(int(SNAPSHOT.search(path)[1]), path)
                 for path in glob.glob(os.path.join(self.snapshots, "passes-*.exr"))]
        if not found or max(found)[0] <= self._shown:
            return None
        self._shown, path = max(found)
        return path, self._shown

    def statistics(self, path):
        """Returns the statistics beside a snapshot, or an empty dict if there are none."""
        try:
            with open(path[:-4] + ".json", encoding="utf-8") as file:
                return json.load(file)
        except (OSError, ValueError):
            return {}


def progress_of(lines):
    """Returns the newest line of progress, or None."""
    return next((line for line in reversed(lines) if PROGRESS.match(line)), None)


def fraction_done(settings, seconds, passes, error):
    """Returns how far a render is, by whichever of its ends is nearest; error in %, or None."""
    done = 0.0
    if settings["time"] > 0:
        done = seconds / settings["time"]
    if settings["passes"] > 0:
        done = max(done, passes / settings["passes"])
    if settings["target_error"] > 0 and error:
        # Noise falls with the root of the time.
        done = max(done, (settings["target_error"] / error) ** 2)
    return min(max(done, 0.0), 1.0)


def faults_of(lines):
    """Returns the lines that say why the program ended."""
    return [line for line in lines if not TALK.search(line)] or lines[-1:]


def warnings_of(lines):
    """Returns the program's warnings, each with its place in the scene's file."""
    return [line.replace("warning: ", "", 1) for line in lines if ": warning: " in line]
