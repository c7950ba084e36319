// Owning handles and devices of Embree, the ray tracing library.
#pragma once

#include <embree3/rtcore.h>

#include <memory>
#include <string>
#include <type_traits>

namespace sunfleck::engine::embree {

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

/// Opens the device for "avx2" (if the processor has it) or "native"; later calls share it.
/// @throws std::runtime_error  for any other word, or if the device cannot be opened.
Device open_device(const std::string& isa);

Geometry new_geometry(RTCDevice device, RTCGeometryType type);

/// Makes an empty scene of robust mode and medium quality.
Scene new_scene(RTCDevice device);

/// Builds the BVH. @throws std::runtime_error  with Embree's message on failure.
void commit(RTCScene scene);

/// @throws std::runtime_error  if an earlier call of this thread failed.
void check(RTCDevice device);

}  // namespace sunfleck::engine::embree
