"""The parts of the add-on that do not need Blender. Run: python3 -m unittest in this folder."""

import math
import os
import struct
import sys
import tempfile
import unittest
import zlib
from types import SimpleNamespace

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

from sunfleck_blender import (bends, coats, colour_nodes, export_camera, geometry, image_files,
                              mappings, picture_files, ply, program, scene_text, skies,
                              sky_maps, texture_text, units, values, volumes)
from sunfleck_blender.closures import BLACK, NOTHING, Closure, Plain, add_closures, mix_closures

CUBE = (np.array([(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)], float),
        np.array([(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4),
                  (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5)]))


class Units(unittest.TestCase):
    def test_a_sphere_lights_from_afar_as_the_point_that_it_stands_for(self):
        radius = 0.1
        radiance = units.sphere_radiance(100, radius)
        self.assertAlmostEqual(radiance * math.pi * radius ** 2, units.point_intensity(100))

    def test_a_sun_of_any_angle_has_its_irradiance(self):
        for angle in (1e-4, 0.0093, 0.35):
            solid = 2 * math.pi * (1 - math.cos(angle / 2))
            self.assertAlmostEqual(units.sun_radiance(3, angle) * solid, 3, delta=1e-6 / angle)

    def test_a_spot_falls_off_as_cycles_was_measured(self):
        # Cycles 3.4, 40 degrees, blend 1: intensity over that on the axis, by angle in degrees.
        for degrees, measured in ((6.77, 0.9554), (10.97, 0.7650), (17.03, 0.1752), (20.87, 0)):
            cosine = math.cos(math.radians(degrees))
            self.assertAlmostEqual(units.spot_falloff(cosine, math.cos(math.radians(20)), 1),
                                   measured, delta=2e-3)

    def test_area_lights_have_their_areas(self):
        self.assertEqual(units.area_of_light("SQUARE", 2, 9), 4)
        self.assertEqual(units.area_of_light("RECTANGLE", 2, 3), 6)
        self.assertAlmostEqual(units.area_of_light("DISK", 2, 9), math.pi)
        self.assertAlmostEqual(units.area_of_light("ELLIPSE", 2, 1), math.pi / 2)


class Geometry(unittest.TestCase):
    def test_a_cube_is_closed_and_an_open_doubled_or_twisted_one_is_not(self):
        positions, faces = CUBE
        self.assertTrue(geometry.is_closed(faces))
        self.assertFalse(geometry.is_closed(faces[1:]))
        self.assertFalse(geometry.is_closed(np.concatenate([faces, faces])))
        twisted = faces.copy()
        twisted[0] = twisted[0][::-1]
        self.assertFalse(geometry.is_closed(twisted))
        self.assertAlmostEqual(geometry.triangle_volume(positions, faces), 1)
        self.assertAlmostEqual(geometry.mean_chord(positions, faces), 4 / 6)

    def test_corners_share_vertices_where_they_agree(self):
        corner_vertex = np.array([0, 1, 2, 0, 2, 3])
        uv = np.array([(0, 0), (1, 0), (1, 1), (0, 0), (.5, .5), (0, 1)], float)
        corners, source, (made,) = geometry.corners_to_vertices(corner_vertex, [uv], 5)
        self.assertEqual(len(source), 5)  # vertex 2 twice, vertex 4 not at all
        np.testing.assert_array_equal(made[corners], uv)
        np.testing.assert_array_equal(source[corners], corner_vertex)

    def test_ply_files_hold_what_was_given(self):
        positions, faces = CUBE
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "cube.ply")
            ply.write_ply(path, positions, faces, positions, positions[:, :2])
            with open(path, "rb") as file:
                head, _, body = file.read().partition(b"end_header\n")
        self.assertIn(b"element vertex 8", head)
        self.assertEqual(len(body), 8 * 8 * 4 + 12 * 13)
        self.assertEqual(struct.unpack_from("<8f", body, 32), (1, 0, 0, 1, 0, 0, 1, 0))
        self.assertEqual(struct.unpack_from("<B3i", body, 256), (3, 0, 2, 3))


