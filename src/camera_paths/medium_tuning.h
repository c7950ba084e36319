// The constants of visible points in media.
#pragma once

namespace sunfleck::engine {

/// Length of a piece of a ray in which photons count, over the radius of its cylinder: longer ones
/// hold more photons, and have larger boxes around them.
inline constexpr float kPieceOverRadius = 16;
/// The same over the wider radius for indirect light.
inline constexpr float kPieceOverWideRadius = 4;

/// Indirect light is smooth in media, and photons are few: its cylinders are up to so many times as
/// wide, but less than this part of the distance before which half of the light is scattered.
inline constexpr float kMostWidening = 16;
inline constexpr float kPartOfDistance = 0.1F;

}  // namespace sunfleck::engine
