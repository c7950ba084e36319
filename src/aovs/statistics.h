// What a pass counts: integers, so that their sums are the same in any order.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace sunfleck::engine {

enum class Count : std::size_t {
    camera_rays,        // rays of camera paths and of direct light
    photon_rays,        // rays of photon paths
    camera_paths,       // camera paths
    visible_points,     // visible points
    uniform_paths,      // photon paths traced from uniform numbers
    guided_paths,       // photon paths whose emission the guide chose
    uniform_visible,    // uniform paths with a photon that a visible point takes
    guided_visible,     // the same of mapped paths
    mutated_paths,      // photon paths proposed by mutation
    accepted_paths,     // of these, accepted
    distinct_visible,   // different photon paths that brought light
    visible_states,     // the same, repeats of a chain counted each
    photons_stored,     // photons that at least one visible point took
    deposits,           // photons times the visible points that took them
    escaped,            // photon paths that left the scene
    too_long,           // photon paths cut at the greatest depth
    dropped_nonfinite,  // contributions that were not finite
    saturated,          // contributions cut at the range of the exact sums
    count
};

struct CountRow {
    Count count;
    std::string_view name;  // in film files and stats.json
};

inline constexpr std::size_t kCounts = static_cast<std::size_t>(Count::count);

inline constexpr std::array<CountRow, kCounts> kCountRows = {{
    {Count::camera_rays, "camera_rays"},
    {Count::photon_rays, "photon_rays"},
    {Count::camera_paths, "camera_paths"},
    {Count::visible_points, "visible_points"},
    {Count::uniform_paths, "uniform_paths"},
    {Count::guided_paths, "guided_paths"},
    {Count::uniform_visible, "uniform_visible"},
    {Count::guided_visible, "guided_visible"},
    {Count::mutated_paths, "mutated_paths"},
    {Count::accepted_paths, "accepted_paths"},
    {Count::distinct_visible, "distinct_visible"},
    {Count::visible_states, "visible_states"},
    {Count::photons_stored, "photons_stored"},
    {Count::deposits, "deposits"},
    {Count::escaped, "escaped"},
    {Count::too_long, "too_long"},
    {Count::dropped_nonfinite, "dropped_nonfinite"},
    {Count::saturated, "saturated"},
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

}  // namespace sunfleck::engine
