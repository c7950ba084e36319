// Python's values as those of the library.
#pragma once

#include <pybind11/pybind11.h>
#include <sunfleck/sunfleck.h>

#include <string>

namespace sunfleck::python {

namespace py = pybind11;

/// {"float roughness": 0.1, "rgb L": [1, 2, 3]}: numbers, strings, truth values, lists of these,
/// and arrays. @throws py::type_error  for other values.
Parameters parameters_of(const py::dict& values);

/// Sets a setting to a number, a string, a truth value, or a list of these.
/// @throws Error  as Settings::set() does.
void set_setting(Settings& settings, const std::string& name, const py::handle& value);

/// Settings by the names of the command line's flags, with underscores: photons_per_pass=100000.
Settings settings_of(const py::kwargs& values);

}  // namespace sunfleck::python
