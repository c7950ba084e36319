// Kinds and shapes are checked before NumPy converts, since NumPy wraps, cuts and flattens.
#include "python/arrays.h"

#include <limits>
#include <string_view>

namespace sunfleck::python {
namespace {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

/// @param kinds  NumPy's letters: i and u for whole numbers, f for floats.
bool is_of(const py::array& array, std::string_view kinds) {
    return kinds.find(array.dtype().kind()) != std::string_view::npos;
}

double number_of(const py::handle& item, const Purpose& purpose) {
    const double number = PyFloat_AsDouble(item.ptr());
    if (number == -1 && PyErr_Occurred() != nullptr) {
        const py::error_already_set fault;
        purpose.refuse(
            "a value that is no number (" + py::str(fault.value()).cast<std::string>() + ")",
            "give numbers");
    }
    return number;
}

}  // namespace

py::array array_of(const py::handle& value, const Purpose& purpose) {
    try {
        return py::module_::import("numpy").attr("asarray")(value);
    } catch (const py::error_already_set& fault) {
        if (!fault.matches(PyExc_ValueError)) throw;
        purpose.refuse("lists of unequal lengths", "give rows of the same length");
    }
}

std::string kind_of(const py::handle& value, const py::array& array) {
    if (array.ndim() == 0) return Py_TYPE(value.ptr())->tp_name;
    return "an array of " + py::str(array.dtype()).cast<std::string>();
}

std::vector<double> numbers_of(const py::handle& value, const py::array& array,
                               const Purpose& purpose) {
    if (is_of(array, "iuf")) {
        const Doubles numbers(array);
        return {numbers.data(), numbers.data() + numbers.size()};
    }
    // Whole numbers beyond 64 bits, fractions and the like.
    if (!is_of(array, "O")) purpose.refuse(kind_of(value, array), "give numbers");
    std::vector<double> numbers;
    for (const py::handle item : array.attr("ravel")().attr("tolist")())
        numbers.push_back(number_of(item, purpose));
    return numbers;
}

void check_rows(const py::array& array, py::ssize_t length, const Purpose& purpose) {
    if (array.ndim() < 2 || array.shape(array.ndim() - 1) == length) return;
    const std::string wanted = std::to_string(length);
    purpose.refuse("an array of the shape " + py::str(array.attr("shape")).cast<std::string>(),
                   "give rows of " + wanted + " numbers: (n, " + wanted + ")");
}

Floats rows_of(const py::handle& value, py::ssize_t length, const Purpose& purpose) {
    const py::array array = array_of(value, purpose);
    if (!is_of(array, "iuf")) purpose.refuse(kind_of(value, array), "give an array of numbers");
    check_rows(array, length, purpose);
    return Floats(array);
}

std::vector<std::uint32_t> triangles_of(const py::handle& value, const Purpose& purpose) {
    const py::array array = array_of(value, purpose);
    if (array.size() > 0 && !is_of(array, "iu"))
        purpose.refuse(kind_of(value, array), "give an array of whole numbers, as int64 or uint32");
    check_rows(array, 3, purpose);
    const Integers wide(array);  // unsigned ones of 64 bits that do not fit in are negative then
    std::vector<std::uint32_t> indices;
    indices.reserve(static_cast<std::size_t>(wide.size()));
    for (py::ssize_t i = 0; i < wide.size(); ++i) {
        const std::int64_t index = wide.data()[i];
        if (index < 0 || index > std::numeric_limits<std::uint32_t>::max())
            purpose.refuse("an index that is that of no vertex, at place " + std::to_string(i),
                           "count vertices from 0");
        indices.push_back(static_cast<std::uint32_t>(index));
    }
    return indices;
}

}  // namespace sunfleck::python
