"""The four example scenes of docs/guide/blender.md; runs inside Blender.

Objects of glass have the custom property "glass", so that they can be hidden.
"""

import math

import bpy

from shapes import (box, camera, checked_image, curve, diffuse, glass, lathe, light, material, mesh,
                    new_scene, placed, plane, textured, world)


def of_glass(thing):
    thing["glass"] = True
    return thing


def wine_glass():
    """A glass of red wine on a checked cloth in the sun."""
    new_scene()
    placed("Table", plane("Table", 0.6, 0.6), textured("Cloth", checked_image()))
    outside = curve([(0, 0), (0.034, 0.0), (0.036, 0.002), (0.012, 0.006), (0.0045, 0.02),
                     (0.004, 0.07), (0.012, 0.083), (0.034, 0.105), (0.0405, 0.135),
                     (0.037, 0.17), (0.0325, 0.2)])
    inside = curve([(0.0312, 0.2), (0.0356, 0.17), (0.039, 0.135), (0.0325, 0.106),
                    (0.012, 0.088), (0, 0.085)])
    cup = of_glass(placed("Glass", lathe("Glass", outside + inside), glass("Glass"),
                          location=(0, 0, 0.0005)))
    # The wine's surface lies .3 mm within the glass, with air between, as people model it.
    level = 0.138
    wall = [(max(r - 0.0003, 0), h + 0.0003) for r, h in reversed(inside) if h < level]
    wine = lathe("Wine", wall + [(wall[-1][0], level), (0, level)])
    of_glass(placed("Wine", wine, glass("Wine", 1.35, ((0.85, 0.1, 0.15), 60.0)),
                    location=cup.location))
    light("SUN", (-0.7, 0.6, 0.9), (0, 0, 0), 5.0, angle=math.radians(0.53))
    world(0.25, 0.3, 0.4)
    camera((0.1, -0.66, 0.36), (0.035, -0.01, 0.085), 46)


def gem():
    """Returns a closed cut stone: table, crown, girdle, pavilion."""
    sides = 8
    rings = [(0.53, 0.16), (1.0, 0.0), (1.0, -0.03), (0.0, -0.45)]
    profile = [(0.0, rings[0][1])] + rings
    return lathe("Gem", [(0.01 * r, 0.01 * h) for r, h in reversed(profile)], sides, smooth=False)


def jewels():
    """A gold ring, a gem and a glass figure under an area light."""
    new_scene()
    placed("Table", plane("Table", 0.3, 0.3), diffuse("Paper", 0.75, 0.72, 0.68))
    bpy.ops.mesh.primitive_torus_add(major_radius=0.011, minor_radius=0.0016, major_segments=96,
                                     minor_segments=24, location=(-0.02, -0.005, 0.0016))
    ring = bpy.context.object
    ring.name = "Ring"
    ring.data.polygons.foreach_set("use_smooth", [True] * len(ring.data.polygons))
    ring.data.materials.append(material("Gold", "ShaderNodeBsdfPrincipled", Metallic=1.0,
                                        Base_Color=(1.0, 0.77, 0.34, 1), Roughness=0.15))
    ring["caustic"] = True
    of_glass(placed("Gem", gem(), glass("Diamond", 2.417), location=(0.008, -0.015, 0.0046)))
    pawn = curve([(0, 0), (0.0085, 0), (0.009, 0.002), (0.006, 0.005), (0.0035, 0.012),
                  (0.0045, 0.0165), (0.0028, 0.0175), (0.0048, 0.021), (0.0035, 0.0255),
                  (0, 0.0265)])
    of_glass(placed("Figure", lathe("Figure", pawn), glass("Crystal", 1.52),
                    location=(0.022, 0.01, 0.0002)))
    light("AREA", (-0.12, 0.12, 0.2), (0, 0, 0), 0.6, shape="RECTANGLE", size=0.02, size_y=0.03)
    world(0.08, 0.09, 0.1)
    camera((0.0, -0.14, 0.085), (0.002, -0.002, 0.004), 60)


