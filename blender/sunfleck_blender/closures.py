"""What a surface does with light, between Blender's shader nodes and the scene language."""

from dataclasses import dataclass, field, replace
from typing import Any, Optional

import numpy as np

from . import coats
from .values import combine, flat, is_flat, mixed, number


@dataclass(frozen=True)
class Plain:
    """One material of the scene language: its word, and values by its parameters' names."""
    word: str
    spectra: dict = field(default_factory=dict)
    numbers: dict = field(default_factory=dict)  # values, or numbers as they are
    bend: Optional[tuple] = None  # ("normalmap" or "displacement", value)


@dataclass(frozen=True)
class Blend:
    """Two materials, of which light meets the second with a probability."""
    first: Any
    second: Any
    amount: Any


@dataclass(frozen=True)
class Closure:
    """A surface: its material (None: nothing), how far it is there, what it emits."""
    material: Any = None
    alpha: Any = flat(1)
    emission: Any = None
    tint: Any = None  # Blender's colour of glass: what one crossing leaves

    def is_nothing(self):
        """Returns whether it is neither seen nor felt."""
        return is_flat(self.alpha, 0) and self.emission is None


NOTHING = Closure(alpha=flat(0))
BLACK = Plain("diffuse", {"reflectance": flat(0)})


def mix_closures(amount, a, b, missing):
    """Returns a where amount is 0 and b where it is 1."""
    if is_flat(amount, 0):
        return a
    if is_flat(amount, 1):
        return b
    alpha = mixed(amount, a.alpha, b.alpha, missing)
    if a.material is None and is_flat(a.alpha, 0) and a.emission is None:
        return replace(b, alpha=alpha)
    if b.material is None and is_flat(b.alpha, 0) and b.emission is None:
        return replace(a, alpha=alpha)
    emission = None
    if a.emission is not None or b.emission is not None:
        emission = mixed(amount, a.emission or flat(0), b.emission or flat(0), missing)
    if a.material is None or b.material is None:
        material = a.material or b.material
    elif a.material == b.material:
        material = a.material
    else:
        material = Blend(a.material, b.material, amount)
    return Closure(material, alpha, emission, a.tint or b.tint)


def add_closures(a, b, missing):
    """Returns both at once; two materials become a blend of both, twice as bright."""
    emission = a.emission
    if b.emission is not None:
        emission = b.emission if emission is None else combine(
            lambda x, y: x + y, [emission, b.emission], missing)

    def real(closure):
        return closure.material is not None and closure.material != BLACK
    if real(a) and real(b):
        missing("Add Shader of two surfaces: a mix of both, each up to twice as bright")
        material = Blend(doubled(a.material), doubled(b.material), flat(0.5))
    else:
        material = a.material if real(a) else b.material if real(b) else a.material or b.material
    if not is_flat(a.alpha, 1) and not is_flat(b.alpha, 1):
        alpha = combine(np.maximum, [a.alpha, b.alpha], missing)
        if emission is not None and is_flat(alpha, 0):
            missing("emission added to a transparent surface: it shines, but is not seen itself")
    else:
        alpha = flat(1)
    return Closure(material, alpha, emission, a.tint or b.tint)


def doubled(material):
    """Returns a material twice as bright, at most white."""
    if isinstance(material, Blend):
        return Blend(doubled(material.first), doubled(material.second), material.amount)
    spectra = {name: combine(lambda c: np.minimum(2 * c, 1), [value])
               for name, value in material.spectra.items()}
    return replace(material, spectra=spectra)


def plain_parts(material):
    """Returns all Plain materials within a material."""
    if isinstance(material, Blend):
        return plain_parts(material.first) + plain_parts(material.second)
    return [material] if material is not None else []


def lets_light_through(material):
    """Returns whether light may get below the surface as a beam."""
    return any(part.word in ("dielectric", "interface") for part in plain_parts(material))


def eta_of_specular(specular):
    """Returns the index whose reflection along the normal is 8% of Blender's specular."""
    root = np.sqrt(np.clip(0.08 * specular, 0, 0.9))
    return float((1 + root) / (1 - root))


def coated(colour, roughness, eta, bend=None):
    """Returns the material of Blender's diffuse base under a coat.

    roughness: a value, the fourth power of Blender's. Where the coat is so rough that no base
    could be as bright as Blender's, it has no highlight to speak of, and is left out.
    """
    seen = coats.seen_base(round(float(np.sqrt(number(roughness))), 3), round(eta, 4))
    if np.max(colour.mean()) > seen:
        return Plain("diffuse", {"reflectance": colour}, bend=bend)
    base = combine(lambda c: np.clip(c / seen, 0, 1), [colour])
    return Plain("coateddiffuse", {"reflectance": base},
                 {"roughness": roughness, "eta": eta, "compensated": True}, bend)
