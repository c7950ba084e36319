"""Triangle meshes as binary PLY files, the form that Sunfleck reads fastest."""

import numpy as np

AXES = ("x", "y", "z")
NORMALS = ("nx", "ny", "nz")
UV = ("u", "v")


def write_ply(path, positions, faces, normals=None, uvs=None):
    """Writes one mesh.

    positions: N x 3, faces: M x 3 vertex numbers, normals: N x 3 or None, uvs: N x 2 or None.
    """
    columns = [(AXES, positions)]
    if normals is not None:
        columns.append((NORMALS, normals))
    if uvs is not None:
        columns.append((UV, uvs))
    names = [name for group, _ in columns for name in group]
    vertices = np.empty((len(positions), len(names)), "<f4")
    start = 0
    for group, values in columns:
        vertices[:, start:start + len(group)] = values
        start += len(group)
    triangles = np.empty(len(faces), np.dtype([("count", "u1"), ("corners", "<i4", 3)]))
    triangles["count"] = 3
    triangles["corners"] = faces
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(positions)}"]
    header += [f"property float {name}" for name in names]
    header += [f"element face {len(faces)}",
               "property list uchar int vertex_indices", "end_header", ""]
    with open(path, "wb") as file:
        file.write("\n".join(header).encode("ascii"))
        file.write(vertices.tobytes())
        file.write(triangles.tobytes())