def sunlit_room():
    """A room with a pane of glass in its window, and a sun outside."""
    new_scene()
    white = diffuse("Walls", 0.7, 0.7, 0.68)
    floor = diffuse("Floor", 0.5, 0.38, 0.28)
    x, y, z, wall = 1.6, 1.6, 2.4, 0.15
    placed("Floor", box("Floor", (-x, -y, -wall), (x, y, 0)), floor)
    placed("Ceiling", box("Ceiling", (-x, -y, z), (x, y, z + wall)), white)
    placed("Back", box("Back", (-x - wall, y, 0), (x + wall, y + wall, z)), white)
    placed("Front", box("Front", (-x - wall, -y - wall, 0), (x + wall, -y, z)), white)
    placed("Right", box("Right", (x, -y, 0), (x + wall, y, z)), diffuse("Red", 0.6, 0.25, 0.2))
    # The left wall has a window.
    for name, low, high in (("Below", (-y, 0.0), (y, 0.8)), ("Above", (-y, 2.0), (y, z)),
                            ("Beside 1", (-y, 0.8), (-0.3, 2.0)),
                            ("Beside 2", (1.0, 0.8), (y, 2.0))):
        placed(f"Left {name}", box(name, (-x - wall, *low), (-x, *high)), white)
    of_glass(placed("Pane", box("Pane", (-x - 0.08, -0.3, 0.8), (-x - 0.07, 1.0, 2.0)),
                    glass("Window", 1.52)))
    placed("Stool", box("Stool", (-0.25, 0.2, 0), (0.25, 0.7, 0.45)),
           diffuse("Wood", 0.45, 0.3, 0.15))
    ball = lathe("Ball", [(0.16 * math.sin(math.pi * i / 48), -0.16 * math.cos(math.pi * i / 48))
                          if 0 < i < 48 else (0, -0.16 if i == 0 else 0.16) for i in range(49)])
    of_glass(placed("Ball", ball, glass("Crystal", 1.52), location=(0, 0.45, 0.612)))
    light("SUN", (-4.0, -0.3, 3.8), (0, 0.5, 0.3), 12.0, angle=math.radians(0.53))
    world(0.6, 0.75, 1.0)
    camera((0.9, -1.45, 1.35), (-0.2, 0.6, 0.75), 22)


def bottle_and_mirror():
    """A green bottle and a concave mirror under a spot."""
    new_scene()
    placed("Table", plane("Table", 1.5, 1.5), diffuse("Table", 0.6, 0.58, 0.55))
    outside = curve([(0, 0), (0.034, 0.0), (0.037, 0.004), (0.037, 0.13), (0.034, 0.16),
                     (0.016, 0.2), (0.0145, 0.26), (0.0155, 0.262), (0.0155, 0.275)])
    inside = curve([(0.0105, 0.275), (0.0105, 0.2), (0.029, 0.16), (0.0335, 0.13),
                    (0.0335, 0.01), (0.02, 0.012), (0, 0.016)])
    of_glass(placed("Bottle", lathe("Bottle", outside + inside),
                    glass("Green", 1.52, ((0.25, 0.75, 0.3), 80.0)), location=(-0.07, 0.0, 0.0005)))
    radius, rim = 0.25, 0.09
    front = [(rim * i / 24, radius - math.sqrt(radius ** 2 - (rim * i / 24) ** 2))
             for i in range(25)]
    back = [(r, h - 0.004) for r, h in front]
    mirror = placed("Mirror", lathe("Mirror", back + list(reversed(front))),
                    material("Silver", "ShaderNodeBsdfPrincipled", Metallic=1.0,
                             Base_Color=(0.95, 0.95, 0.95, 1), Roughness=0.0),
                    location=(0.16, 0.09, 0.092))
    # It throws the spot's light on the table before it, near its focus.
    mirror.rotation_euler = (math.radians(91.4), 0, math.radians(-32.7))
    mirror["caustic"] = True
    light("SPOT", (-0.35, -0.75, 0.75), (0.02, 0.03, 0.06), 20.0, spot_size=math.radians(38),
          spot_blend=0.3, shadow_soft_size=0.0)
    world(0.05, 0.05, 0.06)
    camera((0.02, -0.78, 0.42), (0.03, 0.02, 0.09), 50)


SCENES = {"wine-glass": wine_glass, "jewels": jewels, "sunlit-room": sunlit_room,
          "bottle-and-mirror": bottle_and_mirror}


def hide_caustics(hidden=True):
    """Hides what casts caustics, or shows it again: what is left meets no glass and no mirror."""
    for thing in bpy.context.scene.objects:
        if "glass" in thing or "caustic" in thing:
            thing.hide_render = hidden
