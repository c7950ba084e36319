// FilmKey: what two films must have in common to be shards of one render.
#pragma once

#include "aovs/pass_image.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

struct FilmKey {
    int width = 0;
    int height = 0;
    AovSet aovs{};  // the total is always measured, whatever this says
    std::uint64_t seed = 0;
    std::uint64_t scene_hash = 0;  // of everything in the scene file and its parts
    std::string settings;          // one "name=value" per line: everything that a pass depends on
    bool sequential = false;       // a pass depends on earlier ones: no error bars, no merging
    double alpha = 0;  // of the radius sequence (visible_points/radius.h), which biases the
                       // picture; zero: there are none, or they follow no such sequence
    std::vector<std::string> light_groups{};  // their names: aovs/light_groups.h
    std::uint64_t small_passes = 0;           // the first passes that are: film/pass_weight.h

    friend bool operator==(const FilmKey&, const FilmKey&) = default;

    std::size_t pixels() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    bool has(std::size_t aov) const { return aov == 0 || aovs.at(aov); }
    bool has_discs() const { return alpha > 0; }
};

/// FNV-1a hash, 64 bits, for scene_hash. `before` is the hash of the preceding parts.
constexpr std::uint64_t hash_text(std::string_view text,
                                  std::uint64_t before = 0xCBF29CE484222325) {
    for (const char c : text)
        before = (before ^ static_cast<unsigned char>(c)) * std::uint64_t{0x100000001B3};
    return before;
}

/// A difference between two keys, with both values as text for the user.
struct KeyDifference {
    std::string what;
    std::string here;  // empty if the value is not shown (scenes)
    std::string there;
};

/// Returns the first difference; nothing if the keys are equal.
std::optional<KeyDifference> difference(const FilmKey& here, const FilmKey& there);

}  // namespace sunfleck::engine
