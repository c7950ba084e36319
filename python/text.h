// Python's strings and paths as the library's strings, and back.
//
// Files and their folders need not be named in UTF-8. As in Python's own module os, bytes that are
// no characters become surrogates, and these become the bytes again. To be included before all of
// pybind11.
#pragma once

#include <pybind11/cast.h>

#include <string>

namespace pybind11::detail {

/// Takes str, bytes and os.PathLike, and gives str.
template <>
struct type_caster<std::string> {
    PYBIND11_TYPE_CASTER(std::string, const_name("str"));

    /// @throws error_already_set  for a str that has no bytes: UnicodeEncodeError.
    bool load(handle source, bool) {
        object text = reinterpret_steal<object>(PyOS_FSPath(source.ptr()));
        if (!text) {
            PyErr_Clear();
            return false;
        }
        if (PyUnicode_Check(text.ptr()))
            text = reinterpret_steal<object>(PyUnicode_EncodeFSDefault(text.ptr()));
        if (!text) throw error_already_set();
        value.assign(PyBytes_AS_STRING(text.ptr()),
                     static_cast<std::size_t>(PyBytes_GET_SIZE(text.ptr())));
        return true;
    }

    static handle cast(const std::string& text, return_value_policy, handle) {
        return PyUnicode_DecodeFSDefaultAndSize(text.data(), static_cast<ssize_t>(text.size()));
    }
};

}  // namespace pybind11::detail
