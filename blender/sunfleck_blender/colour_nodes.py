"""Functions of Blender's colour and number nodes, on arrays of colours (..., 3)."""

import numpy as np

from .values import LUMA


def _safe(divisor):
    return np.where(divisor == 0, 1, divisor)


BLENDS = {
    "MIX": lambda a, b: b,
    "ADD": lambda a, b: a + b,
    "MULTIPLY": lambda a, b: a * b,
    "SUBTRACT": lambda a, b: a - b,
    "SCREEN": lambda a, b: 1 - (1 - a) * (1 - b),
    "DIVIDE": lambda a, b: np.where(b == 0, 0, a / _safe(b)),
    "DIFFERENCE": lambda a, b: np.abs(a - b),
    "DARKEN": np.minimum,
    "LIGHTEN": np.maximum,
    "OVERLAY": lambda a, b: np.where(a < 0.5, 2 * a * b, 1 - 2 * (1 - a) * (1 - b)),
    "EXCLUSION": lambda a, b: np.maximum(a + b - 2 * a * b, 0),
}

MATH = {
    "ADD": lambda a, b, c: a + b,
    "SUBTRACT": lambda a, b, c: a - b,
    "MULTIPLY": lambda a, b, c: a * b,
    "DIVIDE": lambda a, b, c: np.where(b == 0, 0, a / _safe(b)),
    "MULTIPLY_ADD": lambda a, b, c: a * b + c,
    "POWER": lambda a, b, c: np.maximum(a, 0) ** b,
    "SQRT": lambda a, b, c: np.sqrt(np.maximum(a, 0)),
    "ABSOLUTE": lambda a, b, c: np.abs(a),
    "MINIMUM": lambda a, b, c: np.minimum(a, b),
    "MAXIMUM": lambda a, b, c: np.maximum(a, b),
    "LESS_THAN": lambda a, b, c: (a < b) * 1.0,
    "GREATER_THAN": lambda a, b, c: (a > b) * 1.0,
    "ROUND": lambda a, b, c: np.floor(a + 0.5),
    "FLOOR": lambda a, b, c: np.floor(a),
    "CEIL": lambda a, b, c: np.ceil(a),
    "FRACT": lambda a, b, c: a - np.floor(a),
    "SINE": lambda a, b, c: np.sin(a),
    "COSINE": lambda a, b, c: np.cos(a),
}


def clamped(colour):
    return np.clip(colour, 0, 1)


def brightness_contrast(colour, bright, contrast):
    """Blender's Bright/Contrast node."""
    return np.maximum((1 + contrast) * colour + bright - contrast * 0.5, 0)


def gamma(colour, exponent):
    """Blender's Gamma node: powers of what is positive."""
    return np.where(colour > 0, np.maximum(colour, 1e-30) ** exponent, colour)


def _to_hsv(colour):
    value = colour.max(axis=-1)
    spread = value - colour.min(axis=-1)
    r, g, b = np.moveaxis(colour, -1, 0)
    divisor = _safe(spread)
    hue = np.where(value == r, (g - b) / divisor % 6,
                   np.where(value == g, (b - r) / divisor + 2, (r - g) / divisor + 4)) / 6
    return np.where(spread == 0, 0, hue), np.where(value > 0, spread / _safe(value), 0), value


def _from_hsv(hue, saturation, value):
    steps = np.stack([np.abs(hue * 6 - 3) - 1, 2 - np.abs(hue * 6 - 2), 2 - np.abs(hue * 6 - 4)],
                     axis=-1)
    return ((np.clip(steps, 0, 1) - 1) * saturation[..., None] + 1) * value[..., None]


def hue_saturation(colour, hue, saturation, value):
    """Blender's Hue/Saturation/Value node; the numbers are greys of one texel or of as many."""
    h, s, v = _to_hsv(colour)
    h = (h + hue[..., 0] + 0.5) % 1
    return np.maximum(_from_hsv(h, np.clip(s * saturation[..., 0], 0, 1), v * value[..., 0]), 0)


def table(samples):
    """Returns a function that looks numbers' luminance up in N x 3 samples over [0, 1]."""
    places = np.linspace(0, 1, len(samples))

    def look(colour):
        at = colour @ LUMA
        return np.stack([np.interp(at, places, samples[:, c]) for c in range(3)], axis=-1)
    return look


def curves(samples):
    """Returns a function that maps each component by its column of N x 3 samples over [0, 1]."""
    places = np.linspace(0, 1, len(samples))
    return lambda colour: np.stack(
        [np.interp(colour[..., c], places, samples[:, c]) for c in range(3)], axis=-1)


def map_range(value, low, high, to_low, to_high):
    """Blender's Map Range node, linear and not clamped."""
    return to_low + (value - low) / _safe(high - low) * (to_high - to_low)


def black_body(kelvin):
    """Returns the linear sRGB of a black body's colour at luminance 1.

    Planck's law through fits of the CIE 1931 curves (Wyman, Sloan and Shirley 2013).
    """
    nm = np.arange(380.0, 781.0, 5.0)
    power = nm ** -5 / np.expm1(1.4388e7 / (nm * max(kelvin, 300.0)))

    def lobe(peak, low, high):
        return np.exp(-0.5 * ((nm - peak) * np.where(nm < peak, low, high)) ** 2)
    x = (0.362 * lobe(442.0, 0.0624, 0.0374) + 1.056 * lobe(599.8, 0.0264, 0.0323)
         - 0.065 * lobe(501.1, 0.0490, 0.0382))
    y = 0.821 * lobe(568.8, 0.0213, 0.0247) + 0.286 * lobe(530.9, 0.0613, 0.0322)
    z = 1.217 * lobe(437.0, 0.0845, 0.0278) + 0.681 * lobe(459.0, 0.0385, 0.0725)
    xyz = np.array([(curve * power).sum() for curve in (x, y, z)])
    rgb = np.array([[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415],
                    [0.0557, -0.2040, 1.0570]]) @ (xyz / xyz[1])
    return np.maximum(rgb, 0)
