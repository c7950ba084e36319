// Opening of devices and checking of errors.
#include "geometry/embree.h"

#include "core/processor.h"

#include <map>
#include <mutex>
#include <stdexcept>

namespace sunfleck::engine::embree {
namespace {

const char* describe(RTCError code) {
    switch (code) {
        case RTC_ERROR_INVALID_ARGUMENT:
            return "invalid argument";
        case RTC_ERROR_INVALID_OPERATION:
            return "invalid operation";
        case RTC_ERROR_OUT_OF_MEMORY:
            return "out of memory";
        case RTC_ERROR_UNSUPPORTED_CPU:
            return "unsupported processor";
        case RTC_ERROR_CANCELLED:
            return "cancelled";
        default:
            return "unknown error";
    }
}

}  // namespace

void check(RTCDevice device) {
    const RTCError code = rtcGetDeviceError(device);
    if (code != RTC_ERROR_NONE)
        throw std::runtime_error(std::string("Embree could not build the geometry: ") +
                                 describe(code));
}

Device open_device(const std::string& isa) {
    if (isa != "avx2" && isa != "native")
        throw std::runtime_error("unknown instruction set \"" + isa +
                                 R"(" for the geometry; use "avx2" or "native")");
    static std::mutex guard;
    static std::map<std::string, Device> devices;
    const std::lock_guard lock(guard);
    Device& device = devices[isa];
    if (!device) {
        const bool promised = isa == "avx2" && cpu_has_avx2();
        device.reset(rtcNewDevice(promised ? "isa=avx2" : nullptr));
        check(device.get());
    }
    rtcRetainDevice(device.get());
    return Device(device.get());
}

Geometry new_geometry(RTCDevice device, RTCGeometryType type) {
    Geometry geometry(rtcNewGeometry(device, type));
    check(device);
    return geometry;
}

Scene new_scene(RTCDevice device) {
    Scene scene(rtcNewScene(device));
    check(device);
    rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_MEDIUM);
    return scene;
}

void commit(RTCScene scene) {
    rtcCommitScene(scene);
    const Device device(rtcGetSceneDevice(scene));
    check(device.get());
}

}  // namespace sunfleck::engine::embree
