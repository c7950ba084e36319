// Fuzz target: any bytes as an image file end in an image or in an Error of one line.
#include "image/read_image.h"
#include "sunfleck/error.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it by this name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as characters
        const std::string_view bytes(reinterpret_cast<const char*>(data), size);
        sunfleck::engine::Image image = sunfleck::engine::parse_image(bytes, "fuzz.tga");
        image.mend_broken();
        const sunfleck::engine::Vec2i& n = image.resolution();
        if (n.x < 1 || n.y < 1 || image.channels() < 1 || image.channels() > 4) std::abort();
        for (const float value : image.at(n.x - 1, n.y - 1))
            if (!std::isfinite(value)) std::abort();
    } catch (const sunfleck::Error& error) {
        if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
    }
    return 0;
}
