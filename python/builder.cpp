// SceneBuilder with parameters of dicts and meshes of arrays.
#include "python/builder.h"

#include "python/conversions.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace sunfleck::python {
namespace {

using Floats = py::array_t<float, py::array::c_style | py::array::forcecast>;
using Indices = py::array_t<std::uint32_t, py::array::c_style | py::array::forcecast>;

template <class T>
std::span<const T> span_of(const py::array_t<T, py::array::c_style | py::array::forcecast>& array) {
    return {array.data(), static_cast<std::size_t>(array.size())};
}

ShapeOptions shape_options(const std::string& material, const Transform& to_world,
                           const std::optional<py::dict>& area_light,
                           const std::string& inside_medium, const std::string& outside_medium,
                           bool reverse_orientation, const std::string& object) {
    ShapeOptions options{material, to_world, {}, inside_medium, outside_medium};
    if (area_light) options.area_light = parameters_of(*area_light);
    options.reverse_orientation = reverse_orientation;
    options.object = object;
    return options;
}

void add_shapes(py::class_<SceneBuilder>& builder) {
    builder
        .def(
            "shape",
            [](SceneBuilder& self, const std::string& type, const py::dict& parameters,
               const std::string& material, const Transform& to_world,
               const std::optional<py::dict>& area_light, const std::string& inside,
               const std::string& outside, bool reverse, const std::string& object) {
                self.shape(type, parameters_of(parameters),
                           shape_options(material, to_world, area_light, inside, outside, reverse,
                                         object));
            },
            py::arg("type"), py::arg("parameters") = py::dict(), py::kw_only(),
            py::arg("material") = "", py::arg("to_world") = Transform(),
            py::arg("area_light") = py::none(), py::arg("inside_medium") = "",
            py::arg("outside_medium") = "", py::arg("reverse_orientation") = false,
            py::arg("object") = "")
        .def(
            "mesh",
            [](SceneBuilder& self, const Floats& positions, const Indices& triangles,
               const std::optional<Floats>& normals, const std::optional<Floats>& uvs,
               const std::string& material, const Transform& to_world,
               const std::optional<py::dict>& area_light, const std::string& inside,
               const std::string& outside, bool reverse, const std::string& object) {
                Mesh mesh{span_of(positions), span_of(triangles)};
                if (normals) mesh.normals = span_of(*normals);
                if (uvs) mesh.uvs = span_of(*uvs);
                self.mesh(mesh, shape_options(material, to_world, area_light, inside, outside,
                                              reverse, object));
            },
            py::arg("positions"), py::arg("triangles"), py::arg("normals") = py::none(),
            py::arg("uvs") = py::none(), py::kw_only(), py::arg("material") = "",
            py::arg("to_world") = Transform(), py::arg("area_light") = py::none(),
            py::arg("inside_medium") = "", py::arg("outside_medium") = "",
            py::arg("reverse_orientation") = false, py::arg("object") = "",
            "Triangles of arrays: positions (n, 3), triangles (m, 3), normals (n, 3), uvs (n, 2).")
        .def("instance", &SceneBuilder::instance, py::arg("object"),
             py::arg("to_world") = Transform());
}

void add_materials(py::class_<SceneBuilder>& builder) {
    builder
        .def(
            "material",
            [](SceneBuilder& self, const std::string& name, const std::string& type,
               const py::dict& parameters) {
                self.material(name, type, parameters_of(parameters));
            },
            py::arg("name"), py::arg("type"), py::arg("parameters") = py::dict())
        .def(
            "texture",
            [](SceneBuilder& self, const std::string& name, const std::string& kind,
               const std::string& type, const py::dict& parameters, const Transform& to_world) {
                self.texture(name, kind, type, parameters_of(parameters), to_world);
            },
            py::arg("name"), py::arg("kind"), py::arg("type"), py::arg("parameters") = py::dict(),
            py::arg("to_world") = Transform())
        .def(
            "medium",
            [](SceneBuilder& self, const std::string& name, const std::string& type,
               const py::dict& parameters) { self.medium(name, type, parameters_of(parameters)); },
            py::arg("name"), py::arg("type"), py::arg("parameters") = py::dict())
        .def(
            "light",
            [](SceneBuilder& self, const std::string& type, const py::dict& parameters,
               const Transform& to_world, const std::string& medium) {
                self.light(type, parameters_of(parameters), to_world, medium);
            },
            py::arg("type"), py::arg("parameters"), py::arg("to_world") = Transform(),
            py::arg("medium") = "");
}

}  // namespace

void add_builder(py::module_& module) {
    py::class_<SceneBuilder> builder(module, "SceneBuilder",
                                     "Makes a scene call by call, with pbrt-v4's types.");
    builder.def(py::init<const std::string&>(), py::arg("folder") = ".")
        .def(
            "camera",
            [](SceneBuilder& self, const std::string& type, const py::dict& parameters,
               const Transform& to_world, const std::string& medium) {
                self.camera(type, parameters_of(parameters), to_world, medium);
            },
            py::arg("type"), py::arg("parameters"), py::arg("to_world"), py::arg("medium") = "")
        .def(
            "film",
            [](SceneBuilder& self, int width, int height, const py::dict& parameters) {
                self.film(width, height, parameters_of(parameters));
            },
            py::arg("width"), py::arg("height"), py::arg("parameters") = py::dict())
        .def(
            "filter",
            [](SceneBuilder& self, const std::string& type, const py::dict& parameters) {
                self.filter(type, parameters_of(parameters));
            },
            py::arg("type"), py::arg("parameters") = py::dict())
        .def(
            "build",
            [](SceneBuilder& self, std::size_t threads, const std::string& isa) {
                const py::gil_scoped_release unlocked;
                return self.build({threads, isa});
            },
            py::kw_only(), py::arg("threads") = 0, py::arg("isa") = "avx2");
    add_materials(builder);
    add_shapes(builder);
}

}  // namespace sunfleck::python
