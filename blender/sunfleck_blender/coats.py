"""How much light a clear coat lets pass, and what must lie below it to look as in Blender.

Blender's Principled adds its coat to a base that it does not dim. A real coat dims what is below
by what it reflects. So the base is made brighter, until both agree where light comes at 45 degrees
and leaves at 60; what the inside of the coat holds back is given back (`compensated`).
Formulas: Walter et al. 2007, Heitz 2018 (visible facets), as Sunfleck's coat has them.
"""

from functools import lru_cache

import numpy as np

SMOOTH = 1e-3  # alpha below which a surface has no facets
GRID = 24  # facets in each direction


def fresnel(cosine, eta):
    """Returns how much a boundary of relative index eta reflects; cosine: an array."""
    sine2 = (1 - cosine * cosine) / (eta * eta)
    inner = np.sqrt(np.maximum(1 - sine2, 0))
    along = (eta * cosine - inner) / (eta * cosine + inner)
    across = (cosine - eta * inner) / (cosine + eta * inner)
    return np.where(sine2 >= 1, 1.0, (along * along + across * across) / 2)


def _facets(cosine, alpha):
    """Returns normals of the facets that are seen from a direction (sine, 0, cosine)."""
    u = (np.arange(GRID) + 0.5) / GRID
    u1, u2 = (a.ravel() for a in np.meshgrid(u, u))
    view = np.array([alpha * np.sqrt(1 - cosine * cosine), 0, cosine])
    view /= np.linalg.norm(view)
    first = np.array([0.0, 1.0, 0.0])
    second = np.cross(view, first)
    radius, angle = np.sqrt(u1), 2 * np.pi * u2
    a, b = radius * np.cos(angle), radius * np.sin(angle)
    share = (1 + view[2]) / 2
    b = (1 - share) * np.sqrt(np.maximum(1 - a * a, 0)) + share * b
    c = np.sqrt(np.maximum(1 - a * a - b * b, 0))
    normals = a[:, None] * first + b[:, None] * second + c[:, None] * view
    normals[:, :2] *= alpha
    return normals / np.linalg.norm(normals, axis=1, keepdims=True)


def _hidden(cosine, alpha):
    """Smith's Lambda."""
    tangent2 = 1 / np.maximum(cosine * cosine, 1e-12) - 1
    return (np.sqrt(1 + alpha * alpha * tangent2) - 1) / 2


def _kept(cosine, other, alpha):
    """Returns the share of what a visible facet sends to `other` that no facet stops."""
    mine = _hidden(cosine, alpha)
    return np.where(other > 0, (1 + mine) / (1 + mine + _hidden(other, alpha)), 0)


def entering(cosine, alpha, eta):
    """Returns the share of light from a direction outside that gets below the coat."""
    if alpha < SMOOTH:
        return float(1 - fresnel(np.array(cosine), eta))
    view = np.array([np.sqrt(1 - cosine * cosine), 0, cosine])
    normals = _facets(cosine, alpha)
    c = np.clip(normals @ view, 1e-9, 1)
    far = np.sqrt(np.maximum(1 - (1 - c * c) / (eta * eta), 0))
    below = -(normals * (c / eta - far)[:, None] - view / eta)[:, 2]
    return float(np.mean((1 - fresnel(c, eta)) * _kept(cosine, below, alpha)))


@lru_cache(maxsize=256)
def seen_base(alpha, eta):
    """Returns how bright a white base looks through a coat, its losses given back: lit at 45
    degrees, and seen at 60."""
    cosines = (np.arange(24) + 0.5) / 24
    mean = np.mean([entering(c, alpha, eta) * 2 * c for c in cosines])
    return float(entering(np.sqrt(0.5), alpha, eta) * entering(0.5, alpha, eta) / mean)
