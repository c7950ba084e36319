// Handles of the ray tracing library that release themselves, and its devices.
#pragma once

#include <embree3/rtcore.h>

#include <memory>
#include <string>
#include <type_traits>

namespace sunfleck::engine::embree {

/// Coordinates beyond this are too large for the library, which may stop the program at them.
inline constexpr double kLargest = 1e18;

struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
template <class Handle>
using Owner = std::unique_ptr<std::remove_pointer_t<Handle>, Release>;
using Device = Owner<RTCDevice>;
using Scene = Owner<RTCScene>;
using Geometry = Owner<RTCGeometry>;

/// The device for "avx2" (if the processor has it) or "native"; opened once, then shared.
/// @throws std::runtime_error for any other word, or when it cannot be opened.
Device open_device(const std::string& isa);

Geometry new_geometry(RTCDevice device, RTCGeometryType type);

/// An empty scene: robust, medium quality.
Scene new_scene(RTCDevice device);

/// Builds the tree. @throws std::runtime_error with the library's words when that fails.
void commit(RTCScene scene);

/// @throws std::runtime_error when an earlier call of this thread went wrong.
void check(RTCDevice device);

}  // namespace sunfleck::engine::embree
