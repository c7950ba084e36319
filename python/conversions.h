// Python's values as those of the library.
#pragma once

#include "python/text.h"

#include <pybind11/pybind11.h>
#include <sunfleck/sunfleck.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace sunfleck::python {

namespace py = pybind11;

/// {"float roughness": 0.1, "rgb L": [1, 2, 3]}: numbers, strings, truth values, lists of these,
/// arrays, and paths. @param call  names the call in messages. @throws Error  for other values.
Parameters parameters_of(const std::string& call, const py::dict& values);

/// A number of passes or threads. @throws Error  for what is none.
std::uint32_t count_of(const std::string& name, std::int64_t number);

/// Flags of a scene by the names of the command line's, with underscores: sun=(225, 40).
/// @throws Error  for values that are no numbers, strings, or lists of these.
std::vector<std::pair<std::string, std::string>> scene_flags_of(const py::kwargs& values);

/// Settings by the names of the command line's flags, with underscores: photons_per_pass=100000.
/// Values are numbers, strings, truth values, and lists of these.
/// @throws Error  for other values, and as Settings::set() does.
Settings settings_of(const py::kwargs& values);

}  // namespace sunfleck::python
