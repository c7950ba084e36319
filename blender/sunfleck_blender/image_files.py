"""Blender's images as files that the scene can name, and as arrays of pixels."""

import os
import shutil

import numpy as np

from . import picture_files
from .values import LUMA, Flat, Picture

MAGIC = ((b"\x89PNG", ".png"), (b"\xff\xd8\xff", ".jpg"), (b"v/1\x01", ".exr"), (b"#?", ".hdr"))
LINEAR = ("Non-Color", "Raw", "Linear", "Linear Rec.709")


def file_ending(start):
    """Returns the ending of a picture file by its first bytes, or None if it is not known."""
    return next((ending for magic, ending in MAGIC if start.startswith(magic)), None)


def direct_encoding(ending, space):
    """Returns the scene language's encoding if such a file reads as Blender has it, else None."""
    if ending == ".png":
        return "sRGB" if space == "sRGB" else "linear" if space in ("Non-Color", "Raw") else None
    if ending == ".jpg":
        return "sRGB" if space == "sRGB" else None
    return "linear" if ending and space in LINEAR else None


class ImageFiles:
    """Writes the pictures of a scene into its folder, each once.

    resolve: returns the absolute path of an image's file (bpy.path.abspath, with its library).
    """

    def __init__(self, folder, resolve):
        self.folder = folder
        self.resolve = resolve
        self._names = {}
        self._arrays = {}

    def picture(self, image, alpha, coordinates, wrap, filtered, missing):
        """Returns a Picture of an image or of its alpha, or None if it has no pixels."""
        if image.source in ("SEQUENCE", "MOVIE", "TILED"):
            missing(f'image "{image.name}" of the kind {image.source.lower()} is not read')
            return None
        if not image.has_data and image.size[0] == 0:
            missing(f'image "{image.name}" is missing: magenta counts, as in Blender')
            return None
        space = image.colorspace_settings.name
        if space not in LINEAR + ("sRGB",):
            missing(f'colour space "{space}" of image "{image.name}": sRGB is used')
        if alpha and image.channels < 4:
            return Flat((1.0, 1.0, 1.0))
        key = (image.name_full, alpha)
        direct = None if alpha else self._as_it_stands(image, space)
        return Picture(lambda: self._pixels(image, alpha, key), coordinates, wrap, filtered,
                       direct and (image.name_full, direct), image.is_float)

    def file_of(self, picture, grey):
        """Returns (file name in the folder, encoding) of a picture; grey: one number a texel."""
        if picture.file and not grey:
            name, encoding = picture.file
            return self._names[name], encoding
        pixels = picture.pixels()
        if grey:
            pixels = np.repeat((pixels @ LUMA)[..., None], 3, axis=-1)
        name = f"textures/{len(os.listdir(self._textures())):04d}"
        small = not picture.bright and pixels.min() >= 0 and pixels.max() <= 1
        if small and grey:
            picture_files.write_png(self._path(name + ".png"),
                                    picture_files.to_bytes(pixels[..., 0]))
            return name + ".png", "linear"
        if small:
            encoded = picture_files.to_bytes(picture_files.to_srgb(pixels))
            picture_files.write_png(self._path(name + ".png"), encoded)
            return name + ".png", "sRGB"
        picture_files.write_pfm(self._path(name + ".pfm"), pixels)
        return name + ".pfm", "linear"

    def linear_pixels(self, image):
        """Returns the linear H x W x 3 pixels of an image, first row on top."""
        return self._pixels(image, False, (image.name_full, False))

    def _as_it_stands(self, image, space):
        """Copies an image's file and returns its encoding, or None where it must be rewritten."""
        if image.source != "FILE" or image.is_dirty:
            return None
        packed = image.packed_file
        path = self.resolve(image)
        if packed is None and not os.path.isfile(path):
            return None
        if packed is not None:
            start = bytes(packed.data[:8])
        else:
            with open(path, "rb") as file:
                start = file.read(8)
        ending = file_ending(start)
        encoding = direct_encoding(ending, space)
        if encoding is None or image.name_full in self._names:
            return encoding
        name = f"textures/{len(os.listdir(self._textures())):04d}{ending}"
        if packed is not None:
            with open(self._path(name), "wb") as file:
                file.write(packed.data)
        else:
            shutil.copyfile(path, self._path(name))
        self._names[image.name_full] = name
        return encoding

    def _pixels(self, image, alpha, key):
        if key not in self._arrays:
            width, height = image.size
            flat = np.empty(width * height * image.channels, np.float32)
            image.pixels.foreach_get(flat)
            pixels = flat.reshape(height, width, image.channels)[::-1]
            if alpha:
                pixels = np.repeat(pixels[..., 3:4], 3, axis=-1)
            else:
                pixels = (pixels[..., :3] if image.channels >= 3
                          else np.repeat(pixels[..., :1], 3, axis=-1))
                if not image.is_float and image.colorspace_settings.name not in LINEAR:
                    pixels = picture_files.from_srgb(pixels).astype(np.float32)
            self._arrays[key] = np.ascontiguousarray(pixels)
        return self._arrays[key]

    def _textures(self):
        folder = os.path.join(self.folder, "textures")
        os.makedirs(folder, exist_ok=True)
        return folder

    def _path(self, name):
        self._textures()
        return os.path.join(self.folder, name)

    def pfm_of(self, picture):
        """Returns the name of a PFM file of a picture."""
        name = f"textures/{len(os.listdir(self._textures())):04d}.pfm"
        picture_files.write_pfm(self._path(name), picture.pixels())
        return name

    def linear_file(self, picture, file, encoding):
        """Returns a file of a picture that is read as linear without being told so."""
        return file if encoding == "linear" else self.pfm_of(picture)
