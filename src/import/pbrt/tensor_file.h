// Reader of files with named arrays, the format of measured materials (.bsdf).
//
// Layout, little-endian: "tensor_file" and a zero; version 1, 0; 32-bit count of fields; for each:
// 16-bit length of its name, name, 16-bit count of dimensions, 8-bit type, 64-bit offset in the
// file, 64-bit extents.
// Source: Dupuy and Jakob, An Adaptive Parameterization for Efficient Material Acquisition and
// Rendering (2018), and its files.
#pragma once

#include "sunfleck/error.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// An array of floats; the last index varies fastest.
struct Tensor {
    std::vector<std::size_t> extents;  // all positive
    std::vector<float> values;
};

/// Returns the fields of those names, if they hold finite floats and have the dimensions.
/// @param wanted  name and dimensions; a missing one is an Error.
/// @throws Error  (at `from`) for another or a damaged file.
std::map<std::string, Tensor> read_tensors(const std::string& bytes,
                                           const std::map<std::string, std::size_t>& wanted,
                                           const SourceLocation& from);

}  // namespace sunfleck::engine
