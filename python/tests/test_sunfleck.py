"""Tests of the Python module: make python."""

import pathlib
import threading
import time

import numpy
import pytest
from small_scene import BALL, quick

import sunfleck


def ball():
    builder = sunfleck.SceneBuilder()
    builder.camera("perspective", {"float fov": 35},
                   sunfleck.Transform.look_at((0, -6, 4), (0, 0, 0.6), (0, 0, 1)))
    builder.film(24, 16)
    builder.material("table", "diffuse", {"rgb reflectance": (0.6, 0.5, 0.4)})
    builder.material("glass", "dielectric", {"float eta": 1.5})
    builder.mesh(numpy.array([[-4, -4, 0], [4, -4, 0], [4, 4, 0], [-4, 4, 0]]),
                 numpy.array([[0, 1, 2], [0, 2, 3]]), material="table")
    builder.shape("sphere", {"float radius": 1.0}, material="glass",
                  to_world=sunfleck.Transform.translate((0, 0, 1.2)))
    builder.shape("sphere", {"float radius": 0.1}, material="table",
                  to_world=sunfleck.Transform.translate((-2, 1, 5)),
                  area_light={"rgb L": numpy.array([900.0, 800, 650])})
    return builder


def test_a_scene_of_arrays_is_that_of_the_file(scene):
    pictures = []
    for made in (scene, ball().build()):
        renderer = quick(made)
        assert renderer.run()
        pictures.append(renderer.picture()["G"])
    assert numpy.array_equal(*pictures)
    assert pictures[0].mean() > 0


def test_channels_are_views_that_outlive_the_picture(scene):
    renderer = quick(scene, aovs=["caustic", "depth"])
    renderer.run()
    picture = renderer.picture()
    red = picture["R"]
    assert red.shape == (16, 24) and red.dtype == numpy.float32
    assert red.base is not None and not red.flags.writeable
    assert numpy.shares_memory(red, picture["R"])
    assert picture.rgb("caustic").shape == (16, 24, 3)
    assert "depth.Z" in picture and "depth.R" not in picture
    expected = red.copy()
    del picture, renderer
    assert numpy.array_equal(red, expected)


def test_error_bars_come_after_two_batches(scene):
    renderer = quick(scene, passes=32)
    renderer.run()
    assert (renderer.picture()["error.Y"] >= 0).all()
    assert renderer.picture()["error.Y"].max() > 0


def test_reports_and_statistics(scene):
    passes = []
    renderer = quick(scene)
    renderer.run(lambda progress: passes.append(progress.passes))
    assert passes[-1] == 4 and renderer.progress.of == 4
    statistics = renderer.statistics()
    assert statistics["passes"] == 4 and statistics["visible_photon_ratio"] > 0


def test_other_threads_run_meanwhile(scene):
    counted = []
    thread = threading.Thread(target=lambda: [counted.append(i) or time.sleep(0.002)
                                              for i in range(20)])
    renderer = quick(scene, photons_per_pass=200000, resolution=(96, 64))
    thread.start()
    renderer.step(2)
    thread.join()
    assert len(counted) == 20


def test_what_a_callback_raises_ends_the_render_which_can_go_on(scene):
    renderer = quick(scene, passes=50)

    def stop(progress):
        if progress.passes == 2:
            raise KeyError("enough")

    with pytest.raises(KeyError):
        renderer.run(stop)
    assert renderer.progress.passes == 2
    renderer.step(2)
    other = quick(scene, passes=4)
    other.run()
    assert numpy.array_equal(renderer.picture()["G"], other.picture()["G"])


def test_background_and_cancel(scene):
    renderer = quick(scene, passes=100000)
    renderer.start()
    while renderer.progress.passes < 1:
        time.sleep(0.01)
    assert renderer.is_running and renderer.picture()["G"].mean() > 0
    renderer.cancel()
    assert not renderer.wait()


def test_errors_carry_the_place():
    with pytest.raises(sunfleck.Error) as raised:
        sunfleck.Scene.parse(BALL.replace('"sphere" "float radius" 1', '"ball"', 1), "x.pbrt")
    error = raised.value
    assert (error.file, error.line, error.code) == ("x.pbrt", 11, "input")
    assert error.column > 0 and "unknown shape" in str(error)
    with pytest.raises(sunfleck.Error):
        sunfleck.Scene.load("nowhere.pbrt")


def test_scenes_take_the_flags_of_the_command_line(tmp_path):
    path = tmp_path / "ball.pbrt"
    path.write_text(BALL)
    before = len(sunfleck.Scene.load(path).lights)
    lit = sunfleck.Scene.load(path, sun=(120, 30.5), ground_albedo=0.5, up="y")
    assert [light.what for light in lit.lights[before:]] == ["sky", "sun"]
    with pytest.raises(sunfleck.Error, match="--camera"):
        sunfleck.Scene.load(path, camera="main")
    with pytest.raises(sunfleck.Error, match="--moon: is no flag of a scene"):
        sunfleck.Scene.load(path, moon=1)
    with pytest.raises(sunfleck.Error, match="sun"):
        sunfleck.Scene.load(path, sun=None)


def test_settings_have_the_names_of_the_command_line(scene):
    names = {info.name for info in sunfleck.settings()}
    assert {"passes", "photon-sampler", "light-group"} <= names
    with pytest.raises(sunfleck.Error, match="photon_sampler|photon-sampler"):
        sunfleck.Renderer(scene, photon_sampler="magic")
    quick(scene, light_group=["lamp=1"], splitting=True, ris=False, crop=(0, 8, 0, 8))


def test_warnings_are_pythons(scene):
    with pytest.warns(UserWarning, match="biased"):
        sunfleck.Renderer(scene, photon_sampler="paper", passes=1)


def test_another_view(scene):
    renderer = quick(scene)
    renderer.set_resolution(12, 8)
    renderer.set_crop((0, 6, 0, 8))
    renderer.set_camera("perspective", {"float fov": 50.0},
                        sunfleck.Transform.look_at((3, -5, 2), (0, 0, 0.6), (0, 0, 1)))
    renderer.step(1)
    assert renderer.picture()["R"].shape == (8, 6)


def test_pictures_are_saved_and_loaded(scene, tmp_path):
    renderer = quick(scene)
    renderer.run()
    path = tmp_path / "ball.exr"
    renderer.picture().save(str(path))
    assert numpy.array_equal(sunfleck.Picture.load(str(path))["G"], renderer.picture()["G"])
    renderer.picture().save(str(tmp_path / "ball.png"), exposure=-1)


def test_stubs_name_all_that_there_is():
    stubs = pathlib.Path(sunfleck.__file__).with_name("__init__.pyi").read_text(encoding="utf-8")
    for name in sunfleck.__all__:
        assert f"class {name}" in stubs or f"def {name}" in stubs or f"{name}:" in stubs
        for member in vars(getattr(sunfleck, name)) if isinstance(
                getattr(sunfleck, name), type) else ():
            if not member.startswith("_"):
                assert f" {member}(" in stubs or f" {member}:" in stubs, f"{name}.{member}"
