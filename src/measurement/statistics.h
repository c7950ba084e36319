// What a pass counts: integers, so that their sums are the same in any order.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace sunfleck {

enum class Count : std::size_t {
    eye_rays,
    photon_rays,
    camera_paths,
    visible_points,
    uniform_paths,
    mapped_paths,
    uniform_visible,
    mapped_visible,
    mutated_paths,
    accepted_paths,
    distinct_visible,
    visible_states,
    photons_stored,
    deposits,
    escaped,
    too_long,
    dropped_nonfinite,
    saturated,
    count
};

struct CountRow {
    Count count;
    std::string_view name;  // in film files and stats.json
    std::string_view what;
};

inline constexpr std::size_t kCounts = static_cast<std::size_t>(Count::count);

inline constexpr std::array<CountRow, kCounts> kCountRows = {{
    {Count::eye_rays, "eye_rays", "rays of camera paths and of direct light"},
    {Count::photon_rays, "photon_rays", "rays of photon paths"},
    {Count::camera_paths, "camera_paths", "camera paths that end in visible points"},
    {Count::visible_points, "visible_points", "visible points"},
    {Count::uniform_paths, "uniform_paths", "photon paths traced from uniform numbers"},
    {Count::mapped_paths, "mapped_paths", "photon paths whose emission went through a map"},
    {Count::uniform_visible, "uniform_visible",
     "uniform paths deposited at a visible point or more"},
    {Count::mapped_visible, "mapped_visible", "the same of mapped paths"},
    {Count::mutated_paths, "mutated_paths", "photon paths proposed by mutation"},
    {Count::accepted_paths, "accepted_paths", "of these, accepted"},
    {Count::distinct_visible, "distinct_visible", "different photon paths that brought light"},
    {Count::visible_states, "visible_states", "the same, repeats of a chain counted each"},
    {Count::photons_stored, "photons_stored", "photons that at least one visible point took"},
    {Count::deposits, "deposits", "photons times the visible points that took them"},
    {Count::escaped, "escaped", "photon paths that left the scene"},
    {Count::too_long, "too_long", "photon paths cut at the greatest depth"},
    {Count::dropped_nonfinite, "dropped_nonfinite", "contributions that were not finite"},
    {Count::saturated, "saturated", "contributions cut at the range of the exact sums"},
}};

struct Statistics {
    std::array<std::uint64_t, kCounts> value{};

    std::uint64_t& operator[](Count which) { return value[static_cast<std::size_t>(which)]; }
    std::uint64_t operator[](Count which) const { return value[static_cast<std::size_t>(which)]; }
    Statistics& operator+=(const Statistics& other) {
        for (std::size_t i = 0; i < kCounts; ++i) value[i] += other.value[i];
        return *this;
    }
    friend bool operator==(const Statistics&, const Statistics&) = default;
};

}  // namespace sunfleck
