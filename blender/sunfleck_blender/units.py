"""Blender's units of light, as Cycles 3.4 reads them, in radiance and intensity.

Measured: irradiance of a white plane 5 m below each kind of light (docs/guide/blender.md).
"""

import math


def point_intensity(watts):
    """Returns the intensity of a point or spot light (on its axis) in W/sr."""
    return watts / (4 * math.pi)


def sphere_radiance(watts, radius):
    """Returns the radiance of a sphere that shines from afar as a point light does."""
    return point_intensity(watts) / (math.pi * radius * radius)


def area_of_light(shape, size, size_y):
    """Returns the area of an area light, m^2; shape as Blender calls it."""
    if shape == "SQUARE":
        return size * size
    if shape == "RECTANGLE":
        return size * size_y
    return math.pi / 4 * size * (size if shape == "DISK" else size_y)


def area_radiance(watts, area):
    """Returns the radiance of an area light: a quarter of its power over its area."""
    return watts / (4 * area)


def sun_radiance(irradiance, angle):
    """Returns the radiance of a sun's disc, whose diameter is angle (radians)."""
    # 1 - cos(h) = 2 sin(h/2)^2 keeps its digits for half a degree.
    return irradiance / (4 * math.pi * math.sin(angle / 4) ** 2)


def smoothstep(t):
    """Returns 3t^2 - 2t^3 between 0 and 1, and t's nearest end beyond."""
    t = min(max(t, 0.0), 1.0)
    return t * t * (3 - 2 * t)


def spot_falloff(cos_theta, cos_half, blend):
    """Returns a spot light's intensity over that on its axis: Cycles has the cosine, too."""
    if cos_theta <= cos_half:
        return 0.0
    smooth = (1 - cos_half) * blend
    return cos_theta * (smoothstep((cos_theta - cos_half) / smooth) if smooth > 0 else 1.0)
