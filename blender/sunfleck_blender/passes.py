"""Puts the program's pictures into Blender's render result."""

import numpy as np

from .picture_files import read_exr

# AOV: (its EXR channels, Blender's letters for them, Blender's kind)
KINDS = {
    "normal": (("normal.X", "normal.Y", "normal.Z"), "XYZ", "VECTOR"),
    "depth": (("depth.Z",), "Z", "VALUE"),
    "samples": (("samples.N",), "X", "VALUE"),
}


FAR = 1e10  # Blender's depth where there is nothing


def pass_list(aovs):
    """Returns [(name, letters, kind, EXR channels)] of the passes of some AOVs.

    Blender has passes of its own called Normal and Depth; ours take their places.
    """
    found = []
    for name in aovs:
        channels, letters, kind = KINDS.get(name, (_colours(name), "RGB", "COLOR"))
        found.append((name.capitalize(), letters, kind, channels))
    return found


def group_passes(names):
    """Returns the same for light groups."""
    return [(name, "RGB", "COLOR", _colours(name)) for name in names]


def _colours(name):
    return tuple(f"{name}.{letter}" for letter in "RGB")


def rows_of(picture, channels, opaque=False):
    """Returns N x C floats as Blender wants them: the lowest row first; opaque adds an alpha."""
    planes = [picture[name] for name in channels]
    if opaque:
        planes.append(np.ones_like(planes[0]))
    return np.ascontiguousarray(np.stack(planes, axis=-1)[::-1].reshape(-1, len(planes)),
                                np.float32)


def show(engine, path, size, layer, extra):
    """Fills the result of a render from an EXR. extra: passes beside the picture."""
    picture = read_exr(path)
    result = engine.begin_result(0, 0, size[0], size[1], layer=layer)
    if result is None or not result.layers:
        return
    passes = result.layers[0].passes
    _fill(passes, "Combined", rows_of(picture, "RGB", opaque=True))
    for name, _, _, channels in extra:
        if all(channel in picture for channel in channels):
            rows = rows_of(picture, channels)
            _fill(passes, name, np.where(rows > 0, rows, FAR) if name == "Depth" else rows)
    engine.end_result(result)


def _fill(passes, name, rows):
    target = next((p for p in passes if p.name == name), None)
    if target is None:
        return
    try:
        # Blender counts pixels, not numbers, and then takes the whole buffer.
        target.rect.foreach_set(np.ascontiguousarray(rows, np.float32))
    except TypeError:
        target.rect = rows.tolist()
