// Fuzz target: any bytes as an OpenEXR picture end in all channels of all parts, or in an Error of
// one line.
#include "image/exr.h"
#include "sunfleck/error.h"

#include <cstdint>
#include <cstdlib>
#include <string>

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it by this name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as characters
        const std::string_view bytes(reinterpret_cast<const char*>(data), size);
        const sunfleck::engine::Picture picture = sunfleck::engine::parse_exr(bytes, "fuzz.exr");
        if (picture.width < 1 || picture.height < 1) std::abort();
        for (const sunfleck::engine::Channel& channel : picture.channels)
            if (channel.values.size() != picture.pixels()) std::abort();
    } catch (const sunfleck::Error& error) {
        if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
    }
    return 0;
}
