// Units of glTF: photometric, in metres.
#pragma once

namespace sunfleck::engine {

/// glTF has candela, lux and nits; ours are watts, of which as many lumens are seen at most.
inline constexpr double kLumensPerWatt = 683;

/// The most candela, lux or nits of a light: a float holds what becomes of it.
inline constexpr double kMostLight = 1e30;

}  // namespace sunfleck::engine
