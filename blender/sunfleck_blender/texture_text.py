"""Writes values of one material as textures of the scene language."""

import numpy as np

from .scene_text import columns
from .values import Checks, Flat, Picture, grey, number

UNIT = np.array([[1.0, 0, 0], [0, 1, 0]])
EDGE = 1e-6  # moves checks off the planes on which surfaces like to lie, as Cycles does


def planes(value):
    """Returns the 2 x 3 matrices of all UV textures within a value, and their UV maps."""
    if isinstance(value, Checks):
        own = [value.coordinates] if value.coordinates.kind == "uv" else []
        inner = planes(value.even) + planes(value.odd)
        return [(c.plane(), c.layer) for c in own] + inner
    if isinstance(value, Picture):
        return [(value.coordinates.plane(), value.coordinates.layer)]
    return []


def needs_frame(value):
    """Returns whether a value lies in the coordinates of its object or of the world."""
    return isinstance(value, Checks) and (value.coordinates.kind != "uv"
                                          or needs_frame(value.even) or needs_frame(value.odd))


def relative(plane, base):
    """Returns (uscale, vscale, udelta, vdelta) that make `plane` of `base`, or None."""
    square = base[:, :2]
    if abs(np.linalg.det(square)) < 1e-12:
        return None
    turn = plane[:, :2] @ np.linalg.inv(square)
    if abs(turn[0, 1]) + abs(turn[1, 0]) > 1e-5 * np.abs(turn).max():
        return None
    shift = plane[:, 2] - turn @ base[:, 2]
    return turn[0, 0], turn[1, 1], shift[0], shift[1]


def is_identity(numbers):
    return numbers is not None and np.allclose(numbers, (1, 1, 0, 0), atol=1e-6)


class TextureText:
    """Writes the textures of one material on one object.

    frame: function of a kind of coordinates, returns the 4 x 4 matrix from the world to them.
    """

    def __init__(self, text, images, name, frame, missing):
        self.text = text
        self.images = images
        self.name = name
        self.frame = frame
        self.missing = missing
        self.base = UNIT  # from the mesh's UV map to what is written as its (u, v)
        self.layer = ""
        self._count = 0
        self._known = {}

    def choose_base(self, first, others):
        """Chooses what is baked into the mesh's (u, v).

        first: values that can only lie as (u, v) says; others: values that may be scaled, too.
        """
        found = [plane for value in first + others for plane in planes(value)]
        if not found:
            return
        self.layer = found[0][1]
        if any(layer != self.layer for _, layer in found):
            self.missing(f'several UV maps in one material: "{self.layer or "the active one"}" '
                         "is used")
        for value in first:
            for plane, _ in planes(value):
                self.base = plane
                return
        self.base = next((p for p, _ in found if relative(p, UNIT) is None), UNIT)

    def spectrum(self, name, value):
        """Returns the parameter {"rgb name" or "texture name": ...}."""
        if isinstance(value, Flat):
            return {f"rgb {name}": [min(max(c, 0.0), 1.0) for c in value.colour]}
        return {f"texture {name}": self._texture(value, "spectrum")}

    def number(self, name, value):
        """Returns the parameter of a number, a truth, a named spectrum or a value."""
        if isinstance(value, (str, np.ndarray)):
            return {f"spectrum {name}": value}
        if isinstance(value, bool):
            return {f"bool {name}": value}
        if isinstance(value, (int, float)):
            return {f"float {name}": value}
        if isinstance(value, Flat):
            return {f"float {name}": number(value)}
        return {f"texture {name}": self._texture(grey(value), "float")}

    def lies_as_uv(self, picture):
        """Returns whether a picture lies as the (u, v) say that are written."""
        return is_identity(relative(picture.coordinates.plane(), self.base))

    def _texture(self, value, kind):
        key = (id(value), kind)
        if key not in self._known:
            # The value is kept, so that its id stays its own.
            self._known[key] = (value, self._write(value, kind))
        return self._known[key][1]

    def _write(self, value, kind):
        if isinstance(value, Checks):
            return self._write_checks(value, kind)
        parameters = {"string mapping": "uv"} | self._uv(value.coordinates)
        if kind == "float" or value.file is None:
            file, encoding = self.images.file_of(value, kind == "float")
        else:
            file, encoding = self.images.file_of(value, False)
        parameters |= {"string filename": file, "string wrap": value.wrap,
                       "string filter": value.filter}
        if file.endswith(".png"):
            parameters["string encoding"] = encoding
        return self._say(kind, "imagemap", parameters)

    def _write_checks(self, value, kind):
        sides = {}
        for name, side in (("tex1", value.even), ("tex2", value.odd)):
            sides |= (self.number(name, side) if kind == "float" else self.spectrum(name, side))
        where = value.coordinates
        if where.kind == "uv":
            moved = self._uv(where, EDGE)
            return self._say(kind, "checkerboard", {"integer dimension": 2} | moved | sides)
        to_texture = np.asarray(where.matrix) @ self.frame(where.kind)
        to_texture[:3, 3] += EDGE
        if abs(np.linalg.det(to_texture)) < 1e-20:
            self.missing("a checkerboard without extent: its first colour is used")
            return self._texture(value.even, kind)
        self.text.say("TransformBegin")
        self.text.say("Transform", rest=columns(np.linalg.inv(to_texture)))
        name = self._say(kind, "checkerboard", {"integer dimension": 3} | sides)
        self.text.say("TransformEnd")
        return name

    def _uv(self, coordinates, edge=0.0):
        numbers = relative(coordinates.plane(), self.base)
        if numbers is None:
            self.missing("textures that are turned against each other: one is not turned")
            plane = coordinates.plane()
            numbers = (np.hypot(*plane[:, 0]), np.hypot(*plane[:, 1]), plane[0, 2], plane[1, 2])
        uscale, vscale, udelta, vdelta = numbers
        return {"float uscale": uscale, "float vscale": vscale, "float udelta": udelta + edge,
                "float vdelta": vdelta + edge}

    def _say(self, kind, word, parameters):
        self._count += 1
        name = f"{self.name} texture {self._count}"
        self.text.say("Texture", name, parameters, rest=f'"{kind}" "{word}"')
        return name
