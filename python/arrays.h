// NumPy's arrays, and whatever NumPy makes arrays of, as numbers of the library.
#pragma once

#include "python/text.h"

#include <pybind11/numpy.h>
#include <sunfleck/sunfleck.h>

#include <cstdint>
#include <string>
#include <vector>

namespace sunfleck::python {

namespace py = pybind11;

/// What a value is for, as messages name it.
struct Purpose {
    std::string call;  // "mesh"
    std::string name;  // "the argument positions", "the parameter \"float radius\""

    /// @throws Error  always: "mesh: the argument positions is given bytes; give numbers".
    [[noreturn]] void refuse(const std::string& given, const std::string& mend) const {
        throw Error({call}, name + " is given " + given, mend);
    }
};

using Floats = py::array_t<float, py::array::c_style | py::array::forcecast>;

/// An array of numbers, strings or other objects. @throws Error  for lists of unequal lengths.
py::array array_of(const py::handle& value, const Purpose& purpose);

/// How messages call values of this kind: "bytes", "an array of complex128".
std::string kind_of(const py::handle& value, const py::array& array);

/// @throws Error  for what is no number.
std::vector<double> numbers_of(const py::handle& value, const py::array& array,
                               const Purpose& purpose);

/// @throws Error  for an array of rows that are of another length; flat arrays have no rows.
void check_rows(const py::array& array, py::ssize_t length, const Purpose& purpose);

/// Rows of `length` numbers, as an array of them or one after the other.
/// @throws Error  for rows of another length, and for what is no number.
Floats rows_of(const py::handle& value, py::ssize_t length, const Purpose& purpose);

/// Three indices for each triangle, as an array of rows or one after the other.
/// @throws Error  for rows of another length, and for what is no index.
std::vector<std::uint32_t> triangles_of(const py::handle& value, const Purpose& purpose);

}  // namespace sunfleck::python
