"""Tests of numbers, arrays and other values as they reach the library."""

import decimal
import fractions
import pathlib

import numpy
import pytest
from small_scene import quick

import sunfleck

CORNERS = numpy.array([[-4, -4, 0], [4, -4, 0], [4, 4, 0], [-4, 4, 0]], dtype=float)
TRIANGLES = numpy.array([[0, 1, 2], [0, 2, 3]])


def lit(parameters):
    """The mean luminance of a table below a lamp with these parameters."""
    builder = sunfleck.SceneBuilder()
    builder.camera("perspective", {"float fov": 35},
                   sunfleck.Transform.look_at((0, -6, 4), (0, 0, 0.6), (0, 0, 1)))
    builder.film(4, 4)
    builder.mesh(CORNERS, TRIANGLES)
    builder.light("point", parameters, sunfleck.Transform.translate((0, 0, 5)))
    renderer = sunfleck.Renderer(builder.build(), passes=1, photons_per_pass=1000,
                                 photon_sampler="uniform")
    renderer.run()
    return renderer.picture()["G"].mean()


def refused(parameters, call="shape"):
    with pytest.raises(sunfleck.Error) as raised:
        sunfleck.SceneBuilder().shape("sphere", parameters)
    assert raised.value.file.startswith(call) and raised.value.code == "input"
    return str(raised.value)


@pytest.mark.parametrize("number", [
    3000000000, 2**32 + 1, 2**70, numpy.int64(3000000000), numpy.uint64(2**63),
    numpy.array(2**40), fractions.Fraction(10**10, 3), decimal.Decimal("3e9"), numpy.float16(7)])
def test_every_kind_of_number_is_that_number(number):
    assert lit({"float scale": number, "rgb I": [1, 1, 1]}) == pytest.approx(
        lit({"float scale": float(number), "rgb I": [1, 1, 1]}))


@pytest.mark.parametrize("numbers", [
    numpy.array([2**40] * 3, numpy.uint64), numpy.array([3000000000, 1, 2**32 + 1]),
    [3000000000, 2**70, 1], numpy.array([200, 100, 50], numpy.uint8), range(1, 4), ((1, 2, 3),),
    numpy.array([1, 2, 3], ">i2"), memoryview(b"\1\2\3")])
def test_whole_numbers_in_arrays_and_lists_do_not_wrap(numbers):
    expected = [float(number) for number in numpy.array(numbers, dtype=object).ravel()]
    assert lit({"rgb I": numbers}) == pytest.approx(lit({"rgb I": expected}))


def test_whole_numbers_that_no_integer_holds_are_refused():
    for number in (2**31, numpy.array([2**32 + 1]), 2.5):
        with pytest.raises(sunfleck.Error, match="levels.*whole numbers"):
            sunfleck.SceneBuilder().shape("loopsubdiv", {"integer levels": number})


@pytest.mark.parametrize("value", [
    [1, "a"], b"\x01", None, {1}, (number for number in [1]), 1j, numpy.array([1j]), [1, None],
    [[1, 2], [3]], [True, False], pathlib.Path, numpy.datetime64("2020-01-01"), 10**400])
def test_what_is_no_number_is_refused_with_the_parameter(value):
    assert '"float radius"' in refused({"float radius": value})


def test_strings_are_not_mixed_with_numbers():
    assert '"string filename"' in refused({"string filename": ["a", 1]})
    assert "give strings alone" in refused({"string filename": ["a", 1]})


def test_a_key_that_is_no_declaration_is_refused():
    assert "float radius" in refused({5: 1})
    assert "b'float radius'" in refused({b"float radius": 1})


@pytest.mark.parametrize("flag", [True, numpy.True_, numpy.array(True), [True]])
def test_truth_values_of_all_kinds_are_one(flag):
    sunfleck.SceneBuilder().material("m", "conductor", {"bool remaproughness": flag})


