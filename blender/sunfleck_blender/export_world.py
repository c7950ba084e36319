"""Writes Blender's world: a medium, and an infinite light of a colour or a picture."""

import numpy as np

from . import picture_files, skies, sky_maps
from .mappings import coordinates
from .scene_text import quoted
from .shaders import ShaderReader
from .sockets import socket, source
from .textures import TextureReader
from .values import Flat, combine, flat, number
from .volumes import volume_of

MAP_SIZES = (512, 1024, 2048)


def write_air(text, world, images, warn):
    """Writes the medium that fills the world, if any, around all that follows.

    Returns its name, or an empty one.
    """
    if world is None or not world.use_nodes or world.node_tree is None:
        return ""
    output = world.node_tree.get_output_node("CYCLES") or world.node_tree.get_output_node("ALL")
    if output is None:
        return ""

    def missing(what):
        warn(f'world "{world.name}": {what}')
    volume = volume_of(ShaderReader(TextureReader(images, missing), missing),
                       output.inputs["Volume"])
    if volume.is_empty():
        return ""
    name = f"air of {world.name}"
    text.about(f"world {world.name}")
    volume.write(text, name)
    text.say("MediumInterface", name, rest=quoted(name))
    return name


def write_world(text, folder, world, images, air, warn):
    """Writes the world's light, which air keeps out. images: image_files.ImageFiles."""
    if world is None:
        return

    def missing(what):
        warn(f'world "{world.name}": {what}')
    text.about(f"world {world.name}")
    if air:
        missing("its light comes from infinitely far, and does not get through its volume")
        return
    if not world.use_nodes or world.node_tree is None:
        _even(text, world.name, np.array(world.color[:3]))
        return
    output = world.node_tree.get_output_node("CYCLES") or world.node_tree.get_output_node("ALL")
    if output is None:
        return
    reader = TextureReader(images, missing)
    radiance = _radiance(reader, output.inputs["Surface"], ())
    if isinstance(radiance, Daylight):
        text.light(f"world {world.name}", "LightSource", "sky", radiance.parameters)
    elif isinstance(radiance, Flat):
        _even(text, world.name, radiance.mean())
    elif radiance is not None:
        _picture(text, folder, world.name, radiance)


class Surroundings:
    """A picture of all directions: linear pixels, and the turn from the world to the picture."""

    def __init__(self, pixels, turn):
        self.pixels = pixels
        self.turn = turn


class Daylight:
    """Sunfleck's own sky with its sun: parameters of the statement."""

    def __init__(self, parameters):
        self.parameters = parameters


def _radiance(reader, found, groups):
    """Returns a Flat, Surroundings, or None for what is linked to a world's Surface."""
    origin = source(found, groups)
    if origin is None:
        return None
    node, _, groups = origin
    if node.type in ("BACKGROUND", "EMISSION"):
        strength = number(reader.input(node, "strength", groups))
        return _scaled(_colour(reader, socket(node, "colour"), groups), strength)
    if node.type == "MIX_SHADER":
        # A switch by Light Path shows the camera one world and lights by another.
        share = number(reader.value(node.inputs[0], groups))
        if 0 < share < 1:
            reader.missing("a mix of two worlds: the greater one is used")
        return _radiance(reader, node.inputs[2 if share > 0.5 else 1], groups)
    if node.type == "ADD_SHADER":
        parts = [_radiance(reader, s, groups) for s in node.inputs[:2]]
        flats = [p for p in parts if isinstance(p, Flat)]
        maps = [p for p in parts if isinstance(p, Surroundings)]
        if any(isinstance(p, Daylight) for p in parts):
            reader.missing("a sum with a sky that has a sun: the sky alone is used")
            return next(p for p in parts if isinstance(p, Daylight))
        if len(maps) > 1:
            reader.missing("a sum of two environment pictures: the first is used")
        total = combine(lambda *c: sum(c), flats) if flats else flat(0)
        return Surroundings(maps[0].pixels + total.mean(), maps[0].turn) if maps else total
    reader.missing(f'node "{node.bl_label}" is not known: the world is black')
    return None


def _scaled(value, factor):
    if isinstance(value, Surroundings):
        return Surroundings(value.pixels * factor, value.turn)
    if isinstance(value, Daylight):
        return Daylight(value.parameters | {"float scale": factor})
    return combine(lambda c: c * factor, [value])


def _colour(reader, found, groups):
    origin = source(found, groups)
    if origin is None or origin[0].type not in ("TEX_ENVIRONMENT", "TEX_SKY", "GAMMA",
                                                "BRIGHTCONTRAST", "HUE_SAT"):
        return flat(*np.maximum(reader.value(found, groups).mean(), 0))
    node, _, groups = origin
    if node.type == "TEX_ENVIRONMENT":
        return _environment(reader, node, groups)
    if node.type == "TEX_SKY":
        return _sky(reader, node)
    reader.missing(f'node "{node.bl_label}" on a world\'s picture: left out')
    return _colour(reader, socket(node, "colour"), groups)


def _environment(reader, node, groups):
    image = node.image
    if image is None or (not image.has_data and image.size[0] == 0):
        reader.missing("the environment picture is missing: magenta is used, as in Blender")
        return flat(1, 0, 1)
    if node.projection != "EQUIRECTANGULAR":
        reader.missing("a mirror ball: it is read as latitude and longitude")
    where = coordinates(reader, socket(node, "Vector"), groups, "generated")
    matrix = np.asarray(where.matrix)[:3, :3]
    return Surroundings(reader.images.linear_pixels(image), matrix)


def _sky(reader, node):
    if node.inputs and node.inputs[0].is_linked:
        reader.missing("coordinates of a sky texture: it is not turned")
    azimuth, elevation = skies.sun_of(node)
    if node.sky_type == "NISHITA" and node.sun_disc and elevation >= 0:
        reader.missing("Nishita's sky is rendered as that of Hosek and Wilkie, with its sun of "
                       "half a degree; air, dust, ozone and the sun's size do not count")
        return Daylight({"float azimuth": azimuth, "float elevation": min(elevation, 90)})
    reader.missing("a sky texture without a sun is rendered as Preetham's, about as bright")
    turbidity = 3 if node.sky_type == "NISHITA" else node.turbidity
    sun = skies.direction_of(azimuth, max(elevation, 1))
    return Surroundings(skies.sky_panorama(node.sky_type, sun, turbidity), np.eye(3))


def _even(text, name, radiance):
    if np.any(radiance > 0):
        text.light(f"world {name}", "LightSource", "infinite", {"rgb L": np.maximum(radiance, 0)})


def _picture(text, folder, name, surroundings):
    pixels = np.maximum(np.nan_to_num(surroundings.pixels), 0)
    size = next((s for s in MAP_SIZES if s * 1.4 >= pixels.shape[0]), MAP_SIZES[-1])
    mapped = sky_maps.equal_area_map(pixels, size, surroundings.turn)
    picture_files.write_pfm(f"{folder}/world.pfm", mapped)
    text.light(f"world {name}", "LightSource", "infinite", {"string filename": "world.pfm"})
