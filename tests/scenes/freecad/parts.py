"""Meshes and pictures of the scenes."""

import math
import struct
import zlib


class Mesh:
    """Triangles with their normals, and texture coordinates where `has_uv`."""

    def __init__(self, has_uv=False):
        self.vertices, self.faces, self.has_uv = [], [], has_uv

    def polygon(self, points, normals, uvs=None):
        """A fan from the first point; one normal for all, or one for each."""
        first = len(self.vertices)
        normals = normals if isinstance(normals[0], tuple) else [normals] * len(points)
        uvs = uvs or [(0, 0)] * len(points)
        self.vertices += [p + n + (uv if self.has_uv else ())
                          for p, n, uv in zip(points, normals, uvs)]
        self.faces += [(first, first + i, first + i + 1) for i in range(1, len(points) - 1)]

    def write(self, path):
        names = "x y z nx ny nz".split() + (["s", "t"] if self.has_uv else [])
        lines = ["ply", "format ascii 1.0", f"comment '{path.stem}'",
                 f"element vertex {len(self.vertices)}", *(f"property float {n}" for n in names),
                 f"element face {len(self.faces)}", "property list uchar int vertex_indices",
                 "end_header", *(" ".join(f"{v:#g}" for v in vertex) + " "
                                 for vertex in self.vertices),
                 *("3 %d %d %d" % face for face in self.faces)]
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def turned(profile, steps):
    """A surface of revolution about z: `profile` lists (radius, z), outside on its right."""
    mesh = Mesh()
    def at(step, r, z):
        angle = 2 * math.pi * step / steps
        return (r * math.cos(angle), r * math.sin(angle), z)
    for (r0, z0), (r1, z1) in zip(profile, profile[1:]):
        length = math.hypot(r1 - r0, z1 - z0)
        out, up = (z1 - z0) / length, (r0 - r1) / length
        for i in range(steps):
            corners = [at(i, r0, z0), at(i + 1, r0, z0), at(i + 1, r1, z1), at(i, r1, z1)]
            normals = [at(j, out, up) for j in (i, i + 1, i + 1, i)]
            keep = [j for j, c in enumerate(corners) if c not in corners[:j]]
            mesh.polygon([corners[j] for j in keep], [normals[j] for j in keep])
    return mesh


def angle_bar(arm, thickness, width, steps=6):
    """An L of two arms with a fillet between them, along y."""
    fillet = [(thickness * (2 - math.sin(a)), thickness * (2 - math.cos(a)))
              for a in (math.pi / 2 * i / steps for i in range(steps + 1))]
    outline = [(0, 0), (arm, 0), (arm, thickness), *fillet, (thickness, arm), (0, arm)]
    outline = [p for i, p in enumerate(outline) if p not in outline[:i]]
    mesh = Mesh()
    mesh.polygon([(x, 0, z) for x, z in outline], (0.0, -1.0, 0.0))
    mesh.polygon([(x, width, z) for x, z in [outline[0]] + outline[:0:-1]], (0.0, 1.0, 0.0))
    for (x0, z0), (x1, z1) in zip(outline, outline[1:] + outline[:1]):
        length = math.hypot(x1 - x0, z1 - z0)
        mesh.polygon([(x0, 0, z0), (x0, width, z0), (x1, width, z1), (x1, 0, z1)][::-1],
                     ((z1 - z0) / length, 0.0, (x0 - x1) / length))
    return mesh


def sheet(half, z=0.0, has_uv=False):
    mesh = Mesh(has_uv)
    mesh.polygon([(-half, -half, z), (half, -half, z), (half, half, z), (-half, half, z)],
                 (0.0, 0.0, 1.0), [(0, 0), (1, 0), (1, 1), (0, 1)])
    return mesh


def lens_profile(radius, curvature, steps):
    """Two caps of a sphere, edge to edge, as a profile for `turned`."""
    depth = math.sqrt(curvature**2 - radius**2)
    end = math.asin(radius / curvature)
    cap = [(curvature * math.sin(a), depth - curvature * math.cos(a))
           for a in (end * i / steps for i in range(steps + 1))]
    cap[0], cap[-1] = (0.0, cap[0][1]), (radius, 0.0)
    return cap + [(r, -z) for r, z in cap[-2::-1]]


def write_tiles(path, side=128, tiles=8):
    """A PNG of tiles with darker joints."""
    def grey(x, y):
        tile = side // tiles
        joint = x % tile < 2 or y % tile < 2
        return 90 if joint else 170 + 40 * ((x // tile + y // tile) % 2)
    rows = b"".join(b"\0" + bytes(v for x in range(side) for v in (grey(x, y),) * 3)
                    for y in range(side))

    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8,
                                                                      2, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def write_sky(path, height=32):
    """A Radiance picture of latitude and longitude: a sky, a dark ground, one bright window."""
    def texel(x, y):
        if y >= height // 2:
            return (0.15, 0.13, 0.1)
        if abs(x - height // 2) < 3 and 6 <= y < 11:
            return (60.0, 55.0, 45.0)
        return tuple(c * (0.4 + y / height) for c in (0.5, 0.7, 1.0))

    def packed(colour):
        exponent = math.frexp(max(colour))[1]
        return bytes(int(c * 256 / 2.0**exponent) for c in colour) + bytes((exponent + 128,))
    texels = b"".join(packed(texel(x, y)) for y in range(height) for x in range(2 * height))
    path.write_bytes(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" %
                     (height, 2 * height) + texels)
