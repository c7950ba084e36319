"""Translates Blender's shader nodes into closures."""

import numpy as np

from .bends import bend_of
from .closures import (BLACK, NOTHING, Closure, Plain, add_closures, coated, eta_of_specular,
                       mix_closures)
from .sockets import socket, source
from .values import combine, flat, is_flat, number


class ShaderReader:
    """Reads shaders of one material. textures: TextureReader. missing: called with texts."""

    def __init__(self, textures, missing):
        self.textures = textures
        self.missing = missing

    def closure(self, found, groups=()):
        """Returns the closure that is linked to a shader input."""
        origin = source(found, groups) if found is not None else None
        if origin is None or origin[0].type == "UNLINKED":
            return Closure(BLACK)
        node, _, groups = origin
        reader = READERS.get(node.type)
        if reader is None:
            self.missing(f'node "{node.bl_label}" is not known: grey diffuse is used')
            return Closure(Plain("diffuse", {"reflectance": flat(0.5)}))
        return reader(self, node, groups)

    def value(self, node, name, groups):
        return self.textures.value(socket(node, name), groups)

    def number(self, node, name, groups):
        """Returns a number that cannot be a texture; a texture counts as its mean."""
        found = socket(node, name)
        if found is None:
            return 0.0
        value = self.textures.value(found, groups)
        if not is_flat(value):
            self.missing(f'texture of "{name}": its mean counts')
        return number(value)

    def roughness(self, node, groups, name="roughness", prefix=""):
        """Returns the scene language's roughness: its square root is alpha = Blender's squared."""
        if getattr(node, "distribution", "") == "SHARP":
            return {prefix + "roughness": flat(0)}
        given = combine(lambda r: np.clip(r, 0, 1) ** 4, [self.value(node, name, groups)])
        return {prefix + "roughness": given}

    def bend(self, node, groups):
        return bend_of(self, socket(node, "normal"), groups)


def anisotropic(numbers, amount, missing):
    """Returns the roughness along u and v of Blender's anisotropy (-1 to 1)."""
    if amount == 0:
        return numbers
    missing("anisotropy runs along the UV map, whatever Tangent says")
    aspect = np.sqrt(1 - min(abs(amount), 1) * 0.9)
    # Of alpha; roughness goes with its square.
    wide, narrow = aspect ** -2, aspect ** 2
    if amount < 0:
        wide, narrow = narrow, wide
    return {f"{axis}roughness": combine(lambda r, f=f: np.clip(r * f, 0, 1),
                                        [numbers["roughness"]])
            for axis, f in (("u", wide), ("v", narrow))}


def _diffuse(reader, node, groups):
    if "Roughness" in node.inputs and reader.number(node, "roughness", groups) > 0:
        reader.missing("roughness of a diffuse surface: none is used")
    return Closure(Plain("diffuse", {"reflectance": reader.value(node, "colour", groups)},
                         bend=reader.bend(node, groups)))


def _stand_in(word):
    def read(reader, node, groups):
        reader.missing(f'node "{node.bl_label}": {word} of its colour is used')
        return Closure(Plain("diffuse", {"reflectance": reader.value(node, "colour", groups)}))
    return read


def _glossy(reader, node, groups):
    numbers = reader.roughness(node, groups)
    if "Anisotropy" in node.inputs:
        numbers = anisotropic(numbers, reader.number(node, "anisotropic", groups), reader.missing)
    return Closure(Plain("conductor", {"reflectance": reader.value(node, "colour", groups)},
                         numbers, reader.bend(node, groups)))


def _glass(reader, node, groups):
    numbers = reader.roughness(node, groups)
    numbers["eta"] = max(reader.number(node, "ior", groups), 1e-3)
    colour = reader.value(node, "colour", groups)
    if node.type == "BSDF_REFRACTION":
        reader.missing("Refraction reflects here, too, as glass does")
    return Closure(Plain("dielectric", {}, numbers, reader.bend(node, groups)),
                   tint=None if is_flat(colour, 1) else colour)


def _translucent(reader, node, groups):
    return Closure(Plain("diffusetransmission",
                         {"reflectance": flat(0), "transmittance": reader.value(node, "colour",
                                                                                groups)}))


def _transparent(reader, node, groups):
    colour = reader.value(node, "colour", groups)
    if is_flat(colour, 1):
        return NOTHING
    # Grey glass lets a part through and absorbs the rest.
    reader.missing("a coloured Transparent: its luminance counts, what it stops is lost")
    return Closure(BLACK, combine(lambda c: 1 - np.clip(c, 0, 1), [flat(number(colour))]))


def _emission(reader, node, groups):
    strength = reader.value(node, "strength", groups)
    emitted = combine(lambda c, s: np.maximum(c * s, 0),
                      [reader.value(node, "colour", groups), strength], reader.missing)
    return Closure(BLACK, emission=None if is_flat(emitted, 0) else emitted)


