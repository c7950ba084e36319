"""Takes triangles, normals and texture coordinates out of Blender's meshes, and writes them."""

import numpy as np

from . import geometry, ply


class MeshArrays:
    """The arrays of one mesh of Blender, taken at once: the mesh may go afterwards."""

    def __init__(self, mesh):
        mesh.calc_loop_triangles()
        self.positions = taken(mesh.vertices, "co", 3, np.float32)
        self.triangles = taken(mesh.loop_triangles, "loops", 3, np.int32)
        self.corner_vertex = taken(mesh.loops, "vertex_index", 1, np.int32)
        polygons = taken(mesh.loop_triangles, "polygon_index", 1, np.int32)
        materials = taken(mesh.polygons, "material_index", 1, np.int32)
        self.slots = materials[polygons] if len(polygons) else polygons
        smooth = taken(mesh.polygons, "use_smooth", 1, bool)
        self.normals = corner_normals(mesh, smooth)
        self._layers = {}
        for layer in mesh.uv_layers:
            values = taken(layer.data, "uv", 2, np.float32)
            self._layers[layer.name] = values
            if layer.active_render:
                self._layers[""] = values

    def has_uv(self, layer):
        return layer in self._layers

    def part(self, slot, written):
        """Returns (positions, faces, normals, uvs) of the triangles of a slot, or None.

        written: export_materials.Written, which says which texture coordinates it wants.
        """
        chosen = self.triangles[self.slots == slot] if slot is not None else self.triangles
        if len(chosen) == 0:
            return None
        corners = chosen.ravel()
        attributes = []
        if self.normals is not None:
            attributes.append(self.normals[corners])
        uvs = self._layers.get(written.uv_layer) if written.needs_uv else None
        if uvs is not None:
            base = written.uv_base.astype(np.float32)
            attributes.append(uvs[corners] @ base[:, :2].T + base[:, 2])
        numbers, source, attributes = geometry.corners_to_vertices(
            self.corner_vertex[corners], attributes, len(self.positions))
        normals = attributes.pop(0) if self.normals is not None else None
        return (self.positions[source], numbers.reshape(-1, 3), normals,
                attributes[0] if attributes else None)

    def closed_part(self, slots):
        """Returns (positions, faces by shared vertices) of slots, for questions of closedness."""
        chosen = self.triangles[np.isin(self.slots, list(slots))]
        return self.positions, self.corner_vertex[chosen]


def taken(items, name, width, kind):
    """Returns an attribute of all items as an array, a row an item."""
    values = np.empty(len(items) * width, kind)
    items.foreach_get(name, values)
    return values.reshape(-1, width) if width > 1 else values


def corner_normals(mesh, smooth):
    """Returns a normal for each corner, or None where all faces are flat."""
    if hasattr(mesh, "calc_normals_split"):  # up to 4.0
        if not mesh.has_custom_normals and not smooth.any():
            return None
        mesh.calc_normals_split()
        normals = taken(mesh.loops, "normal", 3, np.float32)
        mesh.free_normals_split()
    else:
        if mesh.normals_domain == "FACE":
            return None
        normals = taken(mesh.corner_normals, "vector", 3, np.float32)
    length = np.linalg.norm(normals, axis=1)
    normals[~(length > 1e-6)] = (0, 0, 1)
    return normals


def write_part(path, part):
    """Writes what part() returned as a PLY file."""
    positions, faces, normals, uvs = part
    ply.write_ply(path, positions, faces, normals, uvs)
