"""What a scene, a material and a light say to Sunfleck, and the add-on's preferences."""

import bpy

from .named import NAMES

AOVS = (
    ("direct", "Direct", "Light that comes straight from an emitter to what is seen"),
    ("caustic", "Caustic", "Light from an emitter by way of smooth glass or metal alone"),
    ("indirect", "Indirect", "Light that has met a rough surface before"),
    ("emission", "Emission", "Emitters seen by themselves, through glass or in mirrors"),
    ("albedo", "Albedo", "Share of white light reflected by the first surface"),
    ("normal", "Normal", "Shading normal of the first surface, in the world's frame"),
    ("depth", "Depth", "Distance to the first surface along the ray"),
    ("samples", "Samples", "Photons gathered, a pass"),
)


class SunfleckScene(bpy.types.PropertyGroup):
    """Settings of a render."""
    time: bpy.props.IntProperty(
        name="Time", subtype="TIME", default=60, min=0, soft_max=3600,
        description="Seconds after which the render ends, reading the scene not counted; "
                    "0 for no limit")
    target_error: bpy.props.FloatProperty(
        name="Target Error", subtype="PERCENTAGE", default=1.0, min=0, max=50, precision=2,
        description="The render ends when noise and bias of 95% of the blocks of 8 x 8 pixels "
                    "come to this; 0 for none")
    passes: bpy.props.IntProperty(
        name="Passes", default=0, min=0, soft_max=4096,
        description="The render ends after so many passes; 0 for no limit")
    threads: bpy.props.IntProperty(
        name="Threads", default=0, min=0, max=1024, description="0 for all processors")
    seed: bpy.props.IntProperty(
        name="Seed", default=0, min=0, description="Another seed, other noise")
    max_depth: bpy.props.IntProperty(
        name="Depth", default=64, min=1, max=1000,
        description="Scattering events on a path, camera and light together")
    aovs: bpy.props.EnumProperty(
        name="AOVs", items=AOVS, options={"ENUM_FLAG"}, default=set(),
        description="Further pictures, each a render pass")
    light_groups: bpy.props.EnumProperty(
        name="Light Groups", default="NONE",
        items=(("NONE", "None", "No pictures of single lights"),
               ("GROUPS", "Blender's", "A pass for each light group of the view layer"),
               ("EACH", "Each Light", "A pass for each light, 64 at most")))
    folder: bpy.props.StringProperty(
        name="Keep Scene", subtype="DIR_PATH",
        description="Folder in which the exported scene stays after the render; empty for none")


class SunfleckMaterial(bpy.types.PropertyGroup):
    """What Blender's nodes do not say of a material."""
    thin: bpy.props.BoolProperty(
        name="Thin Glass", default=False,
        description="The surface is a pane that does not bend light, such as a window made of one "
                    "face")
    named: bpy.props.EnumProperty(
        name="Index", items=[row[:3] for row in NAMES], default="NONE",
        description="Index by wavelength, for glass that parts light into colours, and for metals")


class SunfleckLight(bpy.types.PropertyGroup):
    """What Blender does not say of a light."""
    seen: bpy.props.BoolProperty(
        name="Seen", default=True,
        description="A light that has a size is seen by the camera, in mirrors and through glass")


class SunfleckPreferences(bpy.types.AddonPreferences):
    """Where the program is."""
    bl_idname = __package__

    program: bpy.props.StringProperty(
        name="Program", subtype="FILE_PATH",
        description="The program sunfleck; empty for the one on PATH")

    def draw(self, context):
        from .program import ProgramFault, find_program
        self.layout.prop(self, "program")
        try:
            self.layout.label(text=f"Used: {find_program(self.program)}", icon="CHECKMARK")
        except ProgramFault as fault:
            self.layout.label(text=str(fault), icon="ERROR")


CLASSES = (SunfleckScene, SunfleckMaterial, SunfleckLight, SunfleckPreferences)


def register():
    for one in CLASSES:
        bpy.utils.register_class(one)
    bpy.types.Scene.sunfleck = bpy.props.PointerProperty(type=SunfleckScene)
    bpy.types.Material.sunfleck = bpy.props.PointerProperty(type=SunfleckMaterial)
    bpy.types.Light.sunfleck = bpy.props.PointerProperty(type=SunfleckLight)


def unregister():
    del bpy.types.Light.sunfleck, bpy.types.Material.sunfleck, bpy.types.Scene.sunfleck
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
