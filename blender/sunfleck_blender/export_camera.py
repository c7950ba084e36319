"""Writes Blender's camera and picture size as statements of the scene language."""

import numpy as np

from .matrices import is_usable, matrix_of, turn_of
from .scene_text import SceneFault, columns


def picture_size(render):
    """Returns (width, height) of the whole picture in pixels."""
    share = render.resolution_percentage / 100
    return (max(int(render.resolution_x * share), 1), max(int(render.resolution_y * share), 1))


def region(render):
    """Returns (x0, x1, y0, y1) of the rendered pixels, y upwards, as Blender cuts them."""
    width, height = picture_size(render)
    if not render.use_border:
        return 0, width, 0, height
    x0, x1 = int(render.border_min_x * width), int(render.border_max_x * width)
    y0, y1 = int(render.border_min_y * height), int(render.border_max_y * height)
    return x0, max(x1, x0 + 1), y0, max(y1, y0 + 1)


def screen_window(sensor_fit, size, aspect, shift, half):
    """Returns (x0, x1, y0, y1) of the film on a plane at distance 1.

    sensor_fit: AUTO, HORIZONTAL or VERTICAL; size: pixels; aspect: of a pixel, x and y;
    shift: of the lens; half: half of the extent along the fitted side at distance 1.
    """
    x, y = size[0] * aspect[0], size[1] * aspect[1]
    if sensor_fit == "AUTO":
        sensor_fit = "HORIZONTAL" if x >= y else "VERTICAL"
    fitted = x if sensor_fit == "HORIZONTAL" else y
    across, up = half * x / fitted, half * y / fitted
    dx, dy = 2 * half * shift[0], 2 * half * shift[1]
    return dx - across, dx + across, dy - up, dy + up


def lens(data, matrix, missing):
    """Returns (radius, distance) of the lens, or None without depth of field."""
    if not data.dof.use_dof:
        return None
    distance = data.dof.focus_distance
    target = data.dof.focus_object
    if target is not None:
        way = matrix_of(target.matrix_world)[:3, 3] - matrix[:3, 3]
        distance = abs(float(way @ turn_of(matrix)[:, 2]))
    if data.dof.aperture_blades > 0 or data.dof.aperture_ratio != 1:
        missing("blades and ratio of the aperture: a circle is used")
    stop = max(data.dof.aperture_fstop, 1e-5)
    if data.type == "ORTHO":
        return 1 / (2 * stop), max(distance, 1e-5)
    return data.lens * 1e-3 / (2 * stop), max(distance, 1e-5)


def write_camera(text, scene, camera, file_name, warn):
    """Writes Camera and Film. camera: the evaluated camera object.

    Raises SceneFault where it cannot be rendered.
    """
    if camera is None:
        raise SceneFault("the scene has no camera: add one, and make it the scene's camera")
    if camera.type != "CAMERA":
        raise SceneFault(f'the scene\'s camera "{camera.name}" is no camera: choose one that is')
    data = camera.data

    def missing(what):
        warn(f'camera "{camera.name}": {what}')
    if data.type == "PANO":
        raise SceneFault(f'camera "{camera.name}" is panoramic, which is not read: make it '
                        "perspective or orthographic")
    render = scene.render
    size = picture_size(render)
    matrix = matrix_of(camera.matrix_world)
    if not is_usable(matrix):
        raise SceneFault(f'camera "{camera.name}" has no extent along an axis, or no place: mend '
                         "its scale")
    fit = data.sensor_fit
    width = data.sensor_height if fit == "VERTICAL" else data.sensor_width
    half = data.ortho_scale / 2 if data.type == "ORTHO" else width / (2 * data.lens)
    window = screen_window(fit, size, (render.pixel_aspect_x, render.pixel_aspect_y),
                           (data.shift_x, data.shift_y), half)
    text.about(f"camera {camera.name}")
    place = np.eye(4)
    place[:3, :3] = turn_of(matrix) @ np.diag([1.0, 1.0, -1.0])
    place[:3, 3] = matrix[:3, 3]
    text.say("Transform", rest=columns(np.linalg.inv(place)))
    parameters = {"float screenwindow": window}
    if data.type == "PERSP":
        # Of 90 degrees the film lies at distance 1.
        parameters["float fov"] = 90
    opening = lens(data, matrix, missing)
    if opening is not None:
        parameters |= {"float lensradius": opening[0], "float focaldistance": opening[1]}
    text.say("Camera", "perspective" if data.type == "PERSP" else "orthographic", parameters)
    x0, x1, y0, y1 = region(render)
    text.say("Film", "rgb", {"integer xresolution": size[0], "integer yresolution": size[1],
                             "integer pixelbounds": (x0, x1, size[1] - y1, size[1] - y0),
                             "string filename": file_name})
    write_filter(text, render)


def write_filter(text, render):
    """Writes the pixel filter: Blender's width is that of Cycles' Blackman-Harris."""
    width = max(render.filter_size, 0.01)
    # A Gaussian of the same spread as that filter over `width` pixels.
    text.say("PixelFilter", "gaussian", {"float xradius": width / 2 + 0.25,
                                         "float yradius": width / 2 + 0.25,
                                         "float sigma": max(width * 0.19, 0.1)})