def _is_fresnel(reader, node, groups):
    """Returns the index of a Fresnel node that drives a Mix Shader, or None."""
    origin = source(node.inputs[0], groups)
    if origin is None or origin[0].type != "FRESNEL":
        return None
    return max(reader.number(origin[0], "ior", origin[2]), 1.0001)


def _mix(reader, node, groups):
    a = reader.closure(node.inputs[1], groups)
    eta = _is_fresnel(reader, node, groups)
    if eta is not None:
        b = reader.closure(node.inputs[2], groups)
        words = [getattr(c.material, "word", None) for c in (a, b)]
        if words == ["dielectric", "conductor"]:
            return a  # glass knows its own reflection
        if words == ["diffuse", "conductor"]:
            rough = b.material.numbers.get("roughness", flat(0))
            return Closure(coated(a.material.spectra["reflectance"], rough, eta, a.material.bend))
    amount = combine(lambda t: np.clip(t, 0, 1), [reader.textures.value(node.inputs[0], groups)])
    if is_flat(amount, 0):
        return a
    return mix_closures(amount, a, reader.closure(node.inputs[2], groups), reader.missing)


def _add(reader, node, groups):
    return add_closures(reader.closure(node.inputs[0], groups),
                        reader.closure(node.inputs[1], groups), reader.missing)


def _clear_coat(reader, material, node, groups):
    """Adds Principled's clear coat: a further layer that a part of the light meets."""
    amount = reader.number(node, "clearcoat", groups)
    if amount <= 0:
        return Closure(material)
    rough = reader.roughness(node, groups, "clearcoat roughness")["roughness"]
    if material.word == "conductor":
        numbers = {"conductor." + name: value for name, value in material.numbers.items()}
        numbers |= {"interface.roughness": rough, "interface.eta": 1.5}
        glazed = Plain("coatedconductor", material.spectra, numbers, material.bend)
        return mix_closures(flat(min(amount, 1)), Closure(material), Closure(glazed),
                            reader.missing)
    reader.missing("clear coat: a quarter of the surface has its roughness, at full weight")
    glazed = coated(reader.value(node, "base colour", groups), rough, 1.5, material.bend)
    return mix_closures(flat(0.25 * min(amount, 1)), Closure(material), Closure(glazed),
                        reader.missing)


def _principled(reader, node, groups):
    colour = reader.value(node, "base colour", groups)
    rough = reader.roughness(node, groups)
    bend = reader.bend(node, groups)
    for name in ("sheen", "subsurface"):
        if reader.number(node, name, groups) > 0:
            reader.missing(f"{name} of Principled: left out")
    specular = reader.number(node, "specular", groups)
    if specular > 0:
        eta = eta_of_specular(specular)
        base = coated(colour, rough["roughness"], eta, bend)
    else:
        base = Plain("diffuse", {"reflectance": colour}, bend=bend)
    result = _clear_coat(reader, base, node, groups)
    transmission = reader.value(node, "transmission", groups)
    if not is_flat(transmission, 0):
        eta = max(reader.number(node, "ior", groups), 1e-3)
        glass = Closure(Plain("dielectric", {}, rough | {"eta": eta}, bend),
                        tint=None if is_flat(colour, 1) else colour)
        result = mix_closures(transmission, result, glass, reader.missing)
    metallic = reader.value(node, "metallic", groups)
    if not is_flat(metallic, 0):
        numbers = anisotropic(rough, reader.number(node, "anisotropic", groups), reader.missing)
        metal = _clear_coat(reader, Plain("conductor", {"reflectance": colour}, numbers, bend),
                            node, groups)
        result = mix_closures(metallic, result, metal, reader.missing)
    emitted = combine(lambda c, s: np.maximum(c * s, 0),
                      [reader.value(node, "emission", groups),
                       reader.value(node, "emission strength", groups)], reader.missing)
    if not is_flat(emitted, 0):
        result = add_closures(result, Closure(BLACK, emission=emitted), reader.missing)
    alpha = reader.value(node, "alpha", groups)
    return mix_closures(alpha, NOTHING, result, reader.missing)


READERS = {
    "BSDF_PRINCIPLED": _principled, "BSDF_DIFFUSE": _diffuse, "BSDF_GLOSSY": _glossy,
    "BSDF_ANISOTROPIC": _glossy, "BSDF_GLASS": _glass, "BSDF_REFRACTION": _glass,
    "BSDF_TRANSLUCENT": _translucent, "BSDF_TRANSPARENT": _transparent, "EMISSION": _emission,
    "MIX_SHADER": _mix, "ADD_SHADER": _add,
    "BSDF_VELVET": _stand_in("diffuse"), "BSDF_SHEEN": _stand_in("diffuse"),
    "BSDF_TOON": _stand_in("diffuse"), "SUBSURFACE_SCATTERING": _stand_in("diffuse"),
    "BSDF_HAIR": _stand_in("diffuse"), "BSDF_HAIR_PRINCIPLED": _stand_in("diffuse"),
    "HOLDOUT": lambda reader, node, groups: (
        reader.missing("Holdout: black is used"), Closure(BLACK))[1],
}
