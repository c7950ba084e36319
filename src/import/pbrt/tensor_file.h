// Files of named arrays: what measured materials come in (.bsdf).
//
// Layout, little-endian: "tensor_file" and a zero; version 1, 0; 32-bit count of fields; of each:
// 16-bit length of its name, name, 16-bit count of dimensions, 8-bit type, 64-bit place in the
// file, 64-bit extents. Source: Dupuy and Jakob, An Adaptive Parameterization for Efficient
// Material Acquisition and Rendering (2018), and the files that came with it.
#pragma once

#include "sunfleck/error.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// Floats, the last index running fastest.
struct Tensor {
    std::vector<std::size_t> extents;  // none is 0
    std::vector<float> values;
};

/// The fields of that name that are there, hold finite floats, and have as many dimensions.
/// @param wanted  name and dimensions; a missing one is an Error.
/// @throws Error  (place `from`) for what is no such file, or a broken one.
std::map<std::string, Tensor> read_tensors(const std::string& bytes,
                                           const std::map<std::string, std::size_t>& wanted,
                                           const SourceLocation& from);

}  // namespace sunfleck::engine
