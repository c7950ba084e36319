"""Reads what bends a surface's normals: Normal Map, Bump and Displacement nodes."""

import numpy as np

from .sockets import socket, source
from .values import Flat, Picture, combine, scaled


def bend_of(reader, found, groups):
    """Returns ("normalmap" or "displacement", value) of what is linked to a Normal, or None."""
    origin = source(found, groups) if found is not None else None
    if origin is None or origin[0].type == "UNLINKED":
        return None
    node, _, groups = origin
    if node.type == "NORMAL_MAP":
        return _normal_map(reader, node, groups)
    if node.type == "BUMP":
        return _bump(reader, node, groups)
    reader.missing(f'normals by "{node.bl_label}": those of the surface are used')
    return None


def _normal_map(reader, node, groups):
    if node.space != "TANGENT":
        reader.missing(f"a normal map in {node.space.lower()} space: left out")
        return None
    value = reader.value(node, "colour", groups)
    if not isinstance(value, Picture):
        if not isinstance(value, Flat):
            reader.missing("a normal map that is no picture: left out")
        return None
    strength = reader.number(node, "strength", groups)
    if strength != 1:
        value = combine(lambda c: weakened(c, strength), [value])
    return "normalmap", value


def weakened(colour, strength):
    """Returns the texels of a normal map whose slopes are `strength` times as steep."""
    normal = colour * 2 - 1
    normal = np.concatenate([normal[..., :2] * strength,
                             1 + (normal[..., 2:] - 1) * min(strength, 1)], axis=-1)
    length = np.linalg.norm(normal, axis=-1, keepdims=True)
    return (normal / np.where(length > 0, length, 1) + 1) / 2


def _bump(reader, node, groups):
    if node.inputs["Normal"].is_linked:
        reader.missing("a normal map under a bump: the bump alone is used")
    height = reader.value(node, "Height", groups)
    if isinstance(height, Flat):
        return None
    factor = reader.number(node, "strength", groups) * reader.number(node, "Distance", groups)
    return "displacement", scaled(height, -factor if node.invert else factor)


def displacement(reader, found):
    """Returns the bend of the material's Displacement, or None."""
    origin = source(found) if found is not None else None
    if origin is None or origin[0].type == "UNLINKED":
        return None
    node, _, groups = origin
    if node.type != "DISPLACEMENT":
        reader.missing(f'displacement by "{node.bl_label}": left out')
        return None
    height = reader.value(node, "Height", groups)
    if isinstance(height, Flat):
        return None
    reader.missing("displacement bends normals; the shape itself stays")
    return "displacement", scaled(height, reader.number(node, "Scale", groups))
