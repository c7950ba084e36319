// PassImage: the contribution of one pass to each pixel, in exact sums that many threads fill.
//
// Terms are pixel values of this pass alone (radiance in linear sRGB, or a feature), already
// divided by the number of photon paths. The film's picture is the mean over passes.
//
// Light of camera paths can be stored apart, by cells of pixels. The rest is gathered from photons,
// and it alone has the bias of the gather radius.
#pragma once

#include "aovs/block_grid.h"
#include "aovs/channels.h"
#include "aovs/light_groups.h"
#include "core/exact_sum.h"
#include "math/vector.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

namespace sunfleck::engine {

/// The measured AOVs; the total always is one.
using AovSet = std::array<bool, kAovCount>;

/// Returns the cells of 2 x 2 pixels for which photons' light is summed apart: discs are at least
/// about as wide.
inline BlockGrid photon_cells_of(int width, int height) {
    return {width, height, 2};
}

class PassImage {
public:
    using Pixel = std::array<AtomicFixedPoint, 3>;

    /// @param photon_cells  of by_photons(), if it will be called.
    /// @param light_groups  their count.
    PassImage(std::size_t pixels, const AovSet& wanted,
              const std::optional<BlockGrid>& photon_cells = {}, std::size_t light_groups = 0)
        : pixels_(pixels), photon_cells_(photon_cells) {
        for (std::size_t i = 0; i < kAovCount; ++i)
            if (i == 0 || wanted.at(i)) aovs_.at(i) = std::vector<Pixel>(pixels);
        if (photon_cells) by_camera_ = std::vector<Pixel>(photon_cells->count());
        for (std::size_t i = 0; i < light_groups; ++i) lights_.emplace_back(pixels);
    }

    std::size_t pixels() const { return pixels_; }
    bool has(Aov aov) const { return !at(aov).empty(); }
    /// Returns the number of cells of by_photons(), or zero.
    std::size_t photon_cells() const { return by_camera_.size(); }
    std::size_t light_groups() const { return lights_.size(); }

    /// Adds to the total and, if measured, to the AOV of this light. A value that is not finite is
    /// dropped and counted; one beyond kLargestTerm is clamped and counted.
    void add_light(std::size_t pixel, const Vec3& rgb, Aov owner) {
        if (!is_finite(rgb)) return;
        add(aovs_[0][pixel], rgb);
        if (owner != Aov::total && has(owner))
            add(aovs_[static_cast<std::size_t>(owner)][pixel], rgb);
    }

    /// Calls add_light() for light of a camera path, not gathered from photons.
    void add_camera_light(std::size_t pixel, const Vec3& rgb, Aov owner) {
        add_light(pixel, rgb, owner);
        if (!photon_cells_ || !finite(rgb)) return;
        Pixel& cell = by_camera_[photon_cells_->block_of(pixel)];
        for (unsigned c = 0; c < 3; ++c) cell[c].add(term_of(rgb[static_cast<int>(c)]));
    }

    /// Adds a value that add_light() has added before to the group of its light; it is clamped or
    /// dropped alike, and not counted again. @param group  kNoLightGroup adds nothing.
    void add_to_light_group(std::size_t pixel, const Vec3& rgb, std::uint8_t group) {
        if (group == kNoLightGroup || !finite(rgb)) return;
        for (unsigned c = 0; c < 3; ++c)
            lights_[group][pixel][c].add(term_of(rgb[static_cast<int>(c)]));
    }

    /// Adds light that is_addable(), while no other thread uses this pixel.
    void add_alone(std::size_t pixel, const Vec3& rgb, Aov owner) {
        const std::array<FixedPoint, 3> terms{FixedPoint::from_double(rgb.x),
                                              FixedPoint::from_double(rgb.y),
                                              FixedPoint::from_double(rgb.z)};
        add_alone(aovs_[0][pixel], terms);
        if (owner != Aov::total && has(owner))
            add_alone(aovs_[static_cast<std::size_t>(owner)][pixel], terms);
    }

    /// Returns the address that add_light() writes first, for prefetching.
    const void* place_of(std::size_t pixel) const { return &aovs_[0][pixel]; }

    /// Returns whether add_light() would add the value unchanged.
    static bool is_addable(const Vec3& rgb) {
        const auto fits = [](float x) { return std::abs(static_cast<double>(x)) <= kLargestTerm; };
        return fits(rgb.x) && fits(rgb.y) && fits(rgb.z);
    }

    /// Adds to a feature AOV alone, if it is measured.
    void add_feature(std::size_t pixel, const Vec3& value, Aov aov) {
        if (has(aov) && is_finite(value)) add(aovs_[static_cast<std::size_t>(aov)][pixel], value);
    }

    /// Adds an exact sum to one channel of one AOV alone.
    void add_term(Aov aov, std::size_t pixel, std::size_t channel, const FixedPoint& term) {
        aovs_[static_cast<std::size_t>(aov)][pixel].at(channel).add(term);
    }

    FixedPoint value(Aov aov, std::size_t pixel, std::size_t channel) const {
        return at(aov)[pixel][channel].value();
    }

    FixedPoint light_value(std::size_t light_group, std::size_t pixel, std::size_t channel) const {
        return lights_[light_group][pixel][channel].value();
    }

    /// Returns the total of a cell minus the light of camera paths. @param channel  of RGB.
    FixedPoint by_photons(std::size_t cell, std::size_t channel) const {
        FixedPoint sum;
        photon_cells_->for_pixels(
            cell, [&](std::size_t pixel) { sum += aovs_[0][pixel][channel].value(); });
        sum += -by_camera_[cell][channel].value();
        return sum;
    }

    std::uint64_t dropped() const { return counts_[kDropped].load(); }
    std::uint64_t saturated() const { return counts_[kSaturated].load(); }

private:
    static constexpr std::size_t kDropped = 0;
    static constexpr std::size_t kSaturated = 1;

    const std::vector<Pixel>& at(Aov aov) const { return aovs_[static_cast<std::size_t>(aov)]; }

    static bool finite(const Vec3& v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    }
    static FixedPoint term_of(float x) { return FixedPoint::from_double(cut_term(double{x})); }

    /// Returns whether a value is finite, and counts it if not.
    bool is_finite(const Vec3& v) {
        if (finite(v)) return true;
        counts_[kDropped].fetch_add(1, std::memory_order_relaxed);
        return false;
    }

    static void add_alone(Pixel& pixel, const std::array<FixedPoint, 3>& terms) {
        for (unsigned c = 0; c < 3; ++c) pixel[c].add_alone(terms[c]);
    }

    void add(Pixel& pixel, const Vec3& rgb) {
        for (unsigned c = 0; c < 3; ++c) {
            const float x = rgb[static_cast<int>(c)];
            if (x == 0) continue;
            const double term = cut_term(double{x});
            if (term != static_cast<double>(x))
                counts_[kSaturated].fetch_add(1, std::memory_order_relaxed);
            pixel[c].add(FixedPoint::from_double(term));
        }
    }

    std::size_t pixels_;
    std::array<std::vector<Pixel>, kAovCount> aovs_;
    std::optional<BlockGrid> photon_cells_;
    std::vector<Pixel> by_camera_;  // part of the total, by cell
    std::vector<std::vector<Pixel>> lights_;
    std::vector<std::atomic<std::uint64_t>> counts_ = std::vector<std::atomic<std::uint64_t>>(2);
};

}  // namespace sunfleck::engine
