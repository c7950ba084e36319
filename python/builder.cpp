// SceneBuilder with parameters of dicts and meshes of arrays.
#include "python/builder.h"

#include "python/arrays.h"
#include "python/conversions.h"
#include "python/interpreter.h"

#include <pybind11/stl.h>

namespace sunfleck::python {
namespace {

std::span<const float> span_of(const Floats& array) {
    return {array.data(), static_cast<std::size_t>(array.size())};
}

/// @param normals, uvs  None: none.
void add_mesh(SceneBuilder& builder, const py::object& positions, const py::object& triangles,
              const py::object& normals, const py::object& uvs, const ShapeOptions& options) {
    const Floats corners = rows_of(positions, 3, {"mesh", "the argument positions"});
    const std::vector<std::uint32_t> indices =
        triangles_of(triangles, {"mesh", "the argument triangles"});
    const auto optional_rows = [](const py::object& value, py::ssize_t length, const char* name) {
        return value.is_none() ? Floats() : rows_of(value, length, {"mesh", name});
    };
    const Floats normals_there = optional_rows(normals, 3, "the argument normals");
    const Floats uvs_there = optional_rows(uvs, 2, "the argument uvs");
    builder.mesh({span_of(corners), indices, span_of(normals_there), span_of(uvs_there)}, options);
}

ShapeOptions shape_options(const std::string& material, const Transform& to_world,
                           const std::optional<py::dict>& area_light,
                           const std::string& inside_medium, const std::string& outside_medium,
                           bool reverse_orientation, const std::string& object) {
    ShapeOptions options{material, to_world, {}, inside_medium, outside_medium};
    if (area_light) options.area_light = parameters_of("area_light", *area_light);
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
                self.shape(type, parameters_of("shape", parameters),
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
            [](SceneBuilder& self, const py::object& positions, const py::object& triangles,
               const py::object& normals, const py::object& uvs, const std::string& material,
               const Transform& to_world, const std::optional<py::dict>& area_light,
               const std::string& inside, const std::string& outside, bool reverse,
               const std::string& object) {
                add_mesh(self, positions, triangles, normals, uvs,
                         shape_options(material, to_world, area_light, inside, outside, reverse,
                                       object));
            },
            py::arg("positions"), py::arg("triangles"), py::arg("normals") = py::none(),
            py::arg("uvs") = py::none(), py::kw_only(), py::arg("material") = "",
            py::arg("to_world") = Transform(), py::arg("area_light") = py::none(),
            py::arg("inside_medium") = "", py::arg("outside_medium") = "",
            py::arg("reverse_orientation") = false, py::arg("object") = "",
            "Triangles of arrays: positions (n, 3), triangles (m, 3), normals (n, 3), uvs (n, 2), "
            "or flat ones.")
        .def("instance", &SceneBuilder::instance, py::arg("object"),
             py::arg("to_world") = Transform());
}

void add_materials(py::class_<SceneBuilder>& builder) {
    builder
        .def(
            "material",
            [](SceneBuilder& self, const std::string& name, const std::string& type,
               const py::dict& parameters) {
                self.material(name, type, parameters_of("material", parameters));
            },
            py::arg("name"), py::arg("type"), py::arg("parameters") = py::dict())
        .def(
            "texture",
            [](SceneBuilder& self, const std::string& name, const std::string& kind,
               const std::string& type, const py::dict& parameters, const Transform& to_world) {
                self.texture(name, kind, type, parameters_of("texture", parameters), to_world);
            },
            py::arg("name"), py::arg("kind"), py::arg("type"), py::arg("parameters") = py::dict(),
            py::arg("to_world") = Transform())
        .def(
            "medium",
            [](SceneBuilder& self, const std::string& name, const std::string& type,
               const py::dict& parameters) {
                self.medium(name, type, parameters_of("medium", parameters));
            },
            py::arg("name"), py::arg("type"), py::arg("parameters") = py::dict())
        .def(
            "light",
            [](SceneBuilder& self, const std::string& type, const py::dict& parameters,
               const Transform& to_world, const std::string& medium) {
                self.light(type, parameters_of("light", parameters), to_world, medium);
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
                self.camera(type, parameters_of("camera", parameters), to_world, medium);
            },
            py::arg("type"), py::arg("parameters"), py::arg("to_world"), py::arg("medium") = "")
        .def(
            "film",
            [](SceneBuilder& self, int width, int height, const py::dict& parameters) {
                self.film(width, height, parameters_of("film", parameters));
            },
            py::arg("width").noconvert(), py::arg("height").noconvert(),
            py::arg("parameters") = py::dict())
        .def(
            "filter",
            [](SceneBuilder& self, const std::string& type, const py::dict& parameters) {
                self.filter(type, parameters_of("filter", parameters));
            },
            py::arg("type"), py::arg("parameters") = py::dict())
        .def(
            "build",
            [](SceneBuilder& self, std::int64_t threads, const std::string& isa) {
                return unlocked([&] { return self.build({count_of("threads", threads), isa}); });
            },
            py::kw_only(), py::arg("threads").noconvert() = 0, py::arg("isa") = "avx2");
    add_materials(builder);
    add_shapes(builder);
}

}  // namespace sunfleck::python
