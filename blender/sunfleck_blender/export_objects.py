"""Walks the evaluated scene, and writes its objects: meshes, instances, lights."""

import os
from dataclasses import dataclass

import numpy as np

from . import export_lights, export_mesh, geometry, volumes
from .matrices import is_usable, matrix_of, scale_of
from .scene_text import columns, quoted

TO_MESH = ("SURFACE", "META")  # not meshes of their own in the evaluated scene of some versions
LEFT_OUT = {"VOLUME": "volumes", "POINTCLOUD": "point clouds", "CURVES": "hair curves",
            "GPENCIL": "grease pencil", "GREASEPENCIL": "grease pencil"}


RAYS = ("camera", "diffuse", "glossy", "transmission", "shadow")


@dataclass
class Placed:
    """One appearance of an object."""
    mesh: int  # number in Objects.meshes
    name: str
    matrix: np.ndarray
    materials: tuple
    converted: bool = False  # made into a mesh here


class Objects:
    """The objects of one evaluated scene. `progress` is called with texts and may raise.

    air: the name of the medium around them, or "".
    """

    def __init__(self, text, folder, book, air, warn, progress):
        self.text = text
        self.folder = folder
        self.book = book
        self.air = air
        self.warn = warn
        self.progress = progress
        self.meshes = []
        self.spaces = []  # of each mesh: (location, size) of its generated coordinates
        self.placed = []
        self.lights = []
        self._numbers = {}
        self._files = {}

    def collect(self, depsgraph):
        """Takes everything out of the evaluated scene: its objects live only while it is walked."""
        for instance in depsgraph.object_instances:
            found = instance.object
            if not instance.show_self:
                continue
            matrix = matrix_of(instance.matrix_world)
            self._take(found, instance, matrix)
        # Blender 3.4 has surfaces and metaballs twice: as they are, and as meshes.
        meshes = {(one.name, one.matrix.tobytes()) for one in self.placed if not one.converted}
        self.placed = [one for one in self.placed if not one.converted
                       or (one.name, one.matrix.tobytes()) not in meshes]

    def _take(self, found, instance, matrix):
        name = found.name_full
        if found.type == "LIGHT":
            if not is_usable(matrix):
                self.warn(f'light "{name}" has no extent along an axis, or no place: left out')
                return
            if self.air and found.data.type == "SUN":
                self.warn(f'light "{name}" is infinitely far, and does not get through the '
                          "volume of the world: left out")
                return
            export_lights.write_light(
                self.text, self.book.images, name, found.data, matrix,
                getattr(getattr(found.data, "sunfleck", None), "seen", True), self.warn)
            return
        if found.type in LEFT_OUT:
            self.warn(f'object "{name}": {LEFT_OUT[found.type]} are not read')
            return
        is_mesh = found.data is not None and hasattr(found.data, "loop_triangles")
        if not is_mesh and found.type not in TO_MESH:
            return
        if any(s.settings.type == "HAIR" and s.settings.render_type == "PATH"
               for s in getattr(found, "particle_systems", ())) and not instance.is_instance:
            self.warn(f'object "{name}": strands of hair are not read')
        if any(m.type == "FLUID" and m.fluid_type == "DOMAIN"
               for m in getattr(found, "modifiers", ())):
            self.warn(f'object "{name}": smoke is not read: its volume is one density throughout')
        if not is_usable(matrix):
            self.warn(f'object "{name}" has no extent along an axis: left out')
            return
        hidden = [ray for ray in RAYS if not getattr(found, f"visible_{ray}", True)]
        if hidden:
            self.warn(f'object "{name}" is hidden from {", ".join(hidden)} rays: it is seen by all')
        number = self._mesh_number(found, not is_mesh)
        if number is not None:
            slots = tuple(slot.material.original if slot.material else None
                          for slot in found.material_slots) or (None,)
            self.placed.append(Placed(number, name, matrix, slots, not is_mesh))

    def _mesh_number(self, found, convert):
        """Returns the number of the object's mesh, taken once for all that share it."""
        key = (found.data.as_pointer(), convert and found.name_full)
        if key in self._numbers:
            return self._numbers[key]
        self.progress(f"reading {found.name_full}")
        mesh = found.to_mesh() if convert else found.data
        number = None
        if mesh is not None and len(mesh.polygons):
            arrays = export_mesh.MeshArrays(mesh)
            if not np.isfinite(arrays.positions).all():
                self.warn(f'object "{found.name_full}" has places that are no numbers: left out')
            else:
                self.meshes.append(arrays)
                space = [np.array(getattr(mesh, n)) for n in ("texspace_location",
                                                              "texspace_size")]
                self.spaces.append(space)
                number = len(self.meshes) - 1
        if convert:
            found.to_mesh_clear()
        self._numbers[key] = number
        return number

    def write(self):
        """Writes all that collect() has taken."""
        shared = {}
        for one in self.placed:
            shared.setdefault(self._object_key(one), []).append(one)
        for key, group in shared.items():
            self.progress(f"writing {group[0].name}")
            if key is None or len(group) == 1:
                for one in group:
                    self._write_alone(one)
            else:
                self._write_instances(group)

    def _object_key(self, one):
        """Returns what instances have in common, or None if it must be written for each."""
        for material in one.materials:
            if self.book.emits(material) or self.book.needs_object(material):
                return None
            if self.book.tinted(material):
                # What tinted glass absorbs depends on its size.
                return one.mesh, one.materials, round(scale_of(one.matrix), 5)
        return one.mesh, one.materials, None

    def _write_alone(self, one):
        self.text.about(f"object {one.name}")
        self.text.begin()
        written = self._materials(one)
        self.text.about(f"object {one.name}")
        self.text.say("ConcatTransform", rest=columns(one.matrix))
        self._shapes(one, written)
        self.text.end()

    def _write_instances(self, group):
        first = group[0]
        name = f"{first.name} (shared by {len(group)}, mesh {first.mesh})"
        self.text.about(f"object {first.name}")
        written = self._materials(first)
        self.text.about(f"object {first.name}")
        self.text.say("ObjectBegin", name)
        self._shapes(first, written)
        self.text.say("ObjectEnd")
        for one in group:
            self.text.about(f"object {one.name}")
            self.text.begin()
            self.text.say("ConcatTransform", rest=columns(one.matrix))
            self.text.say("ObjectInstance", name)
            self.text.end()

    def _materials(self, one):
        """Writes the materials that the object's faces use; returns {slot: Written}."""
        slots = np.unique(self.meshes[one.mesh].slots)
        result = {}
        for slot in slots:
            chosen = one.materials[min(max(int(slot), 0), len(one.materials) - 1)]
            written = self.book.written(chosen, one.name, lambda kind: self._frame(one, kind))
            medium = self._medium(one, written, slots)
            result[int(slot)] = (written, medium)
            if written.needs_uv and not self.meshes[one.mesh].has_uv(written.uv_layer):
                layer = f'UV map "{written.uv_layer}"' if written.uv_layer else "UV map"
                self.warn(f'object "{one.name}" has no {layer}, which its material asks for')
        return result

    def _frame(self, one, kind):
        """Returns the matrix from the world to a kind of coordinates of an object."""
        if kind == "world":
            return np.eye(4)
        to_object = np.linalg.inv(one.matrix)
        if kind == "generated":
            location, size = self.spaces[one.mesh]
            scale = np.where(size > 0, 0.5 / np.where(size > 0, size, 1), 0.5)
            generated = np.eye(4)
            generated[:3, :3] = np.diag(scale)
            generated[:3, 3] = 0.5 - location * scale
            return generated @ to_object
        return to_object

    def _medium(self, one, written, slots):
        """Writes the medium below a surface; returns its name, or an empty one."""
        if not written.lets_through:
            return ""
        positions, faces = self.meshes[one.mesh].closed_part(slots)
        closed = geometry.is_closed(faces)
        volume = written.volume
        if not closed:
            self.warn(f'object "{one.name}" is of glass or full of a medium, but not closed: '
                      "light that enters it does not leave (close it, or make its material thin "
                      "glass)")
        if written.tint is not None and closed:
            chord = geometry.mean_chord(positions, faces) * scale_of(one.matrix)
            volume = volume.absorbing(volumes.absorption_of_tint(written.tint, chord))
        elif written.tint is not None:
            self.warn(f'object "{one.name}": the colour of glass that is not closed is left out')
        if volume.is_empty():
            return ""
        name = f"inside {written.name} of {one.name}"
        volume.write(self.text, name)
        return name

    def _shapes(self, one, materials):
        arrays = self.meshes[one.mesh]
        for slot, (written, medium) in materials.items():
            if written.nothing:
                continue
            file = self._file(one.mesh, slot, written)
            if file is None:
                continue
            self.text.begin()
            self.text.say("NamedMaterial", written.name)
            if medium or (self.air and written.lets_through):
                self.text.say("MediumInterface", medium, rest=quoted(self.air))
            if written.emission:
                both = not outward(arrays, materials)
                self.text.light(one.name, "AreaLightSource", "diffuse",
                                written.emission | {"bool twosided": both})
            self.text.say("Shape", "plymesh", {"string filename": file} | written.alpha)
            self.text.end()

    def _file(self, mesh, slot, written):
        """Writes the faces of a slot once for each way of laying textures; returns the name."""
        key = (mesh, slot, written.needs_uv and (written.uv_layer, written.uv_base.tobytes()))
        if key not in self._files:
            part = self.meshes[mesh].part(slot, written)
            name = None
            if part is not None:
                os.makedirs(os.path.join(self.folder, "meshes"), exist_ok=True)
                name = f"meshes/{len(self._files):05d}.ply"
                export_mesh.write_part(os.path.join(self.folder, name), part)
            self._files[key] = name
        return self._files[key]


def outward(arrays, materials):
    """Returns whether a mesh is closed and faces outwards: then its inside need not shine."""
    positions, faces = arrays.closed_part(materials)
    return geometry.is_closed(faces) and geometry.triangle_volume(positions, faces) > 0
