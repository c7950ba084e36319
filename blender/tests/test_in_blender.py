"""The add-on inside Blender, without a window.

Usage: blender -b --factory-startup --python-exit-code 1 --python test_in_blender.py -- PROGRAM
"""

import math
import os
import re
import subprocess
import sys
import tempfile
import time
import unittest

import bpy
import numpy as np

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

import sunfleck_blender
from sunfleck_blender import picture_files, program
from sunfleck_blender.engine import image_path
from sunfleck_blender.export_scene import export_scene
from sunfleck_blender.scene_text import SceneFault

PROGRAM = sys.argv[sys.argv.index("--") + 1]


def material(name, kind="ShaderNodeBsdfDiffuse", **inputs):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    tree = made.node_tree
    tree.nodes.clear()
    shader = tree.nodes.new(kind)
    for key, value in inputs.items():
        shader.inputs[key.replace("_", " ")].default_value = value
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    tree.links.new(shader.outputs[0], output.inputs["Surface"])
    return made, tree, shader


def fill_world(kind=None, strength=0, **inputs):
    """Gives the scene a white world, full of a volume where one is named."""
    world = bpy.data.worlds.new("World")
    world.use_nodes = True
    tree = world.node_tree
    background = next(n for n in tree.nodes if n.type == "BACKGROUND")
    background.inputs["Color"].default_value = (1, 1, 1, 1)
    background.inputs["Strength"].default_value = strength
    if kind:
        volume = tree.nodes.new(kind)
        for key, value in inputs.items():
            volume.inputs[key].default_value = value
        tree.links.new(volume.outputs[0], tree.nodes["World Output"].inputs["Volume"])
    bpy.context.scene.world = world


class Case(unittest.TestCase):
    def setUp(self):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        sunfleck_blender.register()
        self.addCleanup(sunfleck_blender.unregister)
        scene = bpy.context.scene
        scene.render.engine = "SUNFLECK"
        scene.render.resolution_x, scene.render.resolution_y = 32, 24
        camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
        camera.location = (0, 0, 10)
        scene.collection.objects.link(camera)
        scene.camera = camera
        self.warnings = []
        self.folder = self.enterContext(tempfile.TemporaryDirectory())

    def export(self):
        """Exports the scene, and returns its text and what `sunfleck info` says of it."""
        depsgraph = bpy.context.evaluated_depsgraph_get()
        exported = export_scene(depsgraph, self.folder, image_path, 64, self.warnings.append)
        with open(exported.file, encoding="utf-8") as file:
            text = file.read()
        said = subprocess.run([PROGRAM, "info", exported.file], capture_output=True, text=True)
        self.assertEqual(said.returncode, 0, said.stderr)
        return text, said.stdout

    def meshes(self):
        folder = os.path.join(self.folder, "meshes")
        return sorted(os.listdir(folder)) if os.path.isdir(folder) else []

    def render(self, passes=16):
        """Renders a few passes; returns the pixels, the lowest row first."""
        scene = bpy.context.scene
        scene.sunfleck.time, scene.sunfleck.target_error = 0, 0
        scene.sunfleck.passes = passes
        scene.render.image_settings.file_format = "OPEN_EXR"
        scene.render.image_settings.color_depth = "32"
        scene.render.filepath = os.path.join(self.folder, "out.exr")
        old = os.environ["PATH"]
        os.environ["PATH"] = os.path.dirname(PROGRAM) + os.pathsep + old
        try:
            bpy.ops.render.render(write_still=True)
        finally:
            os.environ["PATH"] = old
        image = bpy.data.images.load(scene.render.filepath)
        values = np.empty(image.size[0] * image.size[1] * 4, np.float32)
        image.pixels.foreach_get(values)
        return values.reshape(image.size[1], image.size[0], 4)


