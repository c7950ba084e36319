// Names in a folder of snapshots (sunfleck render --snapshots) beside those that are numbered.
#pragma once

#include <string_view>

namespace sunfleck::engine {

/// The newest snapshot's picture once more, as it is and as a screen shows it.
inline constexpr std::string_view kLatestExr = "latest.exr";
inline constexpr std::string_view kLatestPng = "latest.png";

inline bool is_latest_snapshot(std::string_view name) {
    return name == kLatestExr || name == kLatestPng;
}

}  // namespace sunfleck::engine
