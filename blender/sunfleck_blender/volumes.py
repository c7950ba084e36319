"""Reads what a volume absorbs from its nodes: Volume Absorption, and what of others we have."""

import numpy as np

from .sockets import socket, source
from .values import number

NONE = np.zeros(3)


def absorption(reader, found, groups=()):
    """Returns what is absorbed per unit of length (three numbers) by a Volume input's nodes."""
    origin = source(found, groups) if found is not None else None
    if origin is None or origin[0].type == "UNLINKED":
        return NONE
    node, _, groups = origin
    if node.type == "VOLUME_ABSORPTION":
        colour = np.clip(_mean(reader, node, "colour", groups), 0, 1)
        return (1 - colour) * max(number(reader.value(node, "density", groups)), 0)
    if node.type == "PRINCIPLED_VOLUME":
        reader.missing("a volume scatters: what it absorbs is rendered, scattering is not yet")
        colour = np.clip(_mean(reader, node, "Color", groups), 0, 1)
        tint = np.clip(_mean(reader, node, "Absorption Color", groups), 0, 1)
        density = max(number(reader.value(node, "density", groups)), 0)
        # Cycles: what is not scattered, less where the square root of the tint is high.
        return np.maximum(1 - colour, 0) * np.maximum(1 - np.sqrt(tint), 0) * density
    if node.type == "ADD_SHADER":
        return (absorption(reader, node.inputs[0], groups)
                + absorption(reader, node.inputs[1], groups))
    if node.type == "MIX_SHADER":
        share = min(max(number(reader.textures.value(node.inputs[0], groups)), 0), 1)
        return ((1 - share) * absorption(reader, node.inputs[1], groups)
                + share * absorption(reader, node.inputs[2], groups))
    reader.missing(f'volume node "{node.bl_label}": left out, media that scatter are not'
                   " simulated yet")
    return NONE


def _mean(reader, node, name, groups):
    found = socket(node, name)
    if found is None:
        return NONE
    return reader.textures.value(found, groups).mean()


def absorption_of_tint(tint, chord):
    """Returns what glass absorbs per unit, so that a way of mean length through it leaves tint^2.

    Cycles tints light at each crossing: twice on a way through.
    """
    if chord <= 0:
        return NONE
    return -2 * np.log(np.clip(tint.mean(), 1e-4, 1)) / chord