class Objects(Case):
    def test_curves_texts_surfaces_and_metaballs_are_meshes(self):
        bpy.ops.curve.primitive_bezier_circle_add()
        bpy.context.object.data.bevel_depth = 0.1
        bpy.ops.object.text_add()
        bpy.context.object.data.extrude = 0.1
        bpy.ops.surface.primitive_nurbs_surface_sphere_add()
        bpy.ops.object.metaball_add(type="BALL")
        text, info = self.export()
        self.assertEqual(len(self.meshes()), 4, text)
        self.assertEqual(self.warnings, [])

    def test_modifiers_and_shape_keys_are_applied(self):
        bpy.ops.mesh.primitive_cube_add()
        cube = bpy.context.object
        cube.modifiers.new("Subdivision", "SUBSURF").render_levels = 1
        cube.shape_key_add(name="Basis")
        key = cube.shape_key_add(name="Up")
        for point in key.data:
            point.co.z += 5
        key.value = 1
        text, _ = self.export()
        with open(os.path.join(self.folder, "meshes", self.meshes()[0]), "rb") as file:
            head, _, body = file.read().partition(b"end_header\n")
        count = int(re.search(rb"vertex (\d+)", head)[1])
        self.assertEqual(count, 26)
        places = np.frombuffer(body[:count * 12], "<f4").reshape(-1, 3)
        self.assertGreater(places[:, 2].min(), 4)

    def test_linked_duplicates_and_collection_instances_share_one_mesh(self):
        bpy.ops.mesh.primitive_cube_add()
        cube = bpy.context.object
        for x in (3, 6):
            copy = bpy.data.objects.new("Copy", cube.data)
            copy.location.x = x
            bpy.context.scene.collection.objects.link(copy)
        group = bpy.data.collections.new("Group")
        group.objects.link(cube)
        empty = bpy.data.objects.new("Instance", None)
        empty.instance_type, empty.instance_collection = "COLLECTION", group
        empty.location.y, empty.scale.x = 4, -1
        bpy.context.scene.collection.objects.link(empty)
        text, _ = self.export()
        self.assertEqual(len(self.meshes()), 1)
        self.assertEqual(text.count("ObjectInstance "), 4)

    def test_particles_and_their_emitter_are_exported(self):
        bpy.ops.mesh.primitive_ico_sphere_add(radius=0.1)
        ball = bpy.context.object
        bpy.ops.mesh.primitive_plane_add(size=4)
        plane = bpy.context.object
        plane.modifiers.new("Particles", "PARTICLE_SYSTEM")
        settings = plane.particle_systems[0].settings
        settings.type, settings.count = "HAIR", 20
        settings.render_type, settings.instance_object = "OBJECT", ball
        text, _ = self.export()
        self.assertGreaterEqual(text.count("ObjectInstance "), 20)
        self.assertEqual(len(self.meshes()), 2)

    def test_instances_of_geometry_nodes_share_one_mesh(self):
        bpy.ops.mesh.primitive_grid_add(x_subdivisions=2, y_subdivisions=2)
        modifier = bpy.context.object.modifiers.new("Nodes", "NODES")
        tree = bpy.data.node_groups.new("Tree", "GeometryNodeTree")
        tree.inputs.new("NodeSocketGeometry", "Geometry")
        tree.outputs.new("NodeSocketGeometry", "Geometry")
        given, end = tree.nodes.new("NodeGroupInput"), tree.nodes.new("NodeGroupOutput")
        cube = tree.nodes.new("GeometryNodeMeshCube")
        on_points = tree.nodes.new("GeometryNodeInstanceOnPoints")
        tree.links.new(given.outputs[0], on_points.inputs["Points"])
        tree.links.new(cube.outputs[0], on_points.inputs["Instance"])
        tree.links.new(on_points.outputs[0], end.inputs[0])
        modifier.node_group = tree
        text, _ = self.export()
        self.assertEqual((text.count("ObjectInstance "), len(self.meshes())), (9, 1))

    def test_hidden_empty_and_flattened_things_are_left_out(self):
        bpy.ops.mesh.primitive_cube_add()
        bpy.context.object.hide_render = True
        bpy.context.object.hide_viewport = True
        empty = bpy.data.objects.new("No faces", bpy.data.meshes.new("No faces"))
        bpy.context.scene.collection.objects.link(empty)
        bpy.data.meshes.new("No user")
        bpy.ops.mesh.primitive_cube_add()
        bpy.context.object.scale.z = 0
        self.export()
        self.assertEqual(self.meshes(), [])
        self.assertTrue(any("no extent" in w for w in self.warnings), self.warnings)

    def test_slots_are_split_and_empty_slots_are_grey(self):
        bpy.ops.mesh.primitive_cube_add()
        cube = bpy.context.object
        red, _, _ = material('Re"d\\ | é', Color=(1, 0, 0, 1))
        cube.data.materials.append(red)
        cube.data.materials.append(None)
        cube.name = 'Cu"be\\n'
        cube.data.polygons[0].material_index = 1
        cube.data.polygons[1].material_index = 7
        text, _ = self.export()
        self.assertEqual(len(self.meshes()), 3)
        self.assertEqual(text.count("MakeNamedMaterial"), 2)


