"""Translates the colour, number and texture nodes that lead to a socket into a value."""

import numpy as np

from . import colour_nodes, mappings
from .sockets import enabled, is_colour, socket, source
from .values import Checks, combine, flat, grey, is_flat, mixed, number

MAGENTA = flat(1, 0, 1)  # Blender's colour of an image that is missing


class TextureReader:
    """Reads values of sockets for one material.

    images: image_files.ImageFiles. missing: called with a text for what is lost.
    """

    def __init__(self, images, missing):
        self.images = images
        self.missing = missing

    def value(self, found, groups=()):
        """Returns what a socket is worth: its own value or what is linked to it."""
        if found is None:
            return flat(0)
        origin = source(found, groups)
        if origin is None:
            return own_value(found)
        node, output, groups = origin
        if node.type == "UNLINKED":
            result = own_value(output)
        else:
            reader = READERS.get(node.type)
            if reader is None:
                self.missing(f'node "{node.bl_label}" is not known: its mean counts')
                return flat(0.5)
            result = reader(self, node, output, groups)
        if is_colour(found) or is_flat(result):
            return result if is_colour(found) else grey(result)
        return grey(result)

    def input(self, node, name, groups):
        """Returns the value of a node's input by our name of it."""
        return self.value(socket(node, name), groups)


def own_value(found):
    """Returns the value that a socket holds itself."""
    held = getattr(found, "default_value", 0.0)
    return flat(held) if isinstance(held, (int, float)) else flat(*list(held)[:3])


def _rgb(reader, node, output, groups):
    return own_value(node.outputs[0])


def _image(reader, node, output, groups):
    if node.image is None:
        reader.missing(f'node "{node.name}" has no image: magenta counts, as in Blender')
        return MAGENTA
    if node.projection != "FLAT":
        reader.missing(f'projection "{node.projection.lower()}" of an image: flat is used')
    wrap = {"REPEAT": "repeat", "EXTEND": "clamp", "CLIP": "black"}.get(node.extension)
    if wrap is None:
        reader.missing(f'extension "{node.extension.lower()}" of an image: repeat is used')
        wrap = "repeat"
    where = mappings.coordinates(reader, socket(node, "Vector"), groups, "uv")
    if where.kind != "uv":
        reader.missing(f'an image by {where.kind} coordinates: UV is used')
        where = mappings.Coordinates()
    filtered = "point" if node.interpolation == "Closest" else "bilinear"
    picture = reader.images.picture(node.image, output.name == "Alpha", where, wrap, filtered,
                                    reader.missing)
    return picture or MAGENTA


def _checker(reader, node, output, groups):
    where = mappings.coordinates(reader, socket(node, "Vector"), groups, "generated")
    scale = number(reader.input(node, "Scale", groups))
    where = where.then(np.diag([scale, scale, scale, 1.0]))
    if output.name == "Fac":
        return Checks(flat(0), flat(1), where)
    # On a plane Blender has the first colour where one of the two cells is odd.
    first = reader.input(node, "Color1", groups)
    second = reader.input(node, "Color2", groups)
    return Checks(second, first, where)


def _mix(reader, node, output, groups):
    if node.type == "MIX" and node.data_type != "RGBA":
        parts = [enabled(node, name) for name in ("Factor", "A", "B")]
        blend, clamp = "MIX", False
    elif node.type == "MIX":
        parts = [enabled(node, name) for name in ("Factor", "A", "B")]
        blend, clamp = node.blend_type, node.clamp_result
    else:
        parts = [node.inputs[0], node.inputs[1], node.inputs[2]]
        blend, clamp = node.blend_type, node.use_clamp
    amount, a, b = (reader.value(part, groups) for part in parts)
    amount = combine(colour_nodes.clamped, [amount])
    function = colour_nodes.BLENDS.get(blend)
    if function is None:
        reader.missing(f'blending "{blend.lower()}": mix is used')
        function = colour_nodes.BLENDS["MIX"]
    if blend != "MIX":
        b = combine(function, [a, b], reader.missing)
    result = mixed(amount, a, b, reader.missing)
    return combine(colour_nodes.clamped, [result]) if clamp else result


def _math(reader, node, output, groups):
    function = colour_nodes.MATH.get(node.operation)
    if function is None:
        reader.missing(f'math "{node.operation.lower()}": its first input is used')
        return reader.value(node.inputs[0], groups)
    values = [reader.value(s, groups) for s in list(node.inputs)[:3]]
    values += [flat(0)] * (3 - len(values))
    result = combine(function, values, reader.missing)
    return combine(colour_nodes.clamped, [result]) if node.use_clamp else result


