"""Reads media from volume nodes: what they absorb, scatter and emit per unit of length."""

from dataclasses import dataclass, field

import numpy as np

from .sockets import socket, source
from .values import LUMA, is_flat, number

NONE = np.zeros(3)
MOST_BENT = 0.999
# The scene language says emission as a part of absorption. What emits and absorbs nothing, as
# Cycles allows, absorbs this: a thousandth of the light on 100 units.
LEAST_GLOWING = 1e-5


@dataclass(frozen=True)
class Volume:
    """A medium of constant density. Rows of three numbers, linear sRGB, per unit of length."""
    absorbs: np.ndarray = field(default_factory=lambda: NONE)
    scatters: np.ndarray = field(default_factory=lambda: NONE)
    bend: float = 0.0  # mean cosine of the angle by which light is bent, Blender's anisotropy
    emits: np.ndarray = field(default_factory=lambda: NONE)  # radiance

    def is_empty(self):
        return not any(np.any(part > 0) for part in (self.absorbs, self.scatters, self.emits))

    def times(self, share):
        return Volume(share * self.absorbs, share * self.scatters, self.bend, share * self.emits)

    def plus(self, other, missing):
        """Returns both at once; two phase functions become one of their mean cosine."""
        ours, theirs = self.scatters @ LUMA, other.scatters @ LUMA
        bend = self.bend if ours > 0 else other.bend
        if ours > 0 and theirs > 0 and self.bend != other.bend:
            missing("two anisotropies in one volume: their mean counts")
            bend = (ours * self.bend + theirs * other.bend) / (ours + theirs)
        return Volume(self.absorbs + other.absorbs, self.scatters + other.scatters, bend,
                      self.emits + other.emits)

    def absorbing(self, more):
        """Returns this volume absorbing more, per unit of length."""
        return Volume(self.absorbs + more, self.scatters, self.bend, self.emits)

    def write(self, text, name):
        words = {"string type": "homogeneous", "rgb sigma_a": self.absorbs,
                 "rgb sigma_s": self.scatters, "float g": self.bend}
        if np.any(self.emits > 0):
            absorbs = np.where(self.emits > 0, np.maximum(self.absorbs, LEAST_GLOWING),
                               self.absorbs)
            words["rgb sigma_a"] = absorbs
            words["rgb Le"] = self.emits / np.maximum(absorbs, LEAST_GLOWING)
        text.say("MakeNamedMedium", name, words)


EMPTY = Volume()


def volume_of(reader, found, groups=()):
    """Returns the Volume of a Volume input's nodes. reader: ShaderReader."""
    origin = source(found, groups) if found is not None else None
    if origin is None or origin[0].type == "UNLINKED":
        return EMPTY
    node, _, groups = origin
    read = READERS.get(node.type)
    if read is None:
        reader.missing(f'volume node "{node.bl_label}": left out')
        return EMPTY
    return read(reader, node, groups)


def _absorption(reader, node, groups):
    colour = np.minimum(_colour(reader, node, "colour", groups), 1)
    return Volume(absorbs=(1 - colour) * _density(reader, node, groups))


def _scatter(reader, node, groups):
    if getattr(node, "phase", "HENYEY_GREENSTEIN") != "HENYEY_GREENSTEIN":
        reader.missing("the phase function of a volume: that of Henyey and Greenstein is used")
    colour = _colour(reader, node, "colour", groups)
    return Volume(scatters=colour * _density(reader, node, groups),
                  bend=_bend(reader, node, groups))


def _principled(reader, node, groups):
    if _number(reader, node, "Blackbody Intensity", groups) > 0:
        reader.missing("black body of a volume: left out")
    emits = _colour(reader, node, "Emission Color", groups) * max(
        _number(reader, node, "Emission Strength", groups), 0)
    colour = _colour(reader, node, "colour", groups)
    tint = _colour(reader, node, "Absorption Color", groups)
    density = _density(reader, node, groups)
    # Cycles: what is not scattered, less where the square root of the tint is high.
    absorbs = np.maximum(1 - colour, 0) * np.maximum(1 - np.sqrt(tint), 0)
    return Volume(absorbs * density, colour * density, _bend(reader, node, groups), emits)


def _sum(reader, node, groups):
    first, second = (volume_of(reader, found, groups) for found in node.inputs[:2])
    return first.plus(second, reader.missing)


def _mix(reader, node, groups):
    share = min(max(number(reader.textures.value(node.inputs[0], groups)), 0), 1)
    first, second = (volume_of(reader, found, groups) for found in node.inputs[1:3])
    return first.times(1 - share).plus(second.times(share), reader.missing)


def _emission(reader, node, groups):
    return Volume(emits=_colour(reader, node, "Color", groups) *
                  max(_number(reader, node, "Strength", groups), 0))


READERS = {"VOLUME_ABSORPTION": _absorption, "VOLUME_SCATTER": _scatter,
           "PRINCIPLED_VOLUME": _principled, "ADD_SHADER": _sum, "MIX_SHADER": _mix,
           "EMISSION": _emission}


def _colour(reader, node, name, groups):
    found = socket(node, name)
    if found is None:
        return NONE
    value = reader.textures.value(found, groups)
    if not is_flat(value):
        reader.missing("texture of a volume's colour: its mean counts")
    return np.maximum(value.mean(), 0)


def _number(reader, node, name, groups):
    return reader.number(node, name, groups) if socket(node, name) is not None else 0


def _density(reader, node, groups):
    return max(reader.number(node, "density", groups), 0)


def _bend(reader, node, groups):
    return min(max(reader.number(node, "anisotropic", groups), -MOST_BENT), MOST_BENT)


def absorption_of_tint(tint, chord):
    """Returns what glass absorbs per unit, so that a way of mean length through it leaves tint^2.

    Cycles tints light at each crossing: twice on a way through.
    """
    if chord <= 0:
        return NONE
    return -2 * np.log(np.clip(tint.mean(), 1e-4, 1)) / chord
