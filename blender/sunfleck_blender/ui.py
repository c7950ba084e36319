"""Panels of the engine, and Blender's own that serve it, too."""

import bpy

ENGINE = "SUNFLECK"

# Panels of other engines whose settings are read.
SHARED = ("EEVEE_MATERIAL_PT_context_material", "EEVEE_MATERIAL_PT_surface",
          "EEVEE_MATERIAL_PT_volume", "EEVEE_WORLD_PT_surface", "DATA_PT_spot",
          "MATERIAL_PT_preview")
# Panels for any engine that would set what is not read.
LEFT_OUT = ("RENDER_PT_simplify", "RENDER_PT_gpencil", "VIEWLAYER_PT_freestyle",
            "RENDER_PT_freestyle", "VIEWLAYER_PT_layer_passes")


class Panel(bpy.types.Panel):
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "render"

    @classmethod
    def poll(cls, context):
        return context.engine == ENGINE


class SUNFLECK_PT_sampling(Panel):
    bl_label = "Sampling"

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        settings = context.scene.sunfleck
        for name in ("time", "target_error", "passes", "threads", "seed", "max_depth"):
            layout.prop(settings, name)
        if settings.time == settings.target_error == settings.passes == 0:
            layout.label(text="Without an end: 2% or ten minutes", icon="INFO")
        layout.prop(context.scene.render, "filter_size")


class SUNFLECK_PT_outputs(Panel):
    bl_label = "Passes"
    bl_context = "view_layer"

    def draw(self, context):
        layout = self.layout
        settings = context.scene.sunfleck
        layout.label(text="AOVs")
        layout.column(align=True).prop(settings, "aovs")
        layout.prop(settings, "light_groups")
        if settings.light_groups == "GROUPS":
            layer = context.view_layer
            row = layout.row()
            row.template_list("UI_UL_list", "sunfleck_lightgroups", layer, "lightgroups", layer,
                              "active_lightgroup_index", rows=3)
            buttons = row.column(align=True)
            buttons.operator("scene.view_layer_add_lightgroup", icon="ADD", text="")
            buttons.operator("scene.view_layer_remove_lightgroup", icon="REMOVE", text="")


class SUNFLECK_PT_scene(Panel):
    bl_label = "Sunfleck Scene"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        self.layout.prop(context.scene.sunfleck, "folder")


class SUNFLECK_PT_material(Panel):
    bl_label = "Sunfleck"
    bl_context = "material"

    @classmethod
    def poll(cls, context):
        return context.engine == ENGINE and context.material is not None

    def draw(self, context):
        self.layout.use_property_split = True
        self.layout.prop(context.material.sunfleck, "thin")
        self.layout.prop(context.material.sunfleck, "named")


class SUNFLECK_PT_light(Panel):
    bl_label = "Sunfleck"
    bl_context = "data"

    @classmethod
    def poll(cls, context):
        return context.engine == ENGINE and context.light is not None

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        light = context.light
        layout.prop(light, "color")
        layout.prop(light, "energy")
        if light.type in ("POINT", "SPOT"):
            layout.prop(light, "shadow_soft_size", text="Radius")
        if light.type == "SUN":
            layout.prop(light, "angle")
        if light.type in ("POINT", "AREA"):
            layout.prop(light.sunfleck, "seen")


class SUNFLECK_PT_object(Panel):
    bl_label = "Sunfleck"
    bl_context = "object"

    @classmethod
    def poll(cls, context):
        return context.engine == ENGINE and hasattr(context.object, "lightgroup")

    def draw(self, context):
        self.layout.prop_search(context.object, "lightgroup", context.view_layer, "lightgroups",
                                text="Light Group")


PANELS = (SUNFLECK_PT_sampling, SUNFLECK_PT_outputs, SUNFLECK_PT_scene, SUNFLECK_PT_material,
          SUNFLECK_PT_light, SUNFLECK_PT_object)


def shared_panels():
    """Returns Blender's panels that serve this engine, too."""
    for panel in bpy.types.Panel.__subclasses__():
        engines = getattr(panel, "COMPAT_ENGINES", ())
        general = "BLENDER_RENDER" in engines and panel.__name__ not in LEFT_OUT
        if engines and (general or panel.__name__ in SHARED):
            yield panel


def register():
    for panel in PANELS:
        bpy.utils.register_class(panel)
    for panel in shared_panels():
        panel.COMPAT_ENGINES.add(ENGINE)


def unregister():
    for panel in shared_panels():
        panel.COMPAT_ENGINES.discard(ENGINE)
    for panel in reversed(PANELS):
        bpy.utils.unregister_class(panel)
