// Fuzz target: any bytes as a file of a spectrum end in a spectrum or in an Error of one line.
#include "import/pbrt/reader.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it by this name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    // One for a surface, one for a light: the second is divided by its luminance.
    static const std::string scene =
        "WorldBegin Material \"diffuse\" \"spectrum reflectance\" \"a.spd\" Shape \"sphere\" "
        "LightSource \"infinite\" \"spectrum L\" \"a.spd\"";
    const auto files = [&](const std::string&, const sunfleck::SourceLocation&) {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as characters
        return std::string(reinterpret_cast<const char*>(data), size);
    };
    try {
        const auto read = sunfleck::engine::read_pbrt_text(scene, "fuzz.pbrt", files);
        const sunfleck::engine::Spectrum& light = sunfleck::engine::curve(read.lights.at(0));
        for (const float nm : {360.0F, 555.0F, 830.0F})
            if (!(light(nm) >= 0 && std::isfinite(light(nm)))) std::abort();
    } catch (const sunfleck::Error& error) {
        if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
    }
    return 0;
}