def _invert(reader, node, output, groups):
    colour = reader.input(node, "colour", groups)
    inverse = combine(lambda c: 1 - c, [colour])
    return mixed(reader.input(node, "factor", groups), colour, inverse, reader.missing)


def _function(function, *names):
    """Returns a reader that applies a function to the inputs of these names."""
    def read(reader, node, output, groups):
        values = [reader.input(node, name, groups) for name in names]
        return combine(function, values, reader.missing)
    return read


def _ramp(reader, node, output, groups):
    samples = np.array([node.color_ramp.evaluate(t) for t in np.linspace(0, 1, 1025)])
    chosen = np.repeat(samples[:, 3:], 3, axis=1) if output.name == "Alpha" else samples[:, :3]
    return combine(colour_nodes.table(chosen), [reader.input(node, "factor", groups)])


def _curves(reader, node, output, groups):
    mapping = node.mapping
    mapping.initialize()
    places = np.linspace(0, 1, 257)
    whole = [mapping.evaluate(mapping.curves[3], t) for t in places]
    samples = np.array([[mapping.evaluate(mapping.curves[c], w) for c in range(3)] for w in whole])
    colour = reader.input(node, "colour", groups)
    result = combine(colour_nodes.curves(samples), [colour])
    return mixed(reader.input(node, "factor", groups), colour, result, reader.missing)


def _separate(reader, node, output, groups):
    if getattr(node, "mode", "RGB") != "RGB":
        reader.missing(f'separating by "{node.mode}": RGB is used')
    which = max(0, list(node.outputs).index(output))
    return combine(lambda c: np.repeat(c[..., which:which + 1], 3, axis=-1),
                   [reader.value(node.inputs[0], groups)])


def _combine(reader, node, output, groups):
    parts = [reader.value(s, groups) for s in list(node.inputs)[:3]]
    return combine(lambda *p: np.stack(np.broadcast_arrays(*[c[..., 0] for c in p]), axis=-1),
                   parts, reader.missing)


def _clamp(reader, node, output, groups):
    values = [reader.value(s, groups) for s in list(node.inputs)[:3]]
    return combine(lambda v, low, high: np.minimum(np.maximum(v, low), high), values,
                   reader.missing)


def _range(reader, node, output, groups):
    values = [reader.value(s, groups) for s in list(node.inputs)[:5]]
    result = combine(colour_nodes.map_range, values, reader.missing)
    if node.clamp:
        result = combine(lambda v, a, b: np.clip(v, np.minimum(a, b), np.maximum(a, b)),
                         [result, values[3], values[4]], reader.missing)
    return result


def _black_body(reader, node, output, groups):
    return flat(*colour_nodes.black_body(number(reader.value(node.inputs[0], groups))))


def _light_path(reader, node, output, groups):
    """Light is simulated, so what is seen is what lights: rays count as the camera's."""
    return flat(1.0 if output.name == "Is Camera Ray" else 0.0)


def _facing(reader, node, output, groups):
    reader.missing(f'node "{node.bl_label}" as a number: its value at normal incidence counts')
    if node.type == "LAYER_WEIGHT" and output.name == "Facing":
        return flat(0)
    name = "ior" if node.type == "FRESNEL" else "Blend"
    given = number(reader.input(node, name, groups))
    eta = max(given, 1e-5) if name == "ior" else 1 / max(1 - given, 1e-5)
    return flat(((eta - 1) / (eta + 1)) ** 2)


READERS = {
    "RGB": _rgb, "VALUE": _rgb, "TEX_IMAGE": _image, "TEX_CHECKER": _checker,
    "MIX_RGB": _mix, "MIX": _mix, "MATH": _math, "INVERT": _invert,
    "GAMMA": _function(colour_nodes.gamma, "colour", "Gamma"),
    "BRIGHTCONTRAST": _function(colour_nodes.brightness_contrast, "colour", "Bright", "Contrast"),
    "HUE_SAT": lambda reader, node, output, groups: mixed(
        reader.input(node, "factor", groups), reader.input(node, "colour", groups),
        _function(colour_nodes.hue_saturation, "colour", "Hue", "Saturation", "Value")(
            reader, node, output, groups), reader.missing),
    "RGBTOBW": lambda reader, node, output, groups: grey(reader.input(node, "colour", groups)),
    "VALTORGB": _ramp, "CURVE_RGB": _curves, "SEPRGB": _separate, "SEPARATE_COLOR": _separate,
    "COMBRGB": _combine, "COMBINE_COLOR": _combine, "CLAMP": _clamp, "MAP_RANGE": _range,
    "BLACKBODY": _black_body, "LIGHT_PATH": _light_path, "FRESNEL": _facing,
    "LAYER_WEIGHT": _facing,
}
