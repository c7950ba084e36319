"""Writes Blender's materials as named materials of the scene language."""

from dataclasses import dataclass, field

import numpy as np

from . import bends, volumes
from .closures import (BLACK, Blend, Closure, Plain, lets_light_through, plain_parts)
from .named import with_name
from .shaders import ShaderReader
from .texture_text import UNIT, TextureText, needs_frame, planes
from .textures import TextureReader
from .values import Flat, Picture, flat, is_flat


@dataclass
class Written:
    """What shapes need to know of a material that has been written."""
    name: str
    alpha: dict = field(default_factory=dict)  # the shape's parameter
    emission: dict = field(default_factory=dict)  # parameters of the area light
    volume: volumes.Volume = volumes.EMPTY  # below the surface
    tint: object = None
    lets_through: bool = False
    nothing: bool = False  # neither seen nor felt
    uv_layer: str = ""
    uv_base: np.ndarray = field(default_factory=lambda: UNIT)
    needs_uv: bool = False
    needs_normals: bool = True


class MaterialBook:
    """The materials of one scene, each written once, or once an object where it needs that.

    warn: called with a text, once for each loss of each material.
    """

    def __init__(self, text, images, warn):
        self.text = text
        self.images = images
        self.warn = warn
        self._read = {}
        self._written = {}

    def needs_object(self, material):
        """Returns whether a material looks different on each object."""
        closure, bend, _ = self.reading(material)
        return any(needs_frame(value) for value in _values(closure, bend))

    def emits(self, material):
        return self.reading(material)[0].emission is not None

    def tinted(self, material):
        return self.reading(material)[0].tint is not None

    def written(self, material, object_name, frame):
        """Returns the Written of a material; frame as for TextureText."""
        key = (_name(material), object_name if self.needs_object(material) else None)
        if key not in self._written:
            self._written[key] = self._write(material, key, frame)
        return self._written[key]

    def reading(self, material):
        """Returns (closure, bend of the whole, Volume) of a material, read once."""
        key = _name(material)
        if key not in self._read:
            self._read[key] = self._new_reading(material)
        return self._read[key]

    def missing(self, material):
        name = _name(material) or "none"
        return lambda text: self.warn(f'material "{name}": {text}')

    def _new_reading(self, material):
        if material is None:
            return Closure(Plain("diffuse", {"reflectance": flat(0.8)})), None, volumes.EMPTY
        if not material.use_nodes or material.node_tree is None:
            colour = flat(*material.diffuse_color[:3])
            return Closure(Plain("diffuse", {"reflectance": colour})), None, volumes.EMPTY
        missing = self.missing(material)
        tree = material.node_tree
        output = tree.get_output_node("CYCLES") or tree.get_output_node("ALL")
        if output is None:
            return Closure(BLACK), None, volumes.EMPTY
        reader = ShaderReader(TextureReader(self.images, missing), missing)
        volume = volumes.volume_of(reader, output.inputs["Volume"])
        if not output.inputs["Surface"].is_linked and output.inputs["Volume"].is_linked:
            return Closure(Plain("interface")), None, volume
        closure = reader.closure(output.inputs["Surface"])
        if closure.is_nothing() and not volume.is_empty():
            return Closure(Plain("interface")), None, volume
        return closure, bends.displacement(reader, output.inputs["Displacement"]), volume

    def _write(self, material, key, frame):
        closure, bend, volume = self.reading(material)
        base = (_name(material) or "no material")
        name = base if key[1] is None else f"{base} on {key[1]}"
        own = getattr(material, "sunfleck", None)
        thin = getattr(own, "thin", False)
        named = getattr(own, "named", "NONE")
        missing = self.missing(material)
        self.text.about(f"material {base}")
        textures = TextureText(self.text, self.images, name, frame, missing)
        fixed = [b[1] for b in _bends(closure.material, bend)
                 if b[0] == "normalmap"] + ([closure.emission] if closure.emission else [])
        others = _values(closure, bend)
        textures.choose_base(fixed, others)
        self._named(closure.material or BLACK, name, textures, bend, (thin, named))
        through = lets_light_through(closure.material) and not thin
        return Written(
            name, alpha=self._alpha(closure, textures),
            emission=self._emission(closure.emission, textures, missing),
            volume=volume if through else volumes.EMPTY,
            tint=closure.tint if through else None, lets_through=through,
            nothing=closure.is_nothing(),
            uv_layer=textures.layer, uv_base=textures.base,
            needs_uv=any(planes(value) for value in others + fixed) or _anisotropic(closure))

    def _named(self, material, name, textures, bend, kind):
        if isinstance(material, Blend):
            names = [f"{name} (1)", f"{name} (2)"]
            self._named(material.first, names[0], textures, bend, kind)
            self._named(material.second, names[1], textures, bend, kind)
            parameters = {"string materials": names}
            parameters |= textures.number("amount", material.amount)
            self._make(name, "mix", parameters)
            return
        parameters = {}
        word, (thin, named) = material.word, kind
        spectra, numbers = with_name(word, material.spectra, material.numbers, named)
        if thin and word == "dielectric":
            word, numbers = "thindielectric", {"eta": numbers["eta"]}
        for parameter, value in spectra.items():
            parameters |= textures.spectrum(parameter, value)
        for parameter, value in numbers.items():
            parameters |= textures.number(parameter, value)
        if word not in ("interface", "thindielectric"):
            parameters |= self._bend(material.bend or bend, textures)
        self._make(name, word, parameters)

    def _make(self, name, word, parameters):
        self.text.say("MakeNamedMaterial", name, {"string type": word} | parameters)

    def _bend(self, bend, textures):
        if bend is None:
            return {}
        kind, value = bend
        if kind == "displacement":
            return textures.number("displacement", value)
        if not textures.lies_as_uv(value):
            textures.missing("a normal map that lies otherwise than another picture: left out")
            return {}
        if value.coordinates.plane()[0, 1] != 0:
            textures.missing("a normal map that is turned: its slopes are not turned with it")
        file, encoding = self.images.file_of(value, False)
        return {"string normalmap": self.images.linear_file(value, file, encoding)}

    def _alpha(self, closure, textures):
        if is_flat(closure.alpha, 1):
            return {}
        return textures.number("alpha", closure.alpha)

    def _emission(self, value, textures, missing):
        if value is None:
            return {}
        if isinstance(value, Picture) and textures.lies_as_uv(value):
            return {"string filename": self.images.pfm_of(value)}
        if not isinstance(value, Flat):
            missing("emission that varies: its mean counts")
        return {"rgb L": list(value.mean())}


def _name(material):
    return material.name_full if material is not None else None


def _bends(material, bend):
    return [part.bend or bend for part in plain_parts(material) if part.bend or bend]


def _values(closure, bend):
    """Returns all values of a closure that become textures."""
    found = [closure.alpha] + [b[1] for b in _bends(closure.material, bend)
                               if b[0] == "displacement"]
    for part in plain_parts(closure.material):
        found += list(part.spectra.values())
        found += [v for v in part.numbers.values() if not isinstance(v, (int, float))]
    stack = [closure.material]
    while stack:
        material = stack.pop()
        if isinstance(material, Blend):
            found.append(material.amount)
            stack += [material.first, material.second]
    return found


def _anisotropic(closure):
    return any("uroughness" in part.numbers for part in plain_parts(closure.material))