def test_rows_of_parameters_have_the_length_of_their_type():
    for declaration, shape in (("point3 P", (3, 4)), ("point2 uv", (2, 3)), ("rgb L", (3, 1))):
        message = refused({declaration: numpy.zeros(shape)})
        assert declaration in message and str(shape) in message


def mesh_refused(positions=CORNERS, triangles=TRIANGLES, normals=None, uvs=None):
    with pytest.raises(sunfleck.Error) as raised:
        sunfleck.SceneBuilder().mesh(positions, triangles, normals, uvs)
    assert raised.value.file == "mesh"
    return str(raised.value)


@pytest.mark.parametrize("name, shape", [
    ("positions", (3, 4)), ("positions", (6, 2)), ("positions", (4, 3, 1)), ("normals", (3, 4)),
    ("uvs", (2, 4)), ("uvs", (4, 3))])
def test_a_mesh_refuses_rows_of_another_length(name, shape):
    message = mesh_refused(**{name: numpy.zeros(shape)})
    assert name in message and str(shape) in message


@pytest.mark.parametrize("triangles", [
    numpy.array([[0, 1, 2, 3]]), numpy.array([[0], [1], [2]]), numpy.array([0, 0.9, 2]),
    [0, numpy.nan, 2], ["0", "1", "2"], [0, 1, 2 + 2**32], [0, 1, -1], [0, 1, 2**63], [0, 1, 2**70],
    [True, False, True], None])
def test_a_mesh_refuses_what_are_no_triangles(triangles):
    assert "triangles" in mesh_refused(triangles=triangles)


@pytest.mark.parametrize("positions", [
    CORNERS + 1j, CORNERS > 0, CORNERS.astype(str), None, "abc", [[0, 0, 0], [1, 0]]])
def test_a_mesh_refuses_positions_that_are_no_numbers(positions):
    assert "positions" in mesh_refused(positions=positions)


def test_a_mesh_takes_arrays_of_any_layout_and_flat_ones():
    for positions in (CORNERS, CORNERS.ravel(), CORNERS.tolist(), numpy.asfortranarray(CORNERS),
                      CORNERS.astype(int), CORNERS.astype(">f8"), CORNERS.astype(numpy.float16)):
        for triangles in (TRIANGLES, TRIANGLES.ravel(), TRIANGLES.astype(numpy.int8),
                          TRIANGLES.astype(numpy.uint64)[::-1]):
            sunfleck.SceneBuilder().mesh(positions, triangles)


@pytest.mark.parametrize("value", [b"2", None, {2}, {"a": 1}, [None], [b"2"]])
def test_settings_that_are_no_words_are_refused_by_name(scene, value):
    with pytest.raises(sunfleck.Error) as raised:
        sunfleck.Renderer(scene, passes=value)
    assert raised.value.file == "passes"


def test_settings_take_numbers_of_numpy(scene):
    renderer = sunfleck.Renderer(scene, passes=numpy.int64(2), resolution=numpy.array([8, 6]),
                                 splitting=numpy.False_, seed=numpy.array(3), time=numpy.float32(9))
    assert renderer.picture()["G"].shape == (6, 8)


def test_sizes_and_counts_are_not_cut_off(scene):
    renderer = quick(scene)
    for number in (2.5, numpy.float32(2.5), decimal.Decimal("2.5"), "2"):
        for call in (lambda n: sunfleck.SceneBuilder().film(n, 16), renderer.step,
                     lambda n: renderer.set_resolution(16, n),
                     lambda n: renderer.set_crop((0, n, 0, 4)),
                     lambda n: sunfleck.Renderer(scene, threads=n)):
            with pytest.raises(TypeError):
                call(number)
    for number in (-1, 2**32):
        for name, call in (("passes", renderer.step),
                           ("threads", lambda n: sunfleck.Renderer(scene, threads=n))):
            with pytest.raises(sunfleck.Error, match=f"{name}.*whole number"):
                call(number)
    sunfleck.SceneBuilder().film(numpy.int64(16), numpy.uint8(16))
    renderer.set_crop(numpy.array([0, 8, 0, 8]))
    assert renderer.step(numpy.uint64(1))
