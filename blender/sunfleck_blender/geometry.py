"""Numbers about triangle meshes, and corners that become vertices."""

import numpy as np


def triangle_volume(positions, faces):
    """Returns the signed volume that the triangles enclose: above 0 if they face outwards."""
    a, b, c = (positions[faces[:, corner]].astype(np.float64) for corner in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def triangle_area(positions, faces):
    """Returns the sum of the areas of the triangles."""
    a, b, c = (positions[faces[:, corner]].astype(np.float64) for corner in range(3))
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)


def is_closed(faces):
    """Returns whether each edge belongs to two triangles that run along it in opposite ways.

    faces: M x 3 numbers of vertices; vertices at one place count as one if they have one number.
    """
    if len(faces) == 0:
        return False
    start = faces.astype(np.int64).ravel()
    end = faces[:, [1, 2, 0]].astype(np.int64).ravel()
    size = int(faces.max()) + 1
    along = np.sort(start * size + end)
    against = np.sort(end * size + start)
    return bool(np.array_equal(along, against) and np.all(along[1:] != along[:-1]))


def mean_chord(positions, faces):
    """Returns the mean length of straight ways through a closed mesh: four volumes over area."""
    area = triangle_area(positions, faces)
    return 4 * abs(triangle_volume(positions, faces)) / area if area > 0 else 0.0


def corners_to_vertices(corner_vertex, attributes, vertex_count):
    """Gives each corner a vertex whose attributes are its own.

    corner_vertex: vertex number of each corner. attributes: list of arrays, a row for each corner.
    Returns (vertex number of each corner, source vertex of each vertex, attributes of each vertex).
    Corners that agree with the first corner of their vertex share it; the others get new ones.
    """
    first = np.full(vertex_count, -1, np.int64)
    # Written backwards, so that the first corner of a vertex is the one that stays.
    first[corner_vertex[::-1]] = np.arange(len(corner_vertex) - 1, -1, -1)
    same = np.ones(len(corner_vertex), bool)
    for values in attributes:
        same &= np.all(values == values[first[corner_vertex]], axis=1)
    used = first >= 0
    number = np.cumsum(used) - 1
    others = np.flatnonzero(~same)
    corners = number[corner_vertex]
    corners[others] = used.sum() + np.arange(len(others))
    source_corner = np.concatenate([first[used], others])
    return corners, corner_vertex[source_corner], [values[source_corner] for values in attributes]
