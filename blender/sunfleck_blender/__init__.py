"""Sunfleck as a render engine of Blender: caustics by photons, in the window where one works.

The modules that do not need Blender can be imported without it.
"""

bl_info = {
    "name": "Sunfleck",
    "description": "Renders caustics with Sunfleck, a photon-mapping renderer",
    "author": "Sunfleck",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "Properties > Render > Render Engine",
    "warning": "Tested with Blender 3.4; the names of 4.x are known, but untested",
    "category": "Render",
}


def register():
    from . import engine, properties, ui
    for module in (properties, engine, ui):
        module.register()


def unregister():
    from . import engine, properties, ui
    for module in (ui, engine, properties):
        module.unregister()
