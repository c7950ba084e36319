// What a Python value is, by the array that NumPy makes of it.
#include "python/conversions.h"

#include "python/arrays.h"

#include <pybind11/stl.h>

#include <limits>
#include <map>

namespace sunfleck::python {
namespace {

/// How many numbers a row of an array has, by the type of the declaration; 0: any number.
py::ssize_t row_length(const std::string& declaration) {
    static const std::map<std::string, py::ssize_t> lengths = {
        {"point2", 2}, {"vector2", 2}, {"spectrum", 2}, {"point", 3},   {"point3", 3},
        {"vector", 3}, {"vector3", 3}, {"normal", 3},   {"normal3", 3}, {"rgb", 3}};
    const auto found = lengths.find(declaration.substr(0, declaration.find(' ')));
    return found == lengths.end() ? 0 : found->second;
}

/// The strings themselves, of which NumPy makes some of numbers, too.
std::vector<std::string> strings_of(const py::handle& value, const Purpose& purpose) {
    std::vector<std::string> strings;
    for (const py::handle item : value) {
        if (!py::isinstance<py::str>(item))
            purpose.refuse("strings and others in one list", "give strings alone, or numbers");
        strings.push_back(item.cast<std::string>());
    }
    return strings;
}

Value value_of(const py::handle& value, const std::string& declaration, const Purpose& purpose) {
    py::detail::make_caster<std::string> text;
    if (!py::isinstance<py::bytes>(value) && text.load(value, true))
        return py::detail::cast_op<std::string>(text);
    const py::array array = array_of(value, purpose);
    if (array.dtype().kind() == 'b') {
        if (array.size() != 1) purpose.refuse("several truth values", "give one");
        return array.attr("item")().cast<bool>();
    }
    if (array.dtype().kind() == 'U') return strings_of(value, purpose);
    if (const py::ssize_t length = row_length(declaration); length > 0)
        check_rows(array, length, purpose);
    return numbers_of(value, array, purpose);
}

/// A word of the command line. @throws Error  for what is neither a number nor a string.
std::string word_of(const py::handle& value, const Purpose& purpose) {
    if (!py::isinstance<py::str>(value) && PyNumber_Check(value.ptr()) == 0)
        purpose.refuse(Py_TYPE(value.ptr())->tp_name,
                       "give a number, a string, True or False, or a list of numbers or strings");
    return py::str(value).cast<std::string>();
}

/// (640, 480) as 640x480, (0, 10, 0, 20) as 0,10,0,20.
std::string joined(const py::sequence& list, const std::string& form, const Purpose& purpose) {
    const std::string between = form == "WxH" ? "x" : ",";
    std::string text;
    for (const py::handle item : list)
        text += (text.empty() ? "" : between) + word_of(item, purpose);
    return text;
}

void set_setting(Settings& settings, const std::string& name, const py::handle& given) {
    const Purpose purpose{name, "the setting"};
    const py::object value = py::hasattr(given, "tolist")
                                 ? py::object(given.attr("tolist")())
                                 : py::reinterpret_borrow<py::object>(given);
    const bool is_list = py::isinstance<py::sequence>(value) && !py::isinstance<py::str>(value) &&
                         !py::isinstance<py::bytes>(value);
    if (py::isinstance<py::bool_>(value)) {
        settings.set(name, value.cast<bool>());
    } else if (!is_list) {
        settings.set(name, word_of(value, purpose));
    } else if (const SettingInfo info = Settings::find(name); info.repeats) {
        for (const py::handle item : value) settings.set(name, word_of(item, purpose));
    } else {
        settings.set(name, joined(value, info.form, purpose));
    }
}

}  // namespace

Parameters parameters_of(const std::string& call, const py::dict& values) {
    Parameters parameters;
    for (const auto& [key, value] : values) {
        if (!py::isinstance<py::str>(key))
            throw Error({call}, py::repr(key).cast<std::string>() + " declares no parameter",
                        "give a type and a name, such as \"float radius\"");
        const auto declaration = key.cast<std::string>();
        const Purpose purpose{call, "the parameter \"" + declaration + "\""};
        parameters.push_back({declaration, value_of(value, declaration, purpose)});
    }
    return parameters;
}

std::uint32_t count_of(const std::string& name, std::int64_t number) {
    constexpr std::int64_t most = std::numeric_limits<std::uint32_t>::max();
    if (number < 0 || number > most)
        throw Error({name}, std::to_string(number) + " is no count",
                    "give a whole number from 0 to " + std::to_string(most));
    return static_cast<std::uint32_t>(number);
}

std::vector<std::pair<std::string, std::string>> scene_flags_of(const py::kwargs& values) {
    std::vector<std::pair<std::string, std::string>> flags;
    for (const auto& [key, value] : values) {
        const auto name = key.cast<std::string>();
        const Purpose purpose{name, "the flag"};
        if (py::isinstance<py::bool_>(value))
            flags.emplace_back(name, value.cast<bool>() ? "on" : "off");
        else if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value))
            flags.emplace_back(name,
                               joined(py::reinterpret_borrow<py::sequence>(value), ",", purpose));
        else
            flags.emplace_back(name, word_of(value, purpose));
    }
    return flags;
}

Settings settings_of(const py::kwargs& values) {
    Settings settings;
    for (const auto& [name, value] : values) set_setting(settings, name.cast<std::string>(), value);
    return settings;
}

}  // namespace sunfleck::python