class Materials(Case):
    def plane(self, made):
        bpy.ops.mesh.primitive_plane_add(size=4)
        bpy.context.object.data.materials.append(made)

    def test_packed_generated_and_missing_images_are_read(self):
        for kind in ("packed", "generated", "missing"):
            made, tree, shader = material(kind)
            node = tree.nodes.new("ShaderNodeTexImage")
            tree.links.new(node.outputs[0], shader.inputs["Color"])
            if kind == "missing":
                image = bpy.data.images.new("gone", 4, 4)
                image.source, image.filepath = "FILE", "//no/such/file.png"
            else:
                image = bpy.data.images.new(kind, 4, 4)
                image.pixels.foreach_set(np.full(64, 0.5, np.float32))
                if kind == "packed":
                    image.pack()
            node.image = image
            self.plane(made)
        text, _ = self.export()
        self.assertEqual(text.count('"imagemap"'), 2)
        self.assertTrue(any("gone" in w and "missing" in w for w in self.warnings), self.warnings)

    def test_what_is_not_known_is_named_once_a_material(self):
        made, tree, shader = material("Noisy")
        noise = tree.nodes.new("ShaderNodeTexNoise")
        tree.links.new(noise.outputs["Color"], shader.inputs["Color"])
        self.plane(made)
        self.plane(made)
        self.export()
        self.assertEqual(len([w for w in self.warnings if "Noise" in w]), 1)

    def test_groups_reroutes_and_muted_nodes_are_followed(self):
        group = bpy.data.node_groups.new("Tint", "ShaderNodeTree")
        group.inputs.new("NodeSocketColor", "In").default_value = (0.1, 0.2, 0.3, 1)
        group.outputs.new("NodeSocketColor", "Out")
        start, end = group.nodes.new("NodeGroupInput"), group.nodes.new("NodeGroupOutput")
        turn = group.nodes.new("NodeReroute")
        group.links.new(start.outputs[0], turn.inputs[0])
        group.links.new(turn.outputs[0], end.inputs[0])
        made, tree, shader = material("Grouped")
        node = tree.nodes.new("ShaderNodeGroup")
        node.node_tree = group
        invert = tree.nodes.new("ShaderNodeInvert")
        invert.mute = True
        tree.links.new(node.outputs[0], invert.inputs["Color"])
        tree.links.new(invert.outputs[0], shader.inputs["Color"])
        self.plane(made)
        text, _ = self.export()
        self.assertIn('"rgb reflectance" [ 0.100000001 0.200000003 0.300000012 ]', text)
        self.assertEqual(self.warnings, [])

    def test_glass_absorbs_by_its_volume_and_its_colour(self):
        made, tree, _ = material("Tinted", "ShaderNodeBsdfGlass", Color=(0.5, 1, 1, 1), IOR=1.4)
        volume = tree.nodes.new("ShaderNodeVolumeAbsorption")
        volume.inputs["Color"].default_value = (1, 0.5, 1, 1)
        volume.inputs["Density"].default_value = 3
        output = next(n for n in tree.nodes if n.type == "OUTPUT_MATERIAL")
        tree.links.new(volume.outputs[0], output.inputs["Volume"])
        bpy.ops.mesh.primitive_cube_add(size=2)
        bpy.context.object.data.materials.append(made)
        text, _ = self.export()
        sigma = re.search(r'"rgb sigma_a" \[ (\S+) (\S+) (\S+) \]', text)
        # A mean way through the cube is 4/3 long; both crossings leave a quarter of the red.
        self.assertAlmostEqual(float(sigma[1]), -2 * math.log(0.5) / (4 / 3), places=4)
        self.assertAlmostEqual(float(sigma[2]), 1.5, places=4)

    def full_cube(self, kind="ShaderNodeVolumeScatter", surface=None, **inputs):
        """Adds a cube of 2 full of a volume; returns the volume's node."""
        made, tree, _ = material("Full", surface or "ShaderNodeBsdfTransparent")
        output = next(n for n in tree.nodes if n.type == "OUTPUT_MATERIAL")
        if surface is None:
            tree.links.remove(output.inputs["Surface"].links[0])
        volume = tree.nodes.new(kind)
        for key, value in inputs.items():
            volume.inputs[key.replace("_", " ")].default_value = value
        tree.links.new(volume.outputs[0], output.inputs["Volume"])
        bpy.ops.mesh.primitive_cube_add(size=2)
        bpy.context.object.data.materials.append(made)
        return volume

    def test_volumes_that_scatter_fill_meshes_with_and_without_a_surface(self):
        for surface in (None, "ShaderNodeBsdfTransparent", "ShaderNodeBsdfGlass"):
            self.full_cube("ShaderNodeVolumePrincipled", surface, Color=(0.5, 0.5, 1, 1),
                           Density=3, Anisotropy=-0.2, Absorption_Color=(0, 0.25, 0, 1))
            text, _ = self.export()
            self.assertIn('"rgb sigma_a" [ 1.5 0.75 0 ] "rgb sigma_s" [ 1.5 1.5 3 ] '
                          '"float g" [ -0.200000003 ]', text)
            self.assertIn('MediumInterface "inside Full of Cube" ""', text)
            self.assertEqual('"interface"' in text, surface != "ShaderNodeBsdfGlass")
            self.assertEqual(self.warnings, [])
            bpy.data.objects.remove(bpy.context.object)
            bpy.data.materials.remove(bpy.data.materials["Full"])

    def test_volumes_emit(self):
        # Black absorbs 1 per unit: as bright where it is thick as it emits per unit.
        self.full_cube("ShaderNodeVolumePrincipled", Color=(0, 0, 0, 1), Density=2,
                       Emission_Color=(1, 0.5, 0, 1), Emission_Strength=4)
        text, _ = self.export()
        self.assertIn('"rgb sigma_a" [ 2 2 2 ]', text)
        self.assertIn('"rgb Le" [ 2 1 0 ]', text)
        self.assertEqual(self.warnings, [])

    def test_a_black_body_of_a_volume_is_named_once(self):
        self.full_cube("ShaderNodeVolumePrincipled", Blackbody_Intensity=1)
        bpy.ops.object.duplicate()
        self.export()
        self.assertEqual(self.warnings, ['material "Full": black body of a volume: left out'])

    def test_a_volume_of_the_world_surrounds_all(self):
        fill_world("ShaderNodeVolumeScatter", Color=(1, 0.5, 0, 1), Density=0.5)
        self.full_cube(surface="ShaderNodeBsdfGlass", Density=3)
        made, _, _ = material("Clear", "ShaderNodeBsdfGlass")
        bpy.ops.mesh.primitive_cube_add(location=(5, 0, 0))
        bpy.context.object.data.materials.append(made)
        text, _ = self.export()
        self.assertIn('"rgb sigma_s" [ 0.5 0.25 0 ]', text)
        first = text.index('MediumInterface "air of World" "air of World"')
        self.assertLess(first, text.index("Camera "))
        self.assertIn('MediumInterface "inside Full of Cube" "air of World"', text)
        self.assertIn('MediumInterface "" "air of World"', text)

    def test_light_from_infinitely_far_does_not_get_through_the_air(self):
        fill_world("ShaderNodeVolumeScatter", strength=1)
        sun = bpy.data.lights.new("Sun", "SUN")
        bpy.context.scene.collection.objects.link(bpy.data.objects.new("Sun", sun))
        text, _ = self.export()
        self.assertNotIn("LightSource", text)
        self.assertEqual(len([w for w in self.warnings if "infinitely far" in w]), 2)

    def test_glasses_and_metals_by_name_have_their_indices(self):
        for name, kind in (("diamond", "Glass"), ("glass-BK7", "Glass"), ("metal-Au", "Glossy")):
            made, _, _ = material(name, f"ShaderNodeBsdf{kind}")
            made.sunfleck.named = name
            self.plane(made)
        text, _ = self.export()
        self.assertIn('"spectrum eta" [ "glass-BK7" ]', text)
        self.assertIn('"spectrum k" [ "metal-Au-k" ]', text)
        index = float(re.search(r'"spectrum eta" \[ 360 .* 590 (\S+) 600', text)[1])
        self.assertAlmostEqual(index, 2.417, delta=2e-3)

    def test_nodes_of_lights_multiply_their_colour(self):
        lamp = bpy.data.lights.new("Lamp", "POINT")
        lamp.energy, lamp.shadow_soft_size, lamp.use_nodes = 4 * math.pi, 0, True
        emission = next(n for n in lamp.node_tree.nodes if n.type == "EMISSION")
        np.testing.assert_allclose(self.intensity(lamp), 1, rtol=1e-6)
        emission.inputs["Strength"].default_value = 3
        black_body = lamp.node_tree.nodes.new("ShaderNodeBlackbody")
        black_body.inputs[0].default_value = 2700
        lamp.node_tree.links.new(black_body.outputs[0], emission.inputs["Color"])
        red, green, blue = self.intensity(lamp)
        self.assertTrue(red > 3 > blue, (red, green, blue))
        self.assertEqual(self.warnings, [])

    def intensity(self, lamp):
        """Exports a scene with this lamp alone, and returns its intensity."""
        for thing in [o for o in bpy.context.scene.objects if o.type == "LIGHT"]:
            bpy.data.objects.remove(thing)
        bpy.context.scene.collection.objects.link(bpy.data.objects.new("Lamp", lamp))
        text, _ = self.export()
        found = re.search(r'"rgb I" \[ (\S+) (\S+) (\S+) \]', text)
        return [float(value) for value in found.groups()]

    def test_every_shader_of_the_table_is_read(self):
        for kind in ("Principled", "Diffuse", "Glossy", "Anisotropic", "Glass", "Refraction",
                     "Translucent", "Transparent", "Velvet", "Toon"):
            made, _, _ = material(kind, f"ShaderNodeBsdf{kind}")
            self.plane(made)
        self.export()
        self.assertFalse([w for w in self.warnings if "not known" in w], self.warnings)


