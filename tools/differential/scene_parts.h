// The parts of make_scene: a choice by feature names, random numbers, and the blocks of a scene.
#pragma once

#include "core/random.h"
#include "differential/features.h"
#include "differential/scene_text.h"

#include <fmt/format.h>

#include <string>

namespace sunfleck::engine::differential {

/// What a scene is made from: its features by name, and random numbers.
class Ingredients {
public:
    Ingredients(const FeatureTable& table, const Choice& choice, const RandomStream& random)
        : table_(&table), choice_(&choice), random_(random) {}

    std::string_view operator[](std::string_view feature) const {
        return table_->value(*choice_, feature);
    }
    /// A random number from [low, high), of three digits, as text.
    std::string number(double low, double high) {
        return fmt::format("{:.3g}", low + (high - low) * random_.next());
    }
    /// True for one scene of two.
    bool toss() { return random_.next() < 0.5; }
    /// Three of them, in brackets.
    std::string triple(double low, double high) {
        const std::string x = number(low, high);
        const std::string y = number(low, high);
        return '[' + x + ' ' + y + ' ' + number(low, high) + ']';
    }

private:
    const FeatureTable* table_;
    const Choice* choice_;
    RandomStream random_;
};

/// Camera, film, filter, depth: what stands before the world.
Block view_block(Ingredients& scene);
/// The main light and, where there is one, the second.
std::vector<Block> light_blocks(Ingredients& scene);
/// The object with its material, once or as instances.
std::vector<Block> object_blocks(Ingredients& scene);
/// Its shape alone.
Statement shape_statement(Ingredients& scene);
/// Floor, walls, and the ball beside the object.
std::vector<Block> surroundings(Ingredients& scene);

/// A rectangle by its corners, with (u, v).
Statement quad(const std::string& corners);

}  // namespace sunfleck::engine::differential