class Pictures(unittest.TestCase):
    def test_png_has_its_rows_and_sums(self):
        pixels = np.arange(24, dtype=np.uint8).reshape(2, 4, 3)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.png")
            picture_files.write_png(path, pixels)
            with open(path, "rb") as file:
                data = file.read()
        self.assertEqual(struct.unpack(">II", data[16:24]), (4, 2))
        size, = struct.unpack(">I", data[33:37])
        rows = zlib.decompress(data[41:41 + size])
        self.assertEqual(rows, b"\0" + bytes(range(12)) + b"\0" + bytes(range(12, 24)))

    def test_srgb_goes_there_and_back(self):
        values_ = np.linspace(0, 1, 101)
        np.testing.assert_allclose(picture_files.from_srgb(picture_files.to_srgb(values_)), values_,
                                   atol=1e-12)
        self.assertAlmostEqual(float(picture_files.from_srgb(np.array(0.5))), 0.21404, places=4)

    def test_zip_blocks_of_exr_are_unpacked(self):
        plain = np.arange(0, 500, dtype=np.int64) * 7 % 256
        halves = np.concatenate([plain[0::2], plain[1::2]])
        packed = halves.copy()
        packed[1:] = (halves[1:] - halves[:-1] + 128) % 256
        block = zlib.compress(packed.astype(np.uint8).tobytes())
        np.testing.assert_array_equal(picture_files._unpacked(block, 500), plain)

    def test_equal_area_cells_cover_the_sphere_evenly(self):
        directions = sky_maps.equal_area_directions(64)
        np.testing.assert_allclose(np.linalg.norm(directions, axis=-1), 1, atol=1e-12)
        np.testing.assert_allclose(directions.mean(axis=(0, 1)), 0, atol=1e-12)
        second = np.einsum("ijk,ijl->kl", directions, directions) / 64 ** 2
        np.testing.assert_allclose(second, np.eye(3) / 3, atol=1e-3)
        # The map of pbrt-v4: the middle is up, x grows to the right, y downwards in rows.
        self.assertGreater(directions[32, 32, 2], 0.99)
        self.assertGreater(directions[32, 60, 0], 0.5)
        self.assertGreater(directions[60, 32, 1], 0.5)

    def test_a_sun_in_a_panorama_comes_to_its_direction(self):
        panorama = np.zeros((64, 128, 3), np.float32)
        panorama[8:13, 30:35] = 1  # u = .254, v = .836: to the left of the middle, high up
        mapped = sky_maps.equal_area_map(panorama, 64)
        direction = np.einsum("ij,ijk->k", mapped[..., 0], sky_maps.equal_area_directions(64))
        direction /= np.linalg.norm(direction)
        phi, theta = (0.5 - 32.5 / 128) * 2 * math.pi, (0.5 - 10.5 / 64) * math.pi
        expected = (math.cos(phi) * math.cos(theta), math.sin(phi) * math.cos(theta),
                    math.sin(theta))
        self.assertGreater(float(direction @ expected), 0.998)
        # Power: texels times their solid angle.
        power = math.cos(theta) * 25 * (2 * math.pi / 128) * (math.pi / 64)
        self.assertAlmostEqual(float(mapped[..., 0].sum()) * 4 * math.pi / 64 ** 2, power,
                               delta=0.05 * power)


    def test_skies_without_a_sun_are_brightest_around_it_and_blue_away_from_it(self):
        sun = skies.direction_of(90, 40)
        np.testing.assert_allclose(sun[:2], (math.cos(math.radians(40)), 0), atol=1e-12)
        near = skies.preetham(np.array([sun]), sun, 3)[0]
        far = skies.preetham(np.array([[-0.6, 0, 0.8]]), sun, 3)[0]
        self.assertGreater(near[1], 3 * far[1])
        self.assertGreater(far[2], 1.5 * far[0])
        pixels = skies.sky_panorama("HOSEK_WILKIE", sun, 3)
        mapped = sky_maps.equal_area_map(pixels, 64)
        up = np.maximum(sky_maps.equal_area_directions(64)[..., 2], 0)
        ground = (mapped @ values.LUMA * up).sum() * 4 * math.pi / 64 ** 2
        self.assertAlmostEqual(float(ground), 0.2394, delta=0.005)