class Renders(Case):
    def sunlit_plane(self):
        made, _, _ = material("White", Color=(0.8, 0.8, 0.8, 1))
        bpy.ops.mesh.primitive_plane_add(size=40)
        bpy.context.object.data.materials.append(made)
        sun = bpy.data.lights.new("Sun", "SUN")
        sun.energy, sun.angle = 2, 0
        bpy.context.scene.collection.objects.link(bpy.data.objects.new("Sun", sun))

    def test_a_plane_under_a_sun_is_as_bright_as_computed(self):
        self.sunlit_plane()
        pixels = self.render(2)
        np.testing.assert_allclose(pixels[..., :3], 2 * 0.8 / math.pi, rtol=0.01)
        np.testing.assert_array_equal(pixels[..., 3], 1)

    def test_what_scatters_all_is_unseen_where_light_is_even(self):
        fill_world(strength=1)
        Materials.full_cube(self, Color=(1, 1, 1, 1), Density=1.5, Anisotropy=0.3)
        bpy.context.object.scale = (2, 2, 2)
        pixels = self.render(32)
        np.testing.assert_allclose(pixels[8:16, 12:20, :3].mean(), 1, atol=0.03)

    def test_the_air_of_the_world_absorbs_on_the_way_to_the_camera(self):
        fill_world("ShaderNodeVolumeAbsorption", Color=(0, 0, 0, 1), Density=0.1)
        made, _, _ = material("Lamp", "ShaderNodeEmission", Strength=2)
        bpy.ops.mesh.primitive_plane_add(size=40)
        bpy.context.object.data.materials.append(made)
        pixels = self.render(4)
        # The camera is 10 above the plane.
        np.testing.assert_allclose(pixels[11:13, 15:17, :3], 2 * math.exp(-1), rtol=0.01)

    def test_a_region_is_rendered_alone(self):
        self.sunlit_plane()
        render = bpy.context.scene.render
        render.use_border = render.use_crop_to_border = True
        render.border_min_x, render.border_max_x = 0.25, 0.75
        render.border_min_y, render.border_max_y = 0.5, 1
        self.assertEqual(self.render(1).shape[:2], (12, 16))

    def test_frames_view_layers_and_light_groups_are_rendered(self):
        self.sunlit_plane()
        scene = bpy.context.scene
        lamp = bpy.data.lights.new("Lamp", "POINT")
        lamp.energy = 500
        thing = bpy.data.objects.new("Lämp 1", lamp)
        thing.location.z = 3
        scene.collection.objects.link(thing)
        thing.keyframe_insert("location", frame=1)
        thing.location.z = 6
        thing.keyframe_insert("location", frame=2)
        scene.view_layers.new("Second")
        scene.frame_end = 2
        scene.sunfleck.light_groups, scene.sunfleck.passes = "EACH", 1
        scene.sunfleck.time, scene.sunfleck.folder = 0, os.path.join(self.folder, "kept")
        scene.render.image_settings.file_format = "OPEN_EXR_MULTILAYER"
        scene.render.filepath = os.path.join(self.folder, "frame-")
        os.environ["PATH"], old = os.path.dirname(PROGRAM) + os.pathsep + os.environ["PATH"], \
            os.environ["PATH"]
        try:
            bpy.ops.render.render(animation=True)
        finally:
            os.environ["PATH"] = old
        contents = []
        for frame in (1, 2):
            with open(os.path.join(self.folder, f"frame-{frame:04d}.exr"), "rb") as file:
                contents.append(file.read())
            for channel in ("ViewLayer.Sun.R", "ViewLayer.L_mp_1.R", "Second.Combined.R"):
                self.assertIn(channel.encode(), contents[-1])
        self.assertNotEqual(*contents)
        kept = os.path.join(self.folder, "kept", "frame-0001")
        parts = picture_files.read_exr(os.path.join(kept, "result.exr"))
        np.testing.assert_allclose(parts["Sun.R"] + parts["L_mp_1.R"], parts["R"], rtol=1e-3)

    def test_a_scene_without_a_camera_is_told(self):
        bpy.context.scene.camera = None
        with self.assertRaisesRegex(SceneFault, "no camera"):
            export_scene(bpy.context.evaluated_depsgraph_get(), self.folder, image_path, 64,
                         self.warnings.append)

    def test_numbers_that_are_none_are_told_by_name(self):
        made, _, _ = material("Broken", "ShaderNodeEmission", Strength=float("nan"))
        bpy.ops.mesh.primitive_plane_add()
        bpy.context.object.data.materials.append(made)
        with self.assertRaisesRegex(SceneFault, "Plane: AreaLightSource"):
            self.export()

    def test_faults_of_the_program_are_told_by_object(self):
        self.sunlit_plane()
        fake = os.path.join(self.folder, "sunfleck")
        with open(fake, "w", encoding="utf-8") as script:
            script.write('#!/bin/sh\nline=$(grep -n plymesh "$2" | cut -d: -f1)\n'
                         'echo "$2:$line:3: the mesh is odd; mend it" >&2\nexit 2\n')
        os.chmod(fake, 0o755)
        old = os.environ["PATH"]
        os.environ["PATH"] = self.folder + os.pathsep + old
        try:
            with self.assertRaisesRegex(RuntimeError, "object Plane: the mesh is odd; mend it"):
                bpy.ops.render.render()
        finally:
            os.environ["PATH"] = old

    def test_a_program_that_is_missing_is_told(self):
        with self.assertRaisesRegex(RuntimeError, "Preferences"):
            old = os.environ["PATH"]
            os.environ["PATH"] = ""
            try:
                bpy.ops.render.render()
            finally:
                os.environ["PATH"] = old

    def test_an_interrupted_program_keeps_its_picture(self):
        self.sunlit_plane()
        bpy.context.scene.render.resolution_x = 640
        self.export()
        running = program.Render(PROGRAM, os.path.join(self.folder, "scene.pbrt"),
                                 ["--time", "600s"], self.folder)
        try:
            end = time.monotonic() + 120
            while running.newest_snapshot() is None and time.monotonic() < end:
                time.sleep(0.05)
            running.interrupt()
            while running.is_running() and time.monotonic() < end:
                time.sleep(0.05)
            self.assertEqual(running.exit_code(), 130, running.said())
            self.assertTrue(os.path.isfile(running.output))
        finally:
            running.kill()


if __name__ == "__main__":
    result = unittest.main(argv=["test_in_blender"], exit=False).result
    sys.exit(0 if result.wasSuccessful() else 1)
