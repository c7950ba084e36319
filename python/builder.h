// The class SceneBuilder of the module.
#pragma once

#include "python/text.h"

#include <pybind11/pybind11.h>

namespace sunfleck::python {

void add_builder(pybind11::module_& module);

}  // namespace sunfleck::python
