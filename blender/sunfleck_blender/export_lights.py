"""Writes Blender's lights as lights and emitting shapes of the scene language."""

import math

import numpy as np

from . import picture_files, units
from .matrices import turn_of
from .scene_text import columns
from .sockets import source
from .textures import TextureReader
from .values import is_flat, number

SPOT_TEXELS = 256


def write_light(text, images, name, light, matrix, seen, warn):
    """Writes one light.

    images: image_files.ImageFiles. matrix: its place. seen: whether lights of some size are objects
    that camera and mirrors see.
    """
    def missing(what):
        warn(f'light "{name}": {what}')
    colour = np.maximum(np.array(light.color[:3]) * nodes_colour(light, images, missing), 0)
    if light.energy <= 0 or not colour.any():
        if light.energy < 0:
            missing("negative power: left out")
        return
    text.about(f"light {name}")
    text.begin()
    writer = {"POINT": _point, "SUN": _sun, "SPOT": _spot, "AREA": _area}[light.type]
    writer(text, images.folder, name, light, matrix, colour, seen, missing)
    text.end()


def nodes_colour(light, images, missing):
    """Returns by what a light's nodes multiply its colour: the mean of its Emission node."""
    if not light.use_nodes or light.node_tree is None:
        return np.ones(3)
    output = next((n for n in light.node_tree.nodes if n.type == "OUTPUT_LIGHT"), None)
    origin = output and source(output.inputs["Surface"])
    if not origin:
        return np.zeros(3)
    node, _, groups = origin
    if node.type != "EMISSION":
        missing(f'node "{node.bl_label}" of a light: left out')
        return np.ones(3)
    reader = TextureReader(images, missing)
    colour, strength = (reader.input(node, name, groups) for name in ("colour", "strength"))
    if not (is_flat(colour) and is_flat(strength)):
        missing("textures of a light: their means count")
    return colour.mean() * number(strength)


def _point(text, folder, name, light, matrix, colour, seen, missing):
    position = matrix[:3, 3]
    radius = light.shadow_soft_size
    if radius <= 0:
        text.light(name, "LightSource", "point",
                   {"rgb I": colour * units.point_intensity(light.energy),
                    "point3 from": position})
        return
    text.light(name, "AreaLightSource", "diffuse",
               {"rgb L": colour * units.sphere_radiance(light.energy, radius)})
    text.say("Translate", rest=" ".join(f"{v:.9g}" for v in position))
    _shape(text, "sphere", {"float radius": radius}, seen)


def _shape(text, kind, parameters, seen):
    """Writes a black shape that emits."""
    text.say("Material", "diffuse", {"rgb reflectance": (0, 0, 0)})
    text.say("Shape", kind, parameters | ({} if seen else {"float alpha": 0}))


def _sun(text, folder, name, light, matrix, colour, seen, missing):
    write_sun(text, name, -turn_of(matrix)[:, 2], colour * light.energy, light.angle)


def write_sun(text, name, direction, irradiance, angle):
    """Writes a sun. direction: in which its light travels; irradiance: of a plane that faces it."""
    place = {"rgb L": irradiance, "point3 from": -direction, "point3 to": (0, 0, 0)}
    if angle > 0:
        text.light(name, "LightSource", "sun", place | {"float angle": math.degrees(angle)})
    else:
        text.light(name, "LightSource", "distant", place)


def spot_picture(half_angle, blend, texels):
    """Returns (H x W falloff, its extent): intensities of a spot through a plane at distance 1."""
    extent = math.tan(half_angle)
    grid = ((np.arange(texels) + 0.5) / texels * 2 - 1) * extent
    x, y = np.meshgrid(grid, grid)
    cosine = 1 / np.sqrt(1 + x * x + y * y)
    falloff = np.vectorize(units.spot_falloff)(cosine, math.cos(half_angle), blend)
    return falloff, extent


def _spot(text, folder, name, light, matrix, colour, seen, missing):
    if light.shadow_soft_size > 0:
        missing("a spot's radius: it shines from a point, with sharp shadows")
    if light.use_square:
        missing("a square spot: a round one is used")
    half = min(light.spot_size / 2, math.radians(89))
    intensity = colour * units.point_intensity(light.energy)
    texels = SPOT_TEXELS
    if half > math.radians(75):
        # A plane is no place for so wide a cone; its cosine is left out.
        missing("so wide a spot does not fall off with the cosine, as in Cycles")
        inner = math.acos(min(1, math.cos(half) + (1 - math.cos(half)) * light.spot_blend))
        way = matrix[:3, 3] - turn_of(matrix)[:, 2]
        text.light(name, "LightSource", "spot", {
            "rgb I": intensity, "point3 from": matrix[:3, 3], "point3 to": way,
            "float coneangle": math.degrees(half),
            "float conedeltaangle": math.degrees(half - inner)})
        return
    falloff, _ = spot_picture(half, light.spot_blend, texels)
    file = f"spot-{len(text.lights):03d}.pfm"
    picture_files.write_pfm(f"{folder}/{file}", falloff[..., None] * intensity)
    place = np.eye(4)
    place[:3, :3] = turn_of(matrix) @ np.diag([1.0, 1.0, -1.0])
    place[:3, 3] = matrix[:3, 3]
    text.say("ConcatTransform", rest=columns(place))
    text.light(name, "LightSource", "projection",
               {"string filename": file, "float fov": math.degrees(2 * half)})


def ellipse(width, height, corners=64):
    """Returns (positions, faces) of a flat ellipse that faces -z, of exactly its area."""
    angles = np.arange(corners) * (2 * math.pi / corners)
    # The polygon is a little larger than the ellipse, so that both have one area.
    grow = math.sqrt(2 * math.pi / corners / math.sin(2 * math.pi / corners))
    rim = np.stack([np.cos(angles) * width / 2 * grow, np.sin(angles) * height / 2 * grow,
                    np.zeros(corners)], axis=1)
    faces = [(0, i + 1, i) for i in range(1, corners - 1)]
    return rim, np.array(faces)


def _area(text, folder, name, light, matrix, colour, seen, missing):
    width = light.size
    height = light.size_y if light.shape in ("RECTANGLE", "ELLIPSE") else width
    if width <= 0 or height <= 0:
        missing("an area light without area: left out")
        return
    if getattr(light, "spread", math.pi) < math.pi - 1e-3:
        missing("an area light's spread: it shines over the whole half of space")
    if light.shape in ("DISK", "ELLIPSE"):
        positions, faces = ellipse(width, height)
    else:
        x, y = width / 2, height / 2
        positions = np.array([(-x, -y, 0), (-x, y, 0), (x, y, 0), (x, -y, 0)])
        faces = np.array([(0, 1, 2), (0, 2, 3)])
    # Blender keeps the power when an object is scaled: the area is that of the scaled shape.
    placed = positions @ matrix[:3, :3].T
    area = 0.5 * np.linalg.norm(np.cross(placed[faces[:, 1]] - placed[faces[:, 0]],
                                         placed[faces[:, 2]] - placed[faces[:, 0]]), axis=1).sum()
    radiance = colour * units.area_radiance(light.energy, area)
    if np.linalg.det(matrix[:3, :3]) < 0:
        faces = faces[:, ::-1]
    text.light(name, "AreaLightSource", "diffuse", {"rgb L": radiance})
    world = placed + matrix[:3, 3]
    _shape(text, "trianglemesh", {"point3 P": world.ravel(), "integer indices": faces.ravel()},
           seen)
