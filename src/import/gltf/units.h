// Units of glTF: photometric, in metres.
#pragma once

namespace sunfleck::engine {

/// glTF has candela, lux and nits; ours are watts, of which as many lumens are seen at most.
inline constexpr double kLumensPerWatt = 683;

}  // namespace sunfleck::engine
