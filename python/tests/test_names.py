"""Tests of names that are no UTF-8, and of paths."""

import os
import pathlib

import numpy
import pytest
from small_scene import BALL, quick

import sunfleck

FOLDER, NAME = os.fsdecode(b"l\xe4t"), os.fsdecode(b"gl\xe4s")


@pytest.fixture(name="folder")
def folder_of_odd_name(tmp_path):
    folder = tmp_path / FOLDER
    folder.mkdir()
    return folder


@pytest.fixture(name="path")
def path_of_odd_name(folder):
    path = folder / f"{NAME}.pbrt"
    path.write_text(BALL + 'Shape "sphere" "float radii" 1', encoding="ascii")
    return path


@pytest.mark.parametrize("kind", [pathlib.Path, str, os.fsencode])
def test_scenes_are_loaded_from_any_path(path, kind):
    scene = sunfleck.Scene.load(kind(path))
    assert scene.files == [str(path)]
    assert str(path) in scene.lights[0].where
    assert any(NAME in line for line in scene.warnings)
    with pytest.warns(UserWarning, match=NAME):
        quick(scene)


def test_errors_tell_names_of_any_bytes(path):
    path.write_bytes(os.fsencode(BALL + f'NamedMaterial "{NAME}"\nShape "sphere"'))
    with pytest.raises(sunfleck.Error, match=NAME) as raised:
        sunfleck.Scene.load(path)
    assert raised.value.file == str(path)
    with pytest.raises(sunfleck.Error, match=NAME) as raised:
        sunfleck.Scene.parse(path.read_bytes(), path)
    assert raised.value.file == str(path)
    missing = path.with_name(f"no {NAME}")
    for load in (sunfleck.Scene.load, sunfleck.Picture.load):
        with pytest.raises(sunfleck.Error, match=NAME):
            load(missing)


def test_names_of_any_bytes_are_found_again(folder):
    builder = sunfleck.SceneBuilder(folder)
    builder.material(NAME, "diffuse")
    builder.shape("sphere", {"float radius": 1}, material=NAME)
    builder.light("point", {"rgb I": [1, 1, 1]})
    builder.camera("perspective", {"float fov": 35}, sunfleck.Transform.translate((0, 0, -9)))
    builder.film(4, 4)
    scene = builder.build()
    assert all(str(folder) in file for file in scene.files)
    with pytest.raises(sunfleck.Error, match=NAME):
        sunfleck.Renderer(scene, photon_sampler=NAME)


@pytest.mark.parametrize("kind", [pathlib.Path, str, os.fsencode])
def test_pictures_are_saved_at_any_path(scene, folder, kind):
    picture = quick(scene).picture()
    picture.save(kind(folder / f"{NAME}.exr"))
    again = sunfleck.Picture.load(kind(folder / f"{NAME}.exr"))
    assert numpy.array_equal(again["G"], picture["G"])


@pytest.mark.parametrize("kind", [pathlib.Path, str])
def test_parameters_take_paths(folder, kind):
    shape = folder / f"{NAME}.ply"
    shape.write_text("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                     "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                     "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", encoding="ascii")
    builder = sunfleck.SceneBuilder()
    builder.shape("plymesh", {"string filename": kind(shape)})
    builder.camera("perspective", {"float fov": 35}, sunfleck.Transform())
    builder.light("point", {"rgb I": [1, 1, 1]})
    builder.film(4, 4)
    assert builder.build().triangle_count == 1


def test_a_string_that_has_no_bytes_is_told_as_python_does():
    with pytest.raises(UnicodeEncodeError):
        sunfleck.Scene.load("\ud800")
    with pytest.raises(UnicodeEncodeError):
        sunfleck.SceneBuilder().material("m", "diffuse", {"string x": "\ud800"})
