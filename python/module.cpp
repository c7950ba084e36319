// The extension module _sunfleck: classes of the library as Python has them.
#include "python/builder.h"
#include "python/conversions.h"
#include "python/rendering.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace sunfleck::python {
namespace {

/// Errors with their place, as sunfleck.Error.
void add_error(py::module_& module) {
    static py::object type;
    type = py::module_::import("sunfleck._error").attr("Error");
    module.attr("Error") = type;
    py::register_exception_translator([](std::exception_ptr fault) {
        try {
            if (fault) std::rethrow_exception(fault);
        } catch (const Error& error) {
            const LockClaim claim;  // Python is not to end while it makes the exception
            const py::object made =
                type(error.what(), error.where().file, error.where().line, error.where().column,
                     error.code() == ErrorCode::machine ? "machine" : "input");
            PyErr_SetObject(type.ptr(), made.ptr());
        }
    });
}

void add_transform(py::module_& module) {
    py::class_<Transform>(module, "Transform", "An affine map that places cameras, lights, shapes.")
        .def(py::init<>(), "The identity.")
        .def(py::init<const Transform::Rows&>(), py::arg("rows"), "Of four rows of four numbers.")
        .def_static("translate", &Transform::translate, py::arg("by"))
        .def_static("scale", &Transform::scale, py::arg("by"))
        .def_static("rotate", &Transform::rotate, py::arg("degrees"), py::arg("axis"))
        .def_static("look_at", &Transform::look_at, py::arg("eye"), py::arg("target"),
                    py::arg("up"), "Camera to world: x to the right, y up, z forward.")
        .def("__matmul__", [](const Transform& a, const Transform& b) { return a * b; })
        .def("rows", &Transform::rows);
}

void add_scene(py::module_& module) {
    py::class_<LightInfo>(module, "LightInfo", "A statement of light, as --light-group counts.")
        .def_readonly("what", &LightInfo::what)
        .def_readonly("where", &LightInfo::where);
    py::class_<Scene>(module, "Scene", "A scene, ready to be rendered. Immutable.")
        .def_static(
            "load",
            [](const std::string& path, std::int64_t threads, const std::string& isa,
               const py::kwargs& flags) {
                const SceneOptions options{count_of("threads", threads), isa,
                                           scene_flags_of(flags)};
                return unlocked([&] { return Scene::load(path, options); });
            },
            py::arg("path"), py::kw_only(), py::arg("threads").noconvert() = 0,
            py::arg("isa") = "avx2",
            "Reads a scene file: pbrt-v4, glTF, or OBJ, STL or PLY alone. More names are flags of "
            "the scene, as of sunfleck render: sun=(225, 40).")
        .def_static(
            "parse",
            [](const std::string& text, const std::string& name, std::int64_t threads,
               const std::string& isa) {
                return unlocked([&] {
                    return Scene::parse(text, name, {count_of("threads", threads), isa});
                });
            },
            py::arg("text"), py::arg("name") = "scene.pbrt", py::kw_only(),
            py::arg("threads").noconvert() = 0, py::arg("isa") = "avx2",
            "Reads a scene from text; files are found from name's folder.")
        .def_property_readonly("width", &Scene::width)
        .def_property_readonly("height", &Scene::height)
        .def_property_readonly("warnings", &Scene::warnings)
        .def_property_readonly("files", &Scene::files)
        .def_property_readonly("lights", &Scene::lights)
        .def_property_readonly("triangle_count", &Scene::triangle_count);
}

/// A view of a channel that keeps the picture alive and cannot be written to.
py::array channel_view(const py::object& self, const std::string& name) {
    const auto& picture = self.cast<const Picture&>();
    const std::span<const float> values = picture.channel(name);
    py::array_t<float> view({picture.height(), picture.width()}, values.data(), self);
    view.attr("setflags")(py::arg("write") = false);
    return view;
}

void add_picture(py::module_& module) {
    py::class_<Picture>(module, "Picture", "Named channels of floats, linear sRGB. Immutable.")
        .def_static(
            "load",
            [](const std::string& path) { return unlocked([&] { return Picture::load(path); }); },
            py::arg("path"), "Reads an .exr with all its channels.")
        .def_property_readonly("width", &Picture::width)
        .def_property_readonly("height", &Picture::height)
        .def_property_readonly("channels", &Picture::channels)
        .def_property_readonly("metadata", &Picture::metadata)
        .def("__contains__", &Picture::has)
        .def("__getitem__", channel_view, py::arg("channel"),
             "The channel as an array (height, width), without a copy.")
        .def(
            "save",
            [](const Picture& self, const std::string& path, std::optional<double> exposure) {
                unlocked([&] { self.save(path, exposure); });
            },
            py::arg("path"), py::arg("exposure") = py::none(),
            "Writes .exr, or .png or .jpg with an exposure in stops.");
}

void add_settings(py::module_& module) {
    py::class_<SettingInfo>(module, "SettingInfo", "A setting, as the command line has it.")
        .def_readonly("name", &SettingInfo::name)
        .def_readonly("form", &SettingInfo::form)
        .def_readonly("choices", &SettingInfo::choices)
        .def_readonly("repeats", &SettingInfo::repeats)
        .def_readonly("default_value", &SettingInfo::default_value)
        .def_readonly("help", &SettingInfo::help);
    module.def("settings", &Settings::list, "All settings that a Renderer takes.");
}

void add_renderer(py::module_& module) {
    py::class_<Progress>(module, "Progress", "What is known of a render after a pass.")
        .def_readonly("passes", &Progress::passes)
        .def_readonly("of", &Progress::of)
        .def_readonly("seconds", &Progress::seconds)
        .def_readonly("cpu_seconds", &Progress::cpu_seconds)
        .def_readonly("error", &Progress::error)
        .def_readonly("target_error", &Progress::target_error)
        .def_readonly("seconds_left", &Progress::seconds_left)
        .def_readonly("is_learning", &Progress::is_learning);
    py::class_<PythonRenderer>(module, "_Renderer")
        .def(py::init([](const Scene& scene, std::int64_t threads, const py::object& log,
                         const py::kwargs& settings) {
                 return std::make_unique<PythonRenderer>(scene, settings_of(settings),
                                                         count_of("threads", threads), log);
             }),
             py::arg("scene"), py::kw_only(), py::arg("threads").noconvert(), py::arg("log"))
        .def("run", &PythonRenderer::run, py::arg("report") = py::none())
        .def(
            "step",
            [](PythonRenderer& self, std::int64_t passes, const py::object& report) {
                return self.step(count_of("passes", passes), report);
            },
            py::arg("passes").noconvert() = 1, py::arg("report") = py::none())
        .def("start", &PythonRenderer::start, py::arg("report") = py::none())
        .def("wait", &PythonRenderer::wait)
        .def("cancel", [](PythonRenderer& self) { self.renderer().cancel(); })
        .def_property_readonly("is_running",
                               [](PythonRenderer& self) { return self.renderer().is_running(); })
        .def_property_readonly("progress",
                               [](PythonRenderer& self) {
                                   return unlocked([&] { return self.renderer().progress(); });
                               })
        .def("picture",
             [](PythonRenderer& self) {
                 return unlocked([&] { return self.renderer().picture(); });
             })
        .def("_statistics",
             [](PythonRenderer& self) {
                 return unlocked([&] { return self.renderer().statistics(); });
             })
        .def(
            "set_camera",
            [](PythonRenderer& self, const std::string& type, const py::dict& parameters,
               const Transform& to_world) {
                const Parameters given = parameters_of("camera", parameters);
                self.change(
                    [&](Renderer& renderer) { renderer.set_camera(type, given, to_world); });
            },
            py::arg("type"), py::arg("parameters"), py::arg("to_world"))
        .def(
            "set_resolution",
            [](PythonRenderer& self, int width, int height) {
                self.change([&](Renderer& renderer) { renderer.set_resolution(width, height); });
            },
            py::arg("width").noconvert(), py::arg("height").noconvert())
        .def(
            "set_crop",
            [](PythonRenderer& self, const std::optional<std::array<int, 4>>& crop) {
                self.change([&](Renderer& renderer) { renderer.set_crop(crop); });
            },
            py::arg("x0_x1_y0_y1").noconvert());
}

/// Objects that __new__ alone has made hold no value; pybind11 would give memory in its place.
void refuse_unmade_objects(const py::module_& module) {
    for (const auto& [name, item] : module.attr("__dict__").cast<py::dict>()) {
        if (PyType_Check(item.ptr()) == 0) continue;
        auto* const info = py::detail::get_type_info(reinterpret_cast<PyTypeObject*>(item.ptr()));
        if (info == nullptr) continue;
        info->operator_new = [](std::size_t) -> void* {
            throw py::type_error("the object holds nothing: it was made by __new__ alone");
        };
    }
}

void add_all(py::module_& module) {
    module.doc() = "Sunfleck's library; see the package sunfleck.";
    module.attr("__version__") = version();
    add_error(module);
    add_transform(module);
    add_scene(module);
    add_builder(module);
    add_picture(module);
    add_settings(module);
    add_renderer(module);
    add_end();
    refuse_unmade_objects(module);
}

}  // namespace
}  // namespace sunfleck::python

PYBIND11_MODULE(_sunfleck, module) {
    sunfleck::python::add_all(module);
}
