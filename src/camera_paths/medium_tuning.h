// The constants of visible points in media.
#pragma once

namespace sunfleck::engine {

/// Length of a piece of a ray in which photons count, over the radius of its cylinder: longer ones
/// hold more photons, and have larger boxes around them.
inline constexpr float kPieceOverRadius = 64;
/// The same over the wider radius for indirect light.
inline constexpr float kPieceOverWideRadius = 16;

/// The most that the radius may be of the length over which half of the light is scattered: wider
/// cylinders blur what a dense medium does over its free path (docs/lab/media.md).
inline constexpr float kMostOfScale = 0.35F;
/// But the least that it is of the pixel's width then, so that some photons are found.
inline constexpr float kLeastOfPixel = 0.125F;

/// Indirect light is smooth in media, and photons are few: its cylinders are up to so many times as
/// wide, but less than this part of the length over which half of the light is scattered.
inline constexpr float kMostWidening = 16;
inline constexpr float kPartOfScale = 0.1F;

}  // namespace sunfleck::engine