class Nodes(unittest.TestCase):
    def test_functions_of_checks_apply_to_both_colours(self):
        where = values.Coordinates()
        checks = values.Checks(values.flat(0.25), values.flat(1), where)
        result = values.combine(np.sqrt, [checks])
        self.assertEqual((result.even, result.odd), (values.flat(0.5), values.flat(1)))
        both = values.combine(lambda a, b: a - b, [checks, checks])
        self.assertEqual(both.odd, values.flat(0))

    def test_pictures_that_lie_differently_are_named(self):
        lost = []
        array = np.full((2, 2, 3), 0.5, np.float32)
        first = values.Picture(lambda: array, values.Coordinates())
        turned = values.Coordinates().then(mappings.mapping_matrix("POINT", (0, 0, 0), (0, 0, 1),
                                                                   (1, 1, 1)))
        second = values.Picture(lambda: array, turned)
        result = values.combine(np.multiply, [first, second], lost.append)
        np.testing.assert_allclose(result.pixels(), 0.25)
        self.assertEqual(len(lost), 1)
        values.combine(np.multiply, [first, first], lost.append)
        self.assertEqual(len(lost), 1)

    def test_mapping_nodes_of_both_kinds_undo_each_other(self):
        numbers = ((1, 2, 3), (0.1, 0.2, 0.3), (2, 3, 4))
        there = mappings.mapping_matrix("POINT", *numbers)
        back = mappings.mapping_matrix("TEXTURE", *numbers)
        np.testing.assert_allclose(back @ there, np.eye(4), atol=1e-12)

    def test_turned_textures_need_a_base_and_scaled_ones_do_not(self):
        turned = mappings.mapping_matrix("POINT", (0.5, 0, 0), (0, 0, 0.7), (2, 2, 1))
        plane = values.Coordinates().then(turned).plane()
        self.assertIsNone(texture_text.relative(plane, texture_text.UNIT))
        self.assertTrue(texture_text.is_identity(texture_text.relative(plane, plane)))
        scale = values.Coordinates().then(np.diag([2.0, 3, 1, 1])).plane()
        np.testing.assert_allclose(texture_text.relative(scale, texture_text.UNIT), (2, 3, 0, 0))

    def test_colour_nodes_agree_with_blender(self):
        red = np.array([[0.8, 0.2, 0.2]])
        grey = np.array([[0.5] * 3])
        one = np.array([[1.0] * 3])
        np.testing.assert_allclose(colour_nodes.hue_saturation(red, grey, one, one), red)
        turned = colour_nodes.hue_saturation(red, grey + 1 / 3, one, one)
        np.testing.assert_allclose(turned, [[0.2, 0.8, 0.2]], atol=1e-12)
        np.testing.assert_allclose(colour_nodes.black_body(6500), 1, atol=0.08)
        warm = colour_nodes.black_body(2700)
        self.assertTrue(warm[0] > warm[1] > warm[2])

    def test_weaker_normal_maps_are_flatter(self):
        texel = np.array([[[0.5 + 0.3, 0.5, 0.5 + 0.4]]])
        np.testing.assert_allclose(bends.weakened(texel, 1), texel)
        np.testing.assert_allclose(bends.weakened(texel, 0), [[[0.5, 0.5, 1]]])

    def test_file_endings_come_from_contents(self):
        self.assertEqual(image_files.file_ending(b"\xff\xd8\xff\xe0"), ".jpg")
        self.assertIsNone(image_files.file_ending(b"<html>"))
        self.assertEqual(image_files.direct_encoding(".png", "Non-Color"), "linear")
        self.assertIsNone(image_files.direct_encoding(".jpg", "Non-Color"))
        self.assertIsNone(image_files.direct_encoding(".png", "Filmic Log"))


class Closures(unittest.TestCase):
    def test_transparent_becomes_alpha(self):
        red = Closure(Plain("diffuse", {"reflectance": values.flat(1, 0, 0)}))
        mixed = mix_closures(values.flat(0.25), NOTHING, red, self.fail)
        self.assertEqual((mixed.material, mixed.alpha), (red.material, values.flat(0.25)))

    def test_emission_is_added_to_a_surface(self):
        red = Closure(Plain("diffuse", {"reflectance": values.flat(1, 0, 0)}))
        lamp = Closure(BLACK, emission=values.flat(3))
        both = add_closures(red, lamp, self.fail)
        self.assertEqual((both.material, both.emission), (red.material, values.flat(3)))

    def test_two_surfaces_are_mixed_and_named(self):
        said = []
        red = Closure(Plain("diffuse", {"reflectance": values.flat(0.4)}))
        metal = Closure(Plain("conductor", {"reflectance": values.flat(0.8)}))
        both = add_closures(red, metal, said.append)
        self.assertEqual(both.material.first.spectra["reflectance"], values.flat(0.8))
        self.assertEqual(both.material.second.spectra["reflectance"], values.flat(1))
        self.assertEqual(len(said), 1)

    def test_smooth_coats_pass_what_fresnel_says(self):
        self.assertAlmostEqual(coats.entering(1, 0, 1.5), 0.96)
        self.assertAlmostEqual(coats.entering(1, 0.01, 1.5), 0.96, delta=1e-3)
        self.assertLess(coats.entering(1, 0.8, 1.5), 0.94)


