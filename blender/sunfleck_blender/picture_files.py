"""Picture files without any library: PFM and PNG out, OpenEXR of 32-bit floats in."""

import struct
import zlib

import numpy as np


def write_pfm(path, pixels):
    """Writes H x W x 3 floats, the first row on top."""
    height, width = pixels.shape[:2]
    with open(path, "wb") as file:
        file.write(f"PF\n{width} {height}\n-1.0\n".encode("ascii"))
        file.write(np.ascontiguousarray(pixels[::-1], "<f4").tobytes())


def _chunk(kind, content):
    return (struct.pack(">I", len(content)) + kind + content
            + struct.pack(">I", zlib.crc32(kind + content)))


def write_png(path, pixels):
    """Writes H x W (grey) or H x W x 3 bytes, the first row on top."""
    height, width = pixels.shape[:2]
    colour = 0 if pixels.ndim == 2 else 2
    rows = np.zeros((height, 1 + width * (1 if colour == 0 else 3)), np.uint8)
    rows[:, 1:] = pixels.reshape(height, -1)
    header = struct.pack(">IIBBBBB", width, height, 8, colour, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + _chunk(b"IHDR", header)
                   + _chunk(b"IDAT", zlib.compress(rows.tobytes(), 1)) + _chunk(b"IEND", b""))


def to_srgb(linear):
    """Returns linear values in [0, 1] encoded as sRGB."""
    linear = np.clip(linear, 0, 1)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)


def from_srgb(encoded):
    """Returns sRGB values in linear light."""
    return np.where(encoded <= 0.04045, encoded / 12.92,
                    ((np.maximum(encoded, 0.04045) + 0.055) / 1.055) ** 2.4)


def to_bytes(values):
    """Returns values in [0, 1] as bytes."""
    return np.round(np.clip(values, 0, 1) * 255).astype(np.uint8)


def _header(data):
    """Returns {name: content} of the attributes of an EXR, and where they end."""
    if data[:4] != b"\x76\x2f\x31\x01":
        raise ValueError("not an OpenEXR file")
    position = 8
    attributes = {}
    while data[position] != 0:
        end = data.index(0, position)
        name = data[position:end].decode()
        kind_end = data.index(0, end + 1)
        size, = struct.unpack_from("<i", data, kind_end + 1)
        attributes[name] = data[kind_end + 5:kind_end + 5 + size]
        position = kind_end + 5 + size
    return attributes, position + 1


def _channels(content):
    position = 0
    while content[position] != 0:
        end = content.index(0, position)
        kind, = struct.unpack_from("<i", content, end + 1)
        yield content[position:end].decode(), kind
        position = end + 17


def _unpacked(block, size):
    """Returns the bytes of a ZIP block: the differences summed up, both halves interleaved."""
    if len(block) == size:
        return np.frombuffer(block, np.uint8)
    raw = np.frombuffer(zlib.decompress(block), np.uint8).astype(np.int64)
    raw[1:] -= 128
    summed = (np.cumsum(raw) & 255).astype(np.uint8)
    half = (len(summed) + 1) // 2
    result = np.empty_like(summed)
    result[0::2] = summed[:half]
    result[1::2] = summed[half:]
    return result


def read_exr(path):
    """Returns {channel: H x W floats}, first row on top, of an EXR as Sunfleck writes it."""
    with open(path, "rb") as file:
        data = file.read()
    attributes, position = _header(data)
    lines = {0: 1, 2: 1, 3: 16}.get(attributes["compression"][0])
    channels = list(_channels(attributes["channels"]))
    if lines is None or any(kind != 2 for _, kind in channels):
        raise ValueError("an OpenEXR file of another compression or of other numbers than floats")
    x0, y0, x1, y1 = struct.unpack("<4i", attributes["dataWindow"])
    width, height = x1 - x0 + 1, y1 - y0 + 1
    rows = np.empty((height, len(channels), width), np.float32)
    blocks = -(-height // lines)
    for offset in struct.unpack_from(f"<{blocks}Q", data, position):
        top, size = struct.unpack_from("<ii", data, offset)
        first = top - y0
        count = min(lines, height - first)
        raw = _unpacked(data[offset + 8:offset + 8 + size], count * len(channels) * width * 4)
        rows[first:first + count] = raw.view("<f4").reshape(count, len(channels), width)
    return {name: rows[:, index] for index, (name, _) in enumerate(channels)}
