#!/usr/bin/env python3
"""Reads a matte from an .exr by itself and compares it with a mask.

read_matte.py PICTURE MATTE NAME MASK prints the mean of |matte - mask| over all pixels, where the
matte is that of an object by its name, by the manifest of the matte "CryptoObject", and the mask is
the channel R of another .exr. It knows nothing of Sunfleck's code: files of scan lines, stored or
compressed by zip, are read here, and the hash of each name of the manifest is computed again.
"""
import json
import struct
import sys
import zlib

ROWS_OF = {0: 1, 2: 1, 3: 16}  # rows of a block, by the number of the compression


def text_at(data, at):
    end = data.index(0, at)
    return data[at:end], end + 1


def header_of(data):
    """Attributes by name, and where the header ends."""
    assert data[:4] == b"v/1\x01", "no .exr"
    attributes = {}
    at = 8
    while data[at]:
        name, at = text_at(data, at)
        _, at = text_at(data, at)
        (size,) = struct.unpack_from("<i", data, at)
        attributes[name.decode()] = data[at + 4:at + 4 + size]
        at += 4 + size
    return attributes, at + 1


def channels_of(listed):
    """Names in order; all must be 32-bit floats (type 2) or halves (1)."""
    channels = []
    at = 0
    while listed[at]:
        name, at = text_at(listed, at)
        (kind,) = struct.unpack_from("<i", listed, at)
        channels.append((name.decode(), kind))
        at += 16
    return channels


def unpacked(block, size):
    """Undoes EXR's zip: deflate, then differences of bytes, then two interleaved halves."""
    if len(block) == size:
        return block
    raw = bytearray(zlib.decompress(block))
    for i in range(1, len(raw)):
        raw[i] = (raw[i - 1] + raw[i] - 128) & 255
    half = (len(raw) + 1) // 2
    result = bytearray(len(raw))
    result[0::2] = raw[:half]
    result[1::2] = raw[half:]
    return bytes(result)


def read_exr(path):
    with open(path, "rb") as file:
        data = file.read()
    attributes, at = header_of(data)
    compression = attributes["compression"][0]
    x0, y0, x1, y1 = struct.unpack("<4i", attributes["dataWindow"])
    width, height = x1 - x0 + 1, y1 - y0 + 1
    channels = channels_of(attributes["channels"])
    row_size = sum((4 if kind == 2 else 2) * width for _, kind in channels)
    rows = ROWS_OF[compression]
    pixels = {name: [0.0] * (width * height) for name, _ in channels}
    kinds = dict(channels)
    for block in range((height + rows - 1) // rows):
        (begin,) = struct.unpack_from("<Q", data, at + 8 * block)
        y, size = struct.unpack_from("<2i", data, begin)
        count = min(rows, y1 + 1 - y)
        packed = data[begin + 8:begin + 8 + size]
        values = unpacked(packed, row_size * count) if compression else packed
        place = 0
        for row in range(y - y0, y - y0 + count):
            for name, kind in channels:
                form = "<%d%s" % (width, "f" if kind == 2 else "e")
                found = struct.unpack_from(form, values, place)
                pixels[name][row * width:(row + 1) * width] = found
                place += struct.calcsize(form)
    return attributes, kinds, pixels


def murmur3(data):
    def mixed(word):
        word = word * 0xcc9e2d51 & 0xffffffff
        return (word << 15 | word >> 17) * 0x1b873593 & 0xffffffff

    value = 0
    whole = len(data) // 4 * 4
    for (word,) in struct.iter_unpack("<I", data[:whole]):
        value ^= mixed(word)
        value = (value << 13 | value >> 19) & 0xffffffff
        value = value * 5 + 0xe6546b64 & 0xffffffff
    if whole < len(data):
        value ^= mixed(int.from_bytes(data[whole:], "little"))
    value ^= len(data)
    for shift, factor in ((16, 0x85ebca6b), (13, 0xc2b2ae35)):
        value = (value ^ value >> shift) * factor & 0xffffffff
    return value ^ value >> 16


def id_of(name):
    value = murmur3(name.encode())
    if value >> 23 & 255 in (0, 255):
        value ^= 1 << 23
    return struct.unpack("<f", struct.pack("<I", value))[0]


def manifest_of(attributes, matte):
    for name, value in attributes.items():
        if name.endswith("/name") and value.decode() == matte:
            key = name[:-len("name")]
            assert attributes[key + "hash"] == b"MurmurHash3_32"
            assert attributes[key + "conversion"] == b"uint32_to_float32"
            return json.loads(attributes[key + "manifest"].decode())
    sys.exit("no matte " + matte)


def matte_of(picture, matte, name):
    """Coverage of an object in each pixel."""
    attributes, kinds, pixels = picture
    manifest = manifest_of(attributes, matte)
    for known, digits in manifest.items():
        assert struct.pack(">f", id_of(known)).hex() == digits, known
    wanted = struct.unpack(">f", bytes.fromhex(manifest[name]))[0]
    coverage = [0.0] * len(pixels["R"])
    for rank in range(3):
        for one, share in ("RG", "BA"):
            ids = "%s%02d.%s" % (matte, rank, one)
            shares = "%s%02d.%s" % (matte, rank, share)
            assert kinds[ids] == kinds[shares] == 2, "no 32-bit floats"
            for i, found in enumerate(pixels[ids]):
                if found == wanted:
                    coverage[i] += pixels[shares][i]
    return coverage


def main():
    picture, matte, name, mask = sys.argv[1:]
    coverage = matte_of(read_exr(picture), matte, name)
    truth = read_exr(mask)[2]["R"]
    assert len(truth) == len(coverage)
    print(sum(abs(a - b) for a, b in zip(coverage, truth)) / len(truth))


main()
