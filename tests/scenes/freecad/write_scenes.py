#!/usr/bin/env python3
"""Writes three scenes in the form in which FreeCAD's Render workbench hands them to a pbrt.

Usage: write_scenes.py FOLDER [WIDTH HEIGHT]

That form (FreeCAD/FreeCAD-render, its pbrt plug-in and templates, April 2025): the camera first,
in a frame that is mirrored; sampler, integrator, colour space and film of a template; then one
block for each object and light, in no order, with metres as the unit and z up. Each object is an
ASCII PLY in a folder of its own, named DOCUMENT#OBJECT. The file of an image light is absolute.

| scene   | objects and their materials                            | light                        |
|---------|--------------------------------------------------------|------------------------------|
| bracket | steel (Substance_PBR), brass bolt (words of a material | a point light                |
|         | card), washer without a material of its own (Mixed)    |                              |
| lens    | a lens (Glass) in a ring (Diffuse)                     | sun and sky, a distant light |
| knob    | a painted knob (Carpaint), a plate with a picture for  | an image light, of latitude  |
|         | colour and roughness and one for bumps (Substance_PBR) | and longitude, an area light |
"""

import math
import sys
from pathlib import Path

from parts import angle_bar, lens_profile, sheet, turned, write_sky, write_tiles


def numbers(values):
    return " ".join(f"{v:+15.8f}" for v in values)


def placed(name, mesh_file, material, at=(0, 0, 0), yaw=0, pitch=0, roll=0):
    """The block of an object."""
    return f"""# Object '{name}'
AttributeBegin

  Translate {numbers(at)}
  Rotate    {yaw:+15.8f}  0 0 1
  Rotate    {pitch:+15.8f}  0 1 0
  Rotate    {roll:+15.8f}  1 0 0
  Scale     {numbers((1, 1, 1))}

{material}
  Shape "plymesh"
    "string filename" [ "{mesh_file}" ]
AttributeEnd
# ~Object '{name}'
"""


def diffuse(colour):
    return f"""  Material "diffuse"
    "rgb reflectance" [{colour}]
"""


def mixed(name, first, second, amount):
    """A mix of two named materials, each of them the lines after its name."""
    return f"""  MakeNamedMaterial "{name}_diffuse"
    "string type" "diffuse"
    {first}
  MakeNamedMaterial "{name}_second"
    {second}
  Material "mix"
    "string materials" ["{name}_diffuse" "{name}_second"]
    "float amount" {amount}
"""


def metallic(name, colour, roughness, metal, bumps=""):
    """A Substance_PBR material."""
    return mixed(name, f"{colour}\n    # {roughness}\n    {bumps}",
                 f'"string type" "conductor"\n    {colour}\n    {roughness}\n    {bumps}', metal)


def camera(position, target, fov):
    """The mirror that turns FreeCAD's right-handed view to pbrt's; up is scaled to metres, too."""
    look = [t - p for p, t in zip(position, target)]
    length = math.hypot(*look)
    look = [v / length for v in look]
    flat = math.hypot(look[0], look[1])
    up = (-look[0] * look[2] / flat, -look[1] * look[2] / flat, flat)
    return f"""# Camera 'Camera'
Scale -1 1 1
LookAt {numbers(position)}
       {numbers(p + 0.001 * v for p, v in zip(position, look))}
       {numbers(0.001 * v for v in up)}
Camera "perspective" "float fov" {fov:+.5f}
# ~Camera 'Camera'
"""


def scene(folder, name, view, blocks, meshes, size):
    """Writes the scene and its meshes."""
    (folder / name).mkdir(parents=True, exist_ok=True)
    for mesh_name, mesh in meshes.items():
        mesh.write(folder / name / f"{mesh_name}.ply")
    text = f"""{view}

Sampler "halton" "integer pixelsamples" [32]
Integrator "path" "integer maxdepth" [6]
ColorSpace "srgb"
Film "rgb"
  "integer xresolution" [{size[0]}]
  "integer yresolution" [{size[1]}]

WorldBegin

""" + "\n".join(blocks)
    (folder / f"{name}.pbrt").write_text(text, encoding="utf-8")


def bracket(folder, size):
    light = """# Pointlight 'Bracket#PointLight'
AttributeBegin
  LightSource "point"
    "rgb I" [1.0 0.9 0.8]
    "point3 from" [0.15 -0.2 0.3]
    "float scale" [60.0]
AttributeEnd
# ~Pointlight 'Bracket#PointLight'
"""
    brass = """Material "conductor"
"spectrum eta" [ "metal-CuZn-eta" ]
"spectrum k" [ "metal-CuZn-k" ]
"float roughness" [ 0.01 ]
"""
    steel = metallic("Bracket#Bar", '"rgb reflectance" [0.45626346 0.45626346 0.48543545]',
                     '"float roughness" 0.3', 1.0)
    half_glass = mixed("Bracket#Washer", '"rgb reflectance" [0.2 0.4 0.7]',
                       '"string type" "dielectric"\n"float eta" 1.5', 0.5)
    bolt = [(0.0, -0.01), (0.005, -0.01), (0.005, 0.0), (0.009, 0.0), (0.009, 0.005),
            (0.007, 0.007), (0.0, 0.007)]
    washer = [(0.006, 0.0), (0.014, 0.0), (0.014, 0.002), (0.006, 0.002), (0.006, 0.0)]
    scene(folder, "bracket", camera((0.22, -0.2, 0.16), (0.035, 0.03, 0.02), 36), [
        light,
        placed("__ground_plane__", "bracket/__ground_plane__.ply", diffuse("0.8 0.8 0.8")),
        placed("Bracket#Bar", "bracket/Bracket#Bar.ply", steel, yaw=20),
        placed("Bracket#Washer", "bracket/Bracket#Washer.ply", half_glass, (0.03, 0.046, 0.01)),
        placed("Bracket#Bolt", "bracket/Bracket#Bolt.ply", brass, (0.03, 0.046, 0.012)),
    ], {"__ground_plane__": sheet(0.2), "Bracket#Bar": angle_bar(0.07, 0.01, 0.06),
        "Bracket#Washer": turned(washer, 32), "Bracket#Bolt": turned(bolt, 32)}, size)


