// Accessors: arrays of numbers in buffer views, of any storage.
//
// Source: glTF 2.0 Specification, section 3.6.2: strides, normalised integers, sparse values.
#pragma once

#include "import/gltf/document.h"
#include "math/vector.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace sunfleck::engine {

class Accessors {
public:
    /// @param document  must outlive this.
    explicit Accessors(const GltfDocument& document) : document_(document) {}

    /// Gives an accessor other bytes than those of its buffer view: elements without gaps.
    /// @param index  of the accessor. @param size  numbers of an element.
    /// @throws Error  if the accessor has other elements, or more.
    void replace(const JsonPlace& index, std::string bytes, std::size_t size);

    // Each takes the index of an accessor, as it stands in the file.
    // @throws Error  for one of another type, beyond its buffer view, and for numbers that are not
    // finite.

    std::vector<float> scalars(const JsonPlace& index) const;
    std::vector<Vec2> pairs(const JsonPlace& index) const;
    std::vector<Vec3> triples(const JsonPlace& index) const;
    /// Returns vectors; those that are not finite are zero.
    std::vector<Vec3> directions(const JsonPlace& index) const;
    std::vector<std::array<float, 4>> quadruples(const JsonPlace& index) const;
    /// Returns matrices of 4 x 4, column by column as the file has them.
    std::vector<std::array<float, 16>> matrices(const JsonPlace& index) const;
    /// Returns integers, not normalised.
    std::vector<std::uint32_t> indices(const JsonPlace& index) const;
    std::vector<std::array<std::uint32_t, 4>> index_quadruples(const JsonPlace& index) const;
    /// Returns the largest integer that an accessor's elements can hold.
    std::uint32_t largest_index(const JsonPlace& index) const;

private:
    JsonPlace at(const JsonPlace& index) const { return document_.element("accessors", index); }

    const GltfDocument& document_;
    std::map<const void*, std::string> replaced_;  // bytes by the identity of the accessor
};

}  // namespace sunfleck::engine