class Socket(SimpleNamespace):
    """A socket of a node, of a value or linked to a node."""
    def __init__(self, value=None, node=None):
        links = [SimpleNamespace(from_node=node, from_socket=None)] if node else []
        super().__init__(value=value, is_linked=node is not None, links=links)


class Sockets(dict):
    def __getitem__(self, key):
        return list(self.values())[key]


def volume_node(kind, **inputs):
    return SimpleNamespace(type=kind, mute=False, bl_label=kind, inputs=Sockets(
        {name.replace("_", " "): Socket(value) for name, value in inputs.items()}))


class VolumeReader:
    """Stands for ShaderReader: values are those of the sockets."""
    def __init__(self):
        self.said = []
        self.missing = self.said.append
        self.textures = self

    def value(self, found, groups):
        return values.flat(*np.atleast_1d(found.value))

    def number(self, node, name, groups):
        return values.number(self.value(volumes.socket(node, name), groups))


class Volumes(unittest.TestCase):
    """Coefficients by Blender's manual and Cycles' node_principled_volume.osl."""
    def read(self, node):
        self.reader = VolumeReader()
        return volumes.volume_of(self.reader, Socket(node=node))

    def check(self, node, absorbs, scatters, bend):
        volume = self.read(node)
        np.testing.assert_allclose(volume.absorbs, absorbs, atol=1e-12)
        np.testing.assert_allclose(volume.scatters, scatters, atol=1e-12)
        self.assertAlmostEqual(volume.bend, bend)

    SCATTER = {"Color": (0.2, 0.5, 1.5), "Density": 2, "Anisotropy": 0.4}
    PRINCIPLED = {"Color": (0.5, 0.5, 1), "Density": 3, "Anisotropy": -0.2,
                  "Absorption_Color": (0, 0.25, 0)}

    def test_scatter_is_colour_times_density(self):
        self.check(volume_node("VOLUME_SCATTER", **self.SCATTER), 0, (0.4, 1, 3), 0.4)

    def test_absorption_is_what_is_missing_to_white(self):
        self.check(volume_node("VOLUME_ABSORPTION", Color=(0.2, 0.5, 1.5), Density=2),
                   (1.6, 1, 0), 0, 0)

    def test_principled_absorbs_part_of_what_it_does_not_scatter(self):
        node = volume_node("PRINCIPLED_VOLUME", **self.PRINCIPLED)
        self.check(node, (1.5, 0.75, 0), (1.5, 1.5, 3), -0.2)
        self.assertEqual(self.reader.said, [])

    def test_sums_have_both_and_a_mean_phase_function(self):
        parts = [volume_node("VOLUME_SCATTER", Color=1, Density=density, Anisotropy=g)
                 for density, g in ((3, 0.5), (1, -0.1))]
        both = volume_node("ADD_SHADER")
        both.inputs = [Socket(node=part) for part in parts]
        self.check(both, 0, 4, (3 * 0.5 - 0.1) / 4)
        self.assertEqual(len(self.reader.said), 1)
        both.inputs[1] = Socket(node=volume_node("VOLUME_ABSORPTION", Color=0, Density=2))
        self.check(both, 2, 3, 0.5)
        self.assertEqual(self.reader.said, [])

    def test_mixes_have_shares(self):
        mix = volume_node("MIX_SHADER")
        mix.inputs = [Socket(0.25), Socket(node=volume_node("VOLUME_SCATTER", **self.SCATTER)),
                      Socket(node=volume_node("VOLUME_ABSORPTION", Color=0, Density=2))]
        self.check(mix, 0.5, (0.3, 0.75, 2.25), 0.4)

    def test_emission_is_colour_times_strength_over_what_is_absorbed(self):
        volume = self.read(volume_node("PRINCIPLED_VOLUME", **self.PRINCIPLED,
                                       Emission_Color=(1, 0.5, 0), Emission_Strength=3))
        np.testing.assert_allclose(volume.emits, (3, 1.5, 0))
        text = scene_text.SceneText()
        volume.write(text, "fire")
        self.assertIn('"rgb sigma_a" [ 1.5 0.75 0 ]', text.text())
        self.assertIn('"rgb Le" [ 2 2 0 ]', text.text())
        self.assertEqual(self.reader.said, [])

    def test_what_only_emits_absorbs_next_to_nothing(self):
        volume = self.read(volume_node("EMISSION", Color=(1, 0.5, 0), Strength=2))
        self.assertFalse(volume.is_empty())
        text = scene_text.SceneText()
        volume.write(text, "gas")
        self.assertIn('"rgb Le" [ 200000 100000 0 ]', text.text())
        self.assertIn('"rgb sigma_s" [ 0 0 0 ]', text.text())

    def test_what_is_not_known_is_named(self):
        self.read(volume_node("PRINCIPLED_VOLUME", **self.PRINCIPLED, Blackbody_Intensity=1))
        self.assertEqual(self.reader.said, ["black body of a volume: left out"])
        self.assertTrue(self.read(volume_node("HOLDOUT")).is_empty())
        self.assertIn("HOLDOUT", self.reader.said[0])


