"""What a node's socket is worth: a flat colour, a picture, or a checkerboard of two of these.

Each is closed under functions of colours, so that a chain of colour nodes becomes one texture.
Colours are rows of three numbers, linear sRGB; a number is a grey.
"""

from dataclasses import dataclass, field
from typing import Callable, NamedTuple, Optional

import numpy as np

LUMA = np.array([0.2126, 0.7152, 0.0722])
IDENTITY = ((1.0, 0, 0, 0), (0, 1.0, 0, 0), (0, 0, 1.0, 0), (0, 0, 0, 1.0))


class Coordinates(NamedTuple):
    """Where a texture is asked: a matrix applied to the surface's coordinates of some kind."""
    kind: str = "uv"  # or "object", "generated", "world"
    layer: str = ""  # name of the UV map; empty for the one that renders use
    matrix: tuple = IDENTITY

    def then(self, matrix):
        """Returns these coordinates, moved by a further matrix."""
        product = np.asarray(matrix) @ np.asarray(self.matrix)
        return self._replace(matrix=tuple(map(tuple, product.tolist())))

    def plane(self):
        """Returns the 2 x 3 matrix from (u, v, 1) to the texture's first two coordinates."""
        m = np.asarray(self.matrix)
        return m[:2][:, [0, 1, 3]]


@dataclass(frozen=True)
class Flat:
    colour: tuple

    def mean(self):
        return np.array(self.colour, float)


@dataclass(frozen=True)
class Picture:
    pixels: Callable  # returns H x W x 3 floats, linear, first row on top
    coordinates: Coordinates
    wrap: str = "repeat"
    filter: str = "bilinear"
    file: Optional[tuple] = None  # (image key, encoding) where it is a file as it stands
    bright: bool = field(default=False)  # may go beyond [0, 1]

    def mean(self):
        return self.pixels().reshape(-1, 3).mean(axis=0)


@dataclass(frozen=True)
class Checks:
    even: object
    odd: object
    coordinates: Coordinates

    def mean(self):
        return (self.even.mean() + self.odd.mean()) / 2


def flat(*colour):
    """Returns a flat value of three numbers or one."""
    return Flat(tuple(float(c) for c in (colour * 3 if len(colour) == 1 else colour[:3])))


def is_flat(value, colour=None):
    """Returns whether a value is flat, and of this number or colour where one is given."""
    if not isinstance(value, Flat):
        return False
    return colour is None or np.allclose(value.colour, colour, atol=1e-7)


def number(value):
    """Returns the luminance of a value's mean, as Blender makes a number of a colour."""
    return float(value.mean() @ LUMA)


def grey(value):
    """Returns a value's luminance as a value."""
    return combine(lambda c: np.broadcast_to((c @ LUMA)[..., None], c.shape), [value])


def combine(function, values, lost=None):
    """Returns function of the values' colours; function maps arrays (..., 3) to (..., 3).

    Pictures that lie differently cannot be combined: but the first, they count as their means, and
    `lost` is called with a text that says so.
    """
    checks = next((v for v in values if isinstance(v, Checks)), None)
    if checks is not None:
        def side(value, name):
            same = isinstance(value, Checks) and value.coordinates == checks.coordinates
            return getattr(value, name) if same else value
        return Checks(combine(function, [side(v, "even") for v in values], lost),
                      combine(function, [side(v, "odd") for v in values], lost),
                      checks.coordinates)
    first = next((v for v in values if isinstance(v, Picture)), None)
    if first is None:
        arrays = [np.array([v.colour], float) for v in values]
        return flat(*np.asarray(function(*arrays), float).reshape(-1)[:3])

    def fits(value):
        return (value.coordinates, value.wrap) == (first.coordinates, first.wrap)
    kept = [v if not isinstance(v, Picture) or fits(v) else flat(*v.mean()) for v in values]
    if lost and any(a is not b for a, b in zip(kept, values)):
        lost("pictures that lie differently are combined: one of them counts as its mean")

    def pixels():
        arrays = [v.pixels() if isinstance(v, Picture) else np.array([[v.colour]], np.float32)
                  for v in kept]
        size = max((a.shape[:2] for a in arrays), key=lambda s: s[0] * s[1])
        return np.asarray(function(*[_resized(a, size) for a in arrays]), np.float32)
    bright = any(v.bright for v in kept if isinstance(v, Picture))
    return Picture(pixels, first.coordinates, first.wrap, first.filter, None, bright)


def _resized(array, size):
    """Returns the nearest texels of a picture of another size; one texel stays one."""
    if array.shape[:2] in (size, (1, 1)):
        return array
    rows = np.arange(size[0]) * array.shape[0] // size[0]
    columns = np.arange(size[1]) * array.shape[1] // size[1]
    return array[rows][:, columns]


def mixed(amount, a, b, lost=None):
    """Returns a where amount is 0 and b where it is 1."""
    if is_flat(amount):
        share = amount.colour[0]
        if share == 0:
            return a
        if share == 1:
            return b
    return combine(lambda t, x, y: x * (1 - t) + y * t, [amount, a, b], lost)


def scaled(value, factor):
    """Returns a value times a number."""
    return value if factor == 1 else combine(lambda c: c * factor, [value])
