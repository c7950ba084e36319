// What one pass adds to each pixel: exact sums that many threads fill at once.
//
// Terms are pixel values of this pass alone (radiance in linear sRGB, or a feature), already
// divided by the number of photon paths; the film's picture is the mean over passes, and a pass
// the mean over its draws.
//
// What eye paths bring can be kept apart: the rest was brought by photons, gathered from discs, and
// alone carries the bias of the disc's radius.
#pragma once

#include "aovs/channels.h"
#include "aovs/light_groups.h"
#include "core/exact_sum.h"
#include "math/vector.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

namespace sunfleck {

/// Which layers are measured; the total always is.
using LayerSet = std::array<bool, kLayerCount>;

class PassImage {
public:
    using Pixel = std::array<AtomicFixedPoint, 3>;

    /// @param photons_apart  by_photons() will be asked for. @param light_layers  how many.
    /// @param draws  of the pass, each of which adds all its light: the image is their mean.
    PassImage(std::size_t pixels, const LayerSet& wanted, bool photons_apart = false,
              std::size_t light_layers = 0, std::uint32_t draws = 1)
        : pixels_(pixels), share_(1 / static_cast<double>(draws)) {
        for (std::size_t i = 0; i < kLayerCount; ++i)
            if (i == 0 || wanted.at(i)) layers_.at(i) = std::vector<Pixel>(pixels);
        if (photons_apart) eye_ = std::vector<Pixel>(pixels);
        for (std::size_t i = 0; i < light_layers; ++i) lights_.emplace_back(pixels);
    }

    std::size_t pixels() const { return pixels_; }
    bool has(Layer layer) const { return !at(layer).empty(); }
    bool photons_apart() const { return !eye_.empty(); }
    std::size_t light_layers() const { return lights_.size(); }

    /// Adds to the total and, if measured, to the layer that owns this light. A value that is not
    /// finite is dropped and counted; one beyond kLargestTerm is cut there and counted.
    void add_light(std::size_t pixel, const Vec3& rgb, Layer owner) {
        if (!is_finite(rgb)) return;
        add(layers_[0][pixel], rgb);
        if (owner != Layer::total && has(owner))
            add(layers_[static_cast<std::size_t>(owner)][pixel], rgb);
    }

    /// add_light() of what no disc has brought.
    void add_eye_light(std::size_t pixel, const Vec3& rgb, Layer owner) {
        add_light(pixel, rgb, owner);
        if (!photons_apart() || !finite(rgb)) return;
        for (unsigned c = 0; c < 3; ++c) eye_[pixel][c].add(term_of(rgb[static_cast<int>(c)]));
    }

    /// Adds what add_light() has added already to the layer of the light that it comes from: cut
    /// and dropped alike, and not counted again. @param layer  kNoLightLayer: nothing is added.
    void add_to_light_layer(std::size_t pixel, const Vec3& rgb, std::uint8_t layer) {
        if (layer == kNoLightLayer || !finite(rgb)) return;
        for (unsigned c = 0; c < 3; ++c)
            lights_[layer][pixel][c].add(term_of(rgb[static_cast<int>(c)]));
    }

    /// add_light() of what is_addable(), with no other thread at this pixel.
    void add_alone(std::size_t pixel, const Vec3& rgb, Layer owner) {
        const std::array<FixedPoint, 3> terms{share_of(rgb.x), share_of(rgb.y), share_of(rgb.z)};
        add_alone(layers_[0][pixel], terms);
        if (owner != Layer::total && has(owner))
            add_alone(layers_[static_cast<std::size_t>(owner)][pixel], terms);
    }

    /// What add_light() will write first: to be called into the cache.
    const void* place_of(std::size_t pixel) const { return &layers_[0][pixel]; }

    /// Would add_light() add all of it?
    static bool is_addable(const Vec3& rgb) {
        const auto fits = [](float x) { return std::abs(static_cast<double>(x)) <= kLargestTerm; };
        return fits(rgb.x) && fits(rgb.y) && fits(rgb.z);
    }

    /// Adds to a feature layer alone, if it is measured.
    void add_feature(std::size_t pixel, const Vec3& value, Layer layer) {
        if (has(layer) && is_finite(value))
            add(layers_[static_cast<std::size_t>(layer)][pixel], value);
    }

    /// Adds to one channel of one layer alone: for light that was summed up elsewhere, as it is.
    void add_term(Layer layer, std::size_t pixel, std::size_t channel, const FixedPoint& term) {
        layers_[static_cast<std::size_t>(layer)][pixel].at(channel).add(term);
    }

    FixedPoint value(Layer layer, std::size_t pixel, std::size_t channel) const {
        return at(layer)[pixel][channel].value();
    }

    FixedPoint light_value(std::size_t light_layer, std::size_t pixel, std::size_t channel) const {
        return lights_[light_layer][pixel][channel].value();
    }

    /// Of the total, what eye paths have not brought. @param channel  of RGB.
    FixedPoint by_photons(std::size_t pixel, std::size_t channel) const {
        FixedPoint sum = layers_[0][pixel][channel].value();
        sum += -eye_[pixel][channel].value();
        return sum;
    }

    std::uint64_t dropped() const { return counts_[kDropped].load(); }
    std::uint64_t saturated() const { return counts_[kSaturated].load(); }

private:
    static constexpr std::size_t kDropped = 0;
    static constexpr std::size_t kSaturated = 1;

    const std::vector<Pixel>& at(Layer layer) const {
        return layers_[static_cast<std::size_t>(layer)];
    }

    static bool finite(const Vec3& v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    }
    FixedPoint share_of(double term) const { return FixedPoint::from_double(term * share_); }
    FixedPoint term_of(float x) const { return share_of(cut_term(double{x})); }

    /// Counts what is not.
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
            pixel[c].add(share_of(term));
        }
    }

    std::size_t pixels_;
    double share_;  // of a draw
    std::array<std::vector<Pixel>, kLayerCount> layers_;
    std::vector<Pixel> eye_;  // part of the total
    std::vector<std::vector<Pixel>> lights_;
    std::vector<std::atomic<std::uint64_t>> counts_ = std::vector<std::atomic<std::uint64_t>>(2);
};

}  // namespace sunfleck
