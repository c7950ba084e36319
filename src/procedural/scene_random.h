// Numbers that vary the parts of a scene, the same on every machine.
#pragma once

#include <cstdint>

namespace sunfleck::engine {

/// Numbers of [0, 1) that vary from piece to piece, of a linear congruential rule (Numerical
/// Recipes).
class SceneRandom {
public:
    explicit SceneRandom(std::uint32_t state) : state_(state) {}
    double operator()() {
        state_ = state_ * 1664525U + 1013904223U;
        return static_cast<double>(state_ >> 8U) / 16777216;
    }
    double between(double low, double high) { return low + (high - low) * (*this)(); }

private:
    std::uint32_t state_;
};

}  // namespace sunfleck::engine
