"""Environment pictures: from latitude and longitude to the square equal-area octahedral map."""

import numpy as np


def equal_area_directions(size):
    """Returns size x size x 3 unit vectors: the direction of the middle of each cell.

    The map of pbrt-v4 (Clarberg 2008): the square's middle is +z, its corners are -z.
    """
    grid = (np.arange(size) + 0.5) / size * 2 - 1
    u, v = np.meshgrid(grid, grid)
    up, vp = np.abs(u), np.abs(v)
    signed = 1 - (up + vp)
    radius = 1 - np.abs(signed)
    with np.errstate(invalid="ignore", divide="ignore"):
        phi = np.where(radius > 0, ((vp - up) / radius + 1) * np.pi / 4, np.pi / 4)
    z = np.copysign(1 - radius * radius, signed)
    around = radius * np.sqrt(np.maximum(2 - radius * radius, 0))
    return np.stack([np.copysign(np.cos(phi), u) * around,
                     np.copysign(np.sin(phi), v) * around, z], axis=-1)


def blender_uv(directions):
    """Returns (u, v) in [0, 1] of directions in a latitude-longitude picture, as Blender's."""
    x, y, z = np.moveaxis(directions, -1, 0)
    return (0.5 - np.arctan2(y, x) / (2 * np.pi),
            np.arctan2(z, np.hypot(x, y)) / np.pi + 0.5)


def look_up(pixels, u, v):
    """Returns bilinear values of a picture (first row on top); u goes around, v is clamped."""
    height, width = pixels.shape[:2]
    x = u * width - 0.5
    y = (1 - v) * height - 0.5
    x0, y0 = np.floor(x).astype(int), np.floor(y).astype(int)
    fx, fy = (x - x0)[..., None], (y - y0)[..., None]
    left, right = x0 % width, (x0 + 1) % width
    top, bottom = np.clip(y0, 0, height - 1), np.clip(y0 + 1, 0, height - 1)
    return ((pixels[top, left] * (1 - fx) + pixels[top, right] * fx) * (1 - fy)
            + (pixels[bottom, left] * (1 - fx) + pixels[bottom, right] * fx) * fy)


def equal_area_map(pixels, size, turn=None, samples=2):
    """Returns the size x size x 3 map of a latitude-longitude picture.

    turn: 3 x 3 matrix from the world's directions to the picture's, or None.
    Each cell is the mean of samples x samples places in it.
    """
    directions = equal_area_directions(size * samples)
    if turn is not None:
        directions = directions @ np.asarray(turn).T
    u, v = blender_uv(directions)
    fine = np.empty(directions.shape, np.float32)
    for row in range(0, len(fine), 256):  # keeps the memory small
        fine[row:row + 256] = look_up(pixels, u[row:row + 256], v[row:row + 256])
    return fine.reshape(size, samples, size, samples, 3).mean(axis=(1, 3))
