"""Materials by name: indices that vary with the wavelength, in place of a shader's one number."""

import numpy as np

# key: (label, what, word of the materials that it applies to)
NAMES = (
    ("NONE", "By Nodes", "Index and colour of the shader nodes", None),
    ("glass-BK7", "Glass BK7", "Crown glass, 1.517", "dielectric"),
    ("glass-BAF10", "Glass BAF10", "Barium flint, 1.670", "dielectric"),
    ("glass-FK51A", "Glass FK51A", "Low dispersion, 1.487", "dielectric"),
    ("glass-LASF9", "Glass LASF9", "High index, 1.850", "dielectric"),
    ("glass-F5", "Glass SF5", "Flint, 1.673", "dielectric"),
    ("glass-F10", "Glass SF10", "Dense flint, 1.728", "dielectric"),
    ("glass-F11", "Glass SF11", "Dense flint, 1.785", "dielectric"),
    ("diamond", "Diamond", "2.418 (Peter 1923)", "dielectric"),
    ("metal-Ag", "Silver", "By wavelength", "conductor"),
    ("metal-Au", "Gold", "By wavelength", "conductor"),
    ("metal-Cu", "Copper", "By wavelength", "conductor"),
    ("metal-Al", "Aluminium", "By wavelength", "conductor"),
    ("metal-CuZn", "Brass", "By wavelength", "conductor"),
)
WORDS = {key: word for key, _, _, word in NAMES}


def diamond():
    """Returns wavelengths in nm and indices of diamond, one after the other."""
    nm = np.arange(360.0, 831.0, 10.0)
    squared = (nm / 1000) ** 2
    index = np.sqrt(1 + 0.3306 * squared / (squared - 0.1750 ** 2)
                    + 4.3356 * squared / (squared - 0.1060 ** 2))
    return np.stack([nm, index], axis=1).ravel()


def with_name(word, spectra, numbers, name):
    """Returns (spectra, numbers) of a material whose index is that of a name.

    word: dielectric or conductor; a name of the other kind changes nothing.
    """
    if name == "NONE" or WORDS[name] != word:
        return spectra, numbers
    if word == "dielectric":
        index = diamond() if name == "diamond" else name
        return spectra, numbers | {"eta": index}
    return {}, numbers | {"eta": name + "-eta", "k": name + "-k"}
