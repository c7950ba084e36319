// What a Python value is, by its type.
#include "python/conversions.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace sunfleck::python {
namespace {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<std::int32_t, py::array::c_style | py::array::forcecast>;

Value value_of_list(const py::sequence& list) {
    if (py::len(list) > 0 && py::isinstance<py::str>(list[0]))
        return list.cast<std::vector<std::string>>();
    return list.cast<std::vector<double>>();
}

Value value_of_array(const py::array& array) {
    if (array.dtype().kind() == 'i' || array.dtype().kind() == 'u') {
        const auto integers = array.cast<Integers>();
        return std::span<const std::int32_t>(integers.data(), integers.size());
    }
    const auto numbers = array.cast<Doubles>();
    return std::span<const double>(numbers.data(), numbers.size());
}

Value value_of(const py::handle& value) {
    if (py::isinstance<py::bool_>(value)) return value.cast<bool>();
    if (py::isinstance<py::str>(value)) return value.cast<std::string>();
    if (py::isinstance<py::array>(value)) return value_of_array(value.cast<py::array>());
    if (PyIndex_Check(value.ptr()) != 0) return value.cast<int>();  // NumPy's whole numbers, too
    if (py::hasattr(value, "__float__")) return value.cast<double>();
    if (py::isinstance<py::sequence>(value)) return value_of_list(value.cast<py::sequence>());
    throw py::type_error("a parameter is a number, a string, a bool, a list of these or an array");
}

/// (640, 480) as 640x480, (0, 10, 0, 20) as 0,10,0,20.
std::string joined(const py::sequence& list, const std::string& form) {
    const std::string between = form == "WxH" ? "x" : ",";
    std::string text;
    for (const py::handle item : list)
        text += (text.empty() ? "" : between) + py::str(item).cast<std::string>();
    return text;
}

}  // namespace

Parameters parameters_of(const py::dict& values) {
    Parameters parameters;
    for (const auto& [name, value] : values)
        parameters.push_back({name.cast<std::string>(), value_of(value)});
    return parameters;
}

void set_setting(Settings& settings, const std::string& name, const py::handle& value) {
    const bool is_list = py::isinstance<py::sequence>(value) && !py::isinstance<py::str>(value);
    if (py::isinstance<py::bool_>(value)) {
        settings.set(name, value.cast<bool>());
    } else if (!is_list) {
        settings.set(name, py::str(value).cast<std::string>());
    } else if (const SettingInfo info = Settings::find(name); info.repeats) {
        for (const py::handle item : value) settings.set(name, py::str(item).cast<std::string>());
    } else {
        settings.set(name, joined(value.cast<py::sequence>(), info.form));
    }
}

Settings settings_of(const py::kwargs& values) {
    Settings settings;
    for (const auto& [name, value] : values) set_setting(settings, name.cast<std::string>(), value);
    return settings;
}

}  // namespace sunfleck::python