class Text(unittest.TestCase):
    def test_odd_names_stay_on_their_line(self):
        text = scene_text.SceneText()
        text.about('object a"b\\c\nWorldEnd | \u2028 é')
        text.say("NamedMaterial", 'a"b\\c\nd')
        self.assertEqual(len(text.text().splitlines()), 2)
        self.assertEqual(text.lines[1], 'NamedMaterial "a\\"b\\\\c\\nd"')

    def test_faults_are_told_by_name(self):
        text = scene_text.SceneText()
        text.say("WorldBegin")
        text.about("object Cube: the first")
        text.say("Shape", "plymesh")
        message = text.explain("/some/where/scene.pbrt:3:7: no such file; check the name")
        self.assertEqual(message, "object Cube: the first: no such file; check the name")
        self.assertEqual(text.explain("no threads"), "no threads")

    def test_numbers_that_are_none_are_refused(self):
        with self.assertRaises(ValueError):
            scene_text.number(float("nan"))
        self.assertEqual(scene_text.parameter("rgb L", (1, 0.5, 2e-9)), '"rgb L" [ 1 0.5 2e-09 ]')

    def test_the_screen_follows_blenders_sensor_and_shift(self):
        wide = export_camera.screen_window("AUTO", (200, 100), (1, 1), (0, 0), 0.36)
        np.testing.assert_allclose(wide, (-0.36, 0.36, -0.18, 0.18))
        tall = export_camera.screen_window("AUTO", (100, 200), (1, 1), (0, 0), 0.36)
        np.testing.assert_allclose(tall, (-0.18, 0.18, -0.36, 0.36))
        shifted = export_camera.screen_window("VERTICAL", (200, 100), (1, 1), (0.5, 0), 0.36)
        np.testing.assert_allclose(shifted, (0.36 - 0.72, 0.36 + 0.72, -0.36, 0.36))

    def test_regions_are_cut_to_whole_pixels(self):
        render = SimpleNamespace(resolution_x=101, resolution_y=50, resolution_percentage=50,
                                 use_border=True, border_min_x=0.5, border_max_x=0.5,
                                 border_min_y=0, border_max_y=0.5)
        self.assertEqual(export_camera.region(render), (25, 26, 0, 12))


class Program(unittest.TestCase):
    SETTINGS = {"time": 60, "target_error": 1.0, "passes": 0, "threads": 0, "seed": 0,
                "aovs": ["normal"], "light_groups": [("sun", [1, 3])]}

    def test_flags_are_an_argument_list(self):
        self.assertEqual(program.render_arguments(self.SETTINGS),
                         ["--time", "60s", "--target-error", "1%", "--aovs", "normal",
                          "--light-group", "sun=1,3"])

    def test_a_missing_program_is_told_with_the_remedy(self):
        with self.assertRaisesRegex(program.ProgramFault, "Preferences"):
            program.find_program("/no/such/program")

    def test_groups_have_names_that_exr_takes(self):
        groups = program.groups_of(["Key Light.001", "Rim", "Key Light.001"], lambda name: name)
        self.assertEqual(groups, [("Key_Light_001", [1, 3]), ("Rim", [2])])

    def test_what_the_program_says_is_understood(self):
        lines = ["scene.pbrt:2:1: warning: Option is ignored", "first pass, 20 s",
                 "64 passes, 11 s, error 1.9%, target 1%", "scene.pbrt:9:1: unknown word; mend it"]
        self.assertEqual(program.progress_of(lines), lines[2])
        self.assertEqual(program.faults_of(lines), lines[3:])
        self.assertEqual(program.warnings_of(lines), ["scene.pbrt:2:1: Option is ignored"])

    def test_progress_is_that_of_the_nearest_end(self):
        self.assertEqual(program.fraction_done(self.SETTINGS, 30, 8, None), 0.5)
        self.assertEqual(program.fraction_done(self.SETTINGS, 6, 8, 2.0), 0.25)
        self.assertEqual(program.fraction_done(self.SETTINGS, 99, 8, 2.0), 1.0)


if __name__ == "__main__":
    unittest.main()
