"""Blender's sky textures: with a sun as Sunfleck's own sky, without as Preetham's.

Preetham, Shirley and Smits, A Practical Analytic Model for Daylight (SIGGRAPH 1999).
"""

import math

import numpy as np

# Perez's coefficients of luminance and of both chromaticities: slope by turbidity, and at zero.
PEREZ = (((0.1787, -1.4630), (-0.3554, 0.4275), (-0.0227, 5.3251), (0.1206, -2.5771),
          (-0.0670, 0.3703)),
         ((-0.0193, -0.2592), (-0.0665, 0.0008), (-0.0004, 0.2125), (-0.0641, -0.8989),
          (-0.0033, 0.0452)),
         ((-0.0167, -0.2608), (-0.0950, 0.0092), (-0.0079, 0.2102), (-0.0441, -1.6537),
          (-0.0109, 0.0529)))
# Chromaticity of the zenith: rows by powers 2, 1, 0 of turbidity, columns by powers 3 to 0 of the
# sun's angle from it.
ZENITH = (((0.00166, -0.00375, 0.00209, 0), (-0.02903, 0.06377, -0.03202, 0.00394),
           (0.11693, -0.21196, 0.06052, 0.25886)),
          ((0.00275, -0.00610, 0.00317, 0), (-0.04214, 0.08970, -0.04153, 0.00516),
           (0.15346, -0.26756, 0.06670, 0.26688)))
TO_RGB = np.array([[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415],
                   [0.0557, -0.2040, 1.0570]])
# Irradiance of the ground under Blender 3.4's skies without a sun, luminance, as measured at these
# elevations in degrees (turbidity 3, air 1).
ELEVATIONS = (10, 40, 70)
IRRADIANCE = {"NISHITA": (5.71, 8.96, 9.69), "HOSEK_WILKIE": (0.1325, 0.2394, 0.2733),
              "PREETHAM": (0.95, 1.67, 2.0)}


def panorama_directions(height):
    """Returns height x 2 height x 3 unit vectors of a panorama, as Blender's."""
    v = 0.5 - (np.arange(height) + 0.5) / height
    u = 0.5 - (np.arange(2 * height) + 0.5) / (2 * height)
    theta, phi = np.meshgrid(v * np.pi, u * 2 * np.pi, indexing="ij")
    return np.stack([np.cos(theta) * np.cos(phi), np.cos(theta) * np.sin(phi), np.sin(theta)],
                    axis=-1)


def _perez(cos_theta, gamma, coefficients):
    a, b, c, d, e = coefficients
    return ((1 + a * np.exp(b / cos_theta))
            * (1 + c * np.exp(d * gamma) + e * np.cos(gamma) ** 2))


def preetham(directions, sun, turbidity):
    """Returns linear sRGB radiances of a clear sky without its sun.

    directions: ... x 3 unit vectors, z up; below the horizon its colours go on. The luminance is
    such that the ground has the irradiance 1.
    """
    elevation = math.asin(min(max(sun[2], 0.01), 1))
    zenith_angle = math.pi / 2 - elevation
    cos_theta = np.maximum(directions[..., 2], 0.01)
    gamma = np.arccos(np.clip(directions @ np.asarray(sun), -1, 1))
    powers = np.array([zenith_angle ** p for p in (3, 2, 1, 0)])
    by_turbidity = np.array([turbidity ** p for p in (2, 1, 0)])
    zenith = [1.0] + [float(by_turbidity @ (np.array(rows) @ powers)) for rows in ZENITH]
    values = []
    for rows, at_zenith in zip(PEREZ, zenith):
        coefficients = [slope * turbidity + start for slope, start in rows]
        values.append(at_zenith * _perez(cos_theta, gamma, coefficients)
                      / _perez(1.0, zenith_angle, coefficients))
    luminance, x, y = values
    xyz = np.stack([x / y, np.ones_like(x), (1 - x - y) / y], axis=-1) * luminance[..., None]
    return np.maximum(xyz @ TO_RGB.T, 0)


def sky_panorama(kind, sun, turbidity, height=128):
    """Returns a panorama of one of Blender's skies without a sun, about as bright as Blender's."""
    directions = panorama_directions(height)
    pixels = preetham(directions, sun, min(max(turbidity, 1.7), 10))
    up = np.maximum(directions[..., 2], 0)
    solid = np.cos(np.arcsin(directions[..., 2])) * (np.pi / height) ** 2
    luminance = pixels @ np.array([0.2126, 0.7152, 0.0722])
    elevation = math.degrees(math.asin(min(max(sun[2], 0), 1)))
    wanted = np.interp(elevation, ELEVATIONS, IRRADIANCE[kind])
    return pixels * (wanted / float((luminance * up * solid).sum()))


def sun_of(node):
    """Returns (azimuth clockwise from y, elevation) in degrees of a sky texture's sun."""
    if node.sky_type == "NISHITA":
        return math.degrees(node.sun_rotation) % 360, math.degrees(node.sun_elevation)
    x, y, z = node.sun_direction
    return math.degrees(math.atan2(x, y)) % 360, math.degrees(math.atan2(z, math.hypot(x, y)))


def direction_of(azimuth, elevation):
    """Returns the unit vector to a sun, of angles in degrees."""
    a, e = math.radians(azimuth), math.radians(elevation)
    return math.sin(a) * math.cos(e), math.cos(a) * math.cos(e), math.sin(e)
