// Spaces of paths with sets of known measure and flux: what samplers are tested on.
#pragma once

#include "chains/path_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace sunfleck::engine::testing_support {

/// Rays and the like of a toy: how many paths were traced.
struct ToyTally {
    std::uint64_t traced = 0;
    ToyTally& operator+=(const ToyTally& other) {
        traced += other.traced;
        return *this;
    }
};

struct ToyPath {
    double flux = 0;
    int height = 0;
};

/// A box of [0,1)^D around a point, wrapped around, with the flux of the paths in it.
struct Island {
    double centre = 0;      // in each dimension
    double half_width = 0;  // in the first dimensions, as many as the space says
    double others = 0.5;    // half width in the other dimensions
    double flux = 1;
};

/// A path that reads `dimensions` in turn and then, on an island, one dimension more, in which its
/// flux is linear: dimension 100 on the left half, dimension 101 on the right half, where it is
/// visible only if that is below `open`. How high a path stands elsewhere says how often the
/// nearest island would have to grow by `growth`.
struct Islands {
    using Path = ToyPath;
    using Tally = ToyTally;
    static constexpr std::size_t kMostDimensions = 64;

    std::string name;
    std::vector<std::uint32_t> dimensions;
    std::vector<Island> islands;
    std::size_t narrow = 2;  // dimensions in which islands have `half_width`
    double open = 0.6;
    double growth = 2;

    template <PrimarySampleReader Reader>
    void trace(Reader&& read, Path& path, Tally& tally) const {
        ++tally.traced;
        std::array<double, kMostDimensions> u{};
        for (std::size_t i = 0; i < dimensions.size(); ++i) u[i] = to_unit(read(dimensions[i]));
        path = {};
        for (const Island& island : islands) {
            double apart = 0;  // in half widths
            for (std::size_t i = 0; i < dimensions.size(); ++i) {
                const double d = std::abs(u[i] - island.centre);
                const double half = i < narrow ? island.half_width : island.others;
                apart = std::max(apart, std::min(d, 1 - d) / half);
            }
            if (apart >= 1) {
                path.height = std::max(path.height, height_at(apart));
                continue;
            }
            const double turned = u[0] - island.centre + 1.5;
            const bool right = turned - std::floor(turned) >= 0.5;
            const double extra = to_unit(read(right ? 101 : 100));
            const bool visible = !right || extra < open;
            path.height = std::max(path.height, visible ? kVisible : kVisible - 1);
            if (visible) path.flux = island.flux * (right ? 2 * extra : 1 + extra);
        }
    }
    int height(const Path& path) const { return path.height; }

    /// E V.
    double visible_fraction() const {
        double sum = 0;
        for (const Island& island : islands) sum += measure(island) * (1 + open) / 2;
        return sum;
    }
    /// E f: 1.5 on average on a left half, open on the visible share `open` of a right half.
    double mean_flux() const {
        double sum = 0;
        for (const Island& island : islands)
            sum += measure(island) * island.flux * (1.5 + open * open) / 2;
        return sum;
    }

private:
    /// @param apart  at least 1.
    int height_at(double apart) const {
        int height = kVisible - 1;
        for (; apart >= growth && height > 0; apart /= growth) --height;
        return height;
    }
    double measure(const Island& island) const {
        double product = 1;
        for (std::size_t i = 0; i < dimensions.size(); ++i)
            product *= 2 * (i < narrow ? island.half_width : island.others);
        return product;
    }
};

/// Nested boxes of two dimensions, the flux linear in the first and in a third one. A state near
/// the origin stands longer, so how often one is repeated depends on where it is.
struct NestedBoxes {
    using Path = ToyPath;
    using Tally = ToyTally;
    struct Box {
        double x = 1;
        double y = 1;
    };

    std::string name;
    std::vector<Box> boxes;  // each in the one before; the heights 1, 2, ..., the last kVisible

    template <PrimarySampleReader Reader>
    void trace(Reader&& read, Path& path, Tally& tally) const {
        ++tally.traced;
        const double x = to_unit(read(0));
        const double y = to_unit(read(1));
        std::size_t in = 0;
        while (in < boxes.size() && x < boxes[in].x && y < boxes[in].y) ++in;
        path = {0, static_cast<int>(in)};
        if (in < boxes.size()) return;
        path = {1 + 20 * x + to_unit(read(2)), kVisible};
    }
    int height(const Path& path) const { return path.height; }

    double visible_fraction() const { return boxes.back().x * boxes.back().y; }
    double mean_flux() const { return visible_fraction() * (1 + 10 * boxes.back().x + 0.5); }
};

/// Dimensions 0 .. 5 of the emission, then those of bounces.
inline std::vector<std::uint32_t> first_dimensions(std::uint32_t n) {
    std::vector<std::uint32_t> list;
    for (std::uint32_t i = 0; i < n; ++i) list.push_back(i);
    return list;
}

}  // namespace sunfleck::engine::testing_support
