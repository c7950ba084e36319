"""Meshes and materials that the example scenes share; runs inside Blender."""

import math

import bpy
import numpy as np


def new_scene(width=320, height=180):
    """Empties Blender and returns the scene."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = width, height
    scene.view_settings.view_transform = "Standard"
    return scene


def material(name, kind, volume=None, **inputs):
    """Returns a material of one shader node; volume: (colour, density) of what it absorbs."""
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    tree = made.node_tree
    tree.nodes.clear()
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    shader = tree.nodes.new(kind)
    for key, value in inputs.items():
        shader.inputs[key.replace("_", " ")].default_value = value
    tree.links.new(shader.outputs[0], output.inputs["Surface"])
    if volume:
        absorbing = tree.nodes.new("ShaderNodeVolumeAbsorption")
        absorbing.inputs["Color"].default_value = (*volume[0], 1)
        absorbing.inputs["Density"].default_value = volume[1]
        tree.links.new(absorbing.outputs[0], output.inputs["Volume"])
    return made


def diffuse(name, *colour):
    return material(name, "ShaderNodeBsdfDiffuse", Color=(*colour, 1))


def glass(name, ior=1.5, volume=None):
    """Returns smooth glass."""
    return material(name, "ShaderNodeBsdfPrincipled", volume, Base_Color=(1, 1, 1, 1),
                    Transmission=1.0, Roughness=0.0, IOR=ior)


def placed(name, data, made=None, location=(0, 0, 0), rotation=(0, 0, 0)):
    """Puts data into the scene as an object, and returns it."""
    thing = bpy.data.objects.new(name, data)
    thing.location, thing.rotation_euler = location, rotation
    if made is not None:
        data.materials.append(made)
    bpy.context.scene.collection.objects.link(thing)
    return thing


def mesh(name, vertices, faces, smooth=False):
    data = bpy.data.meshes.new(name)
    data.from_pydata(vertices, [], faces)
    data.polygons.foreach_set("use_smooth", [smooth] * len(faces))
    data.update()
    return data


def lathe(name, profile, steps=96, smooth=True):
    """Returns a closed mesh: (radius, height) pairs turned around z, from the axis to the axis."""
    vertices, rings = [], []
    for radius, height in profile:
        if radius == 0:
            rings.append([len(vertices)] * steps)
            vertices.append((0, 0, height))
            continue
        rings.append(list(range(len(vertices), len(vertices) + steps)))
        vertices += [(radius * math.cos(2 * math.pi * i / steps),
                      radius * math.sin(2 * math.pi * i / steps), height) for i in range(steps)]
    faces = []
    for low, high in zip(rings, rings[1:]):
        for i in range(steps):
            j = (i + 1) % steps
            corners = [low[i], low[j], high[j], high[i]]
            face = list(dict.fromkeys(corners))
            if len(face) > 2:
                faces.append(face)
    return mesh(name, vertices, faces, smooth)


def curve(points, steps=8):
    """Returns points of a smooth curve (Catmull-Rom) through (radius, height) pairs."""
    p = np.array([points[0], *points, points[-1]], float)
    result = []
    for a, b, c, d in zip(p, p[1:], p[2:], p[3:]):
        for t in np.arange(steps) / steps:
            result.append(0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t
                                 + (3 * b - a - 3 * c + d) * t ** 3))
    result.append(p[-1])
    return [(max(float(r), 0.0), float(h)) for r, h in result]


def box(name, low, high):
    """Returns a closed box whose faces look outwards."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    vertices = [(x, y, z) for z in (z0, z1) for y in (y0, y1) for x in (x0, x1)]
    return mesh(name, vertices, [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3),
                                 (0, 4, 6, 2), (1, 3, 7, 5)])


def plane(name, x, y, z=0.0):
    """Returns a rectangle that looks up, with a UV map."""
    data = mesh(name, [(-x, -y, z), (x, -y, z), (x, y, z), (-x, y, z)], [(0, 1, 2, 3)])
    layer = data.uv_layers.new(name="UVMap")
    for place, uv in zip(layer.data, ((0, 0), (1, 0), (1, 1), (0, 1))):
        place.uv = uv
    return data


def camera(location, target, lens=50.0):
    data = bpy.data.cameras.new("Camera")
    data.lens = lens
    thing = placed("Camera", data, location=location)
    thing.rotation_euler = looking(location, target)
    bpy.context.scene.camera = thing
    return thing


def looking(location, target):
    """Returns the rotation of a camera or light that looks from one point to another."""
    from mathutils import Vector
    return (Vector(target) - Vector(location)).to_track_quat("-Z", "Y").to_euler()


def light(kind, location, target, energy, **settings):
    data = bpy.data.lights.new(kind.title(), kind)
    data.energy = energy
    for key, value in settings.items():
        setattr(data, key, value)
    return placed(kind.title(), data, location=location, rotation=looking(location, target))


def world(*colour):
    made = bpy.data.worlds.new("World")
    made.use_nodes = True
    made.node_tree.nodes["Background"].inputs["Color"].default_value = (*colour, 1)
    bpy.context.scene.world = made


def checked_image(size=256, cells=8):
    """Returns an image of a checked cloth with a woven grain, packed into the file."""
    rng = np.random.default_rng(1)
    rows, columns = np.indices((size, size))
    odd = (rows * cells // size + columns * cells // size) % 2
    colour = np.where(odd[..., None], (0.85, 0.82, 0.75), (0.35, 0.45, 0.6))
    colour = np.clip(colour + rng.normal(0, 0.03, (size, size, 1)), 0, 1)
    image = bpy.data.images.new("cloth", size, size)
    pixels = np.ones((size, size, 4), np.float32)
    pixels[..., :3] = colour
    image.pixels.foreach_set(pixels.ravel())
    image.pack()
    return image


def textured(name, image):
    """Returns a diffuse material with an image by the UV map."""
    made = diffuse(name, 1, 1, 1)
    tree = made.node_tree
    node = tree.nodes.new("ShaderNodeTexImage")
    node.image = image
    shader = next(n for n in tree.nodes if n.type == "BSDF_DIFFUSE")
    tree.links.new(node.outputs["Color"], shader.inputs["Color"])
    return made


def only_principled():
    """Makes diffuse shaders Principled without highlight: the exporter of glTF knows no others.

    Cycles' Principled is no Lambertian, so pictures are compared before.
    """
    for made in bpy.data.materials:
        tree = made.node_tree
        for old in [n for n in tree.nodes if n.type == "BSDF_DIFFUSE"]:
            new = tree.nodes.new("ShaderNodeBsdfPrincipled")
            new.inputs["Specular"].default_value, new.inputs["Roughness"].default_value = 0, 0.5
            new.inputs["Base Color"].default_value = old.inputs["Color"].default_value
            for link in old.inputs["Color"].links:
                tree.links.new(link.from_socket, new.inputs["Base Color"])
            for link in old.outputs[0].links:
                tree.links.new(new.outputs[0], link.to_socket)
            tree.nodes.remove(old)
