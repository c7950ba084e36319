"""4 x 4 matrices of numpy from Blender's."""

import numpy as np


def matrix_of(blender):
    """Returns Blender's matrix as rows of numbers."""
    return np.array([list(row) for row in blender], float)


def is_usable(matrix):
    """Returns whether a matrix places things: finite, and not flattened."""
    return bool(np.isfinite(matrix).all() and abs(np.linalg.det(matrix[:3, :3])) > 1e-30)


def turn_of(matrix):
    """Returns the 3 x 3 rotation of a matrix, without its scale."""
    columns = matrix[:3, :3] / np.linalg.norm(matrix[:3, :3], axis=0)
    return columns


def scale_of(matrix):
    """Returns the mean factor by which a matrix makes lengths longer."""
    return float(abs(np.linalg.det(matrix[:3, :3])) ** (1 / 3))
