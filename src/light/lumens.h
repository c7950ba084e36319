// Watts and lumens.
#pragma once

namespace sunfleck::engine {

/// Photometric quantities (candela, lux, nits) are divided by this to become radiometric ones of
/// the same luminance: as many lumens are seen of a watt at most.
inline constexpr double kLumensPerWatt = 683;

}  // namespace sunfleck::engine
