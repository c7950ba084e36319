"""Reads the nodes that say where a texture lies: Texture Coordinate, UV Map and Mapping."""

import numpy as np

from .sockets import socket, source
from .values import Coordinates, is_flat

KINDS = {"UV": "uv", "Generated": "generated", "Object": "object", "Position": "world"}


def turn(angles):
    """Returns the 3 x 3 matrix of Blender's Euler angles in the order XYZ."""
    (sx, sy, sz), (cx, cy, cz) = np.sin(angles), np.cos(angles)
    x = np.array([[1, 0, 0], [0, cx, -sx], [0, sx, cx]])
    y = np.array([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]])
    z = np.array([[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]])
    return z @ y @ x


def mapping_matrix(kind, location, rotation, scale):
    """Returns the 4 x 4 matrix of a Mapping node: kind is POINT, TEXTURE or VECTOR."""
    matrix = np.eye(4)
    matrix[:3, :3] = turn(rotation) @ np.diag(scale)
    if kind == "VECTOR":
        return matrix
    if kind == "TEXTURE":
        safe = np.where(np.asarray(scale) == 0, 1, scale)
        matrix[:3, :3] = np.diag(1 / safe) @ turn(rotation).T
        matrix[:3, 3] = -matrix[:3, :3] @ np.asarray(location)
        return matrix
    matrix[:3, 3] = location
    return matrix


def coordinates(reader, vector, groups, unlinked):
    """Returns the Coordinates that lead to a texture's Vector; unlinked: their kind without."""
    origin = source(vector, groups) if vector is not None else None
    if origin is None:
        return Coordinates(unlinked)
    node, output, groups = origin
    if node.type == "MAPPING":
        before = coordinates(reader, socket(node, "Vector"), groups, unlinked)
        names = ("Location", "Rotation", "Scale")
        values = [reader.value(socket(node, name), groups) if socket(node, name) is not None
                  else None for name in names]
        if any(value is not None and not is_flat(value) for value in values):
            reader.missing("a Mapping node with textures in it: their means count")
        numbers = [np.zeros(3) if value is None else value.mean() for value in values]
        if node.vector_type == "NORMAL":
            reader.missing("a Mapping node of normals: points are mapped")
        return before.then(mapping_matrix(node.vector_type, *numbers))
    if node.type == "UVMAP":
        return Coordinates("uv", node.uv_map)
    if node.type == "TEX_COORD" and output.name in KINDS:
        if node.object is not None:
            reader.missing("coordinates of another object: those of the object itself are used")
        return Coordinates(KINDS[output.name])
    if node.type == "NEW_GEOMETRY" and output.name == "Position":
        return Coordinates("world")
    name = f'{node.bl_label}: {output.name}' if node.type != "UNLINKED" else node.name
    reader.missing(f'coordinates by "{name}": {unlinked} coordinates are used')
    return Coordinates(unlinked)