def lens_in_the_sun(folder, size):
    light = """# Sun-sky light 'Lens#SunskyLight'
AttributeBegin
  LightSource "infinite"
    "rgb L" [0.18 0.28 0.75]
    "float scale" 1.5
  LightSource "distant"
    "blackbody L" [6500]
    "float scale" 4.0
    "point3 from" [0 0 0]
    "point3 to" [1.0 0.25 -0.6]
AttributeEnd
# ~Sun-sky light 'Lens#SunskyLight'
# Distant light 'Lens#DistantLight'
AttributeBegin
  LightSource "distant"
    "rgb L" [1.0 0.6 0.3]
    "float scale" 0.5
    "point3 from" [0 0 0]
    "point3 to" [-1.0 1.0 -1.0]
AttributeEnd
# ~Distant light 'Lens#DistantLight'
"""
    glass = """  Material "dielectric"
    "float eta" 1.5
"""
    ring = [(0.0405, -0.006), (0.046, -0.006), (0.046, 0.006), (0.0405, 0.006), (0.0405, -0.006)]
    scene(folder, "lens", camera((0.12, -0.32, 0.16), (0.04, 0.01, 0.025), 28), [
        placed("Lens#Glass", "lens/Lens#Glass.ply", glass, (0, 0, 0.046), pitch=90),
        light,
        placed("Lens#Ring", "lens/Lens#Ring.ply", diffuse("0.6 0.05 0.03"), (0, 0, 0.046),
               pitch=90),
        placed("__ground_plane__", "lens/__ground_plane__.ply", diffuse("0.8 0.8 0.8")),
    ], {"__ground_plane__": sheet(0.4), "Lens#Glass": turned(lens_profile(0.04, 0.08, 24), 96),
        "Lens#Ring": turned(ring, 96)}, size)


def texture(name, kind, file, encoding):
    return f"""  Texture "{name}" "{kind}" "imagemap"
    "string filename" "{file}"
    "string mapping" "uv"
    "string encoding" "{encoding}"
"""


def knob(folder, size):
    quote = str((folder / "sky.hdr").resolve()).replace("\\", "\\\\").replace("'", "\\'")
    light = f"""# Imagelight 'Knob#ImageLight'
AttributeBegin
    LightSource "infinite" "string filename" "{quote}"
AttributeEnd
# ~Imagelight 'Knob#ImageLight'
# Arealight 'Knob#AreaLight'
AttributeBegin
  AreaLightSource "diffuse"
    "rgb L" [1.0 0.8 0.6]
    "bool twosided" true
    "float scale" [20.0]
  Shape "trianglemesh"
    "integer indices" [0 1 2  0 2 3]
    "point3 P" [
                  -0.03              -0.1               0.2                  +0.01              -0.1               0.2
                  +0.01              -0.08              0.22                 -0.03              -0.08              0.22
    ]
AttributeEnd
# ~Arealight 'Knob#AreaLight'
"""
    paint = """  Material "coateddiffuse"
"rgb reflectance" [0.65 0.02 0.02]
    "float roughness" [ 0.0 ]
    "float eta" [ 1.54 ]
"""
    textures = (texture("Plate_colour_tex", "spectrum", "tiles.png", "sRGB") +
                texture("Plate_roughness_tex", "float", "tiles.png", "linear") +
                texture("Plate_bump_tex_unscaled", "float", "tiles.png", "linear") +
                """  Texture "Plate_bump_tex" "float" "scale"
    "texture tex" "Plate_bump_tex_unscaled"
    "float scale" 2.0
""")
    plate = textures + metallic("Knob#Plate", '"texture reflectance" "Plate_colour_tex"',
                                '"texture roughness" "Plate_roughness_tex"', 0.3,
                                '"texture displacement" "Plate_bump_tex"')
    profile = [(0.0, 0.0), (0.03, 0.0), (0.03, 0.004)]
    profile += [(0.018 + 0.012 * math.cos(a), 0.004 + 0.05 * a / math.pi)
                for a in (math.pi / 2 * i / 8 for i in range(1, 9))]
    profile += [(0.022 * math.cos(a), 0.05 + 0.022 * math.sin(a))
                for a in (math.pi / 2 * i / 12 for i in range(-5, 13))]
    profile[-1] = (0.0, profile[-1][1])
    scene(folder, "knob", camera((0.14, -0.2, 0.13), (0.0, 0.0, 0.03), 32), [
        placed("Knob#Knob", "knob/Knob#Knob.ply", paint),
        placed("Knob#Plate", "knob/Knob#Plate.ply", plate),
        light,
    ], {"Knob#Knob": turned(profile, 48), "Knob#Plate": sheet(0.1, has_uv=True)}, size)


def main(folder, width="320", height="240"):
    folder, size = Path(folder), (int(width), int(height))
    folder.mkdir(parents=True, exist_ok=True)
    write_tiles(folder / "tiles.png")
    write_sky(folder / "sky.hdr")
    for write in (bracket, lens_in_the_sun, knob):
        write(folder, size)


if __name__ == "__main__":
    main(*sys.argv[1:])
