// Small glTF files for tests: written to a folder of their own, with buffers in base64.
#pragma once

#include "import/gltf/reader.h"
#include "sunfleck/error.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace sunfleck::engine::testing_support {

inline std::string base64(const std::string& bytes) {
    static constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits =
                bits << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? kDigits[bits >> (18 - 6 * k) & 63U] : '=';
    }
    return text;
}

template <class Number>
std::string bytes_of(const std::vector<Number>& numbers) {
    std::string bytes(numbers.size() * sizeof(Number), '\0');
    std::memcpy(bytes.data(), numbers.data(), bytes.size());
    return bytes;
}

/// One buffer, as a member "buffers" and a view over all of it.
inline std::string buffer_json(const std::string& bytes) {
    const std::string size = std::to_string(bytes.size());
    return R"("buffers":[{"byteLength":)" + size +
           R"(,"uri":"data:application/octet-stream;base64,)" + base64(bytes) +
           R"("}],"bufferViews":[{"buffer":0,"byteLength":)" + size + "}]";
}

/// Corners of the unit square in the plane z = 0, as three floats each, then six 16-bit indices.
inline std::string square_bytes() {
    return bytes_of<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) +
           bytes_of<std::uint16_t>({0, 1, 2, 0, 2, 3});
}

/// Members of a file with that square as mesh 0, of material 0 if there are materials.
inline std::string square_json(const std::string& of_primitive = "") {
    return buffer_json(square_bytes()) +
           R"(,"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":4},
{"bufferView":0,"byteOffset":48,"componentType":5123,"type":"SCALAR","count":6}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1)" +
           of_primitive + "}]}]";
}

/// The same with texture coordinates, u = x and v = y.
inline std::string textured_square_json(const std::string& of_primitive = "") {
    return buffer_json(square_bytes() + bytes_of<float>({0, 0, 1, 0, 1, 1, 0, 1})) +
           R"(,"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":4},
{"bufferView":0,"byteOffset":48,"componentType":5123,"type":"SCALAR","count":6},
{"bufferView":0,"byteOffset":60,"componentType":5126,"type":"VEC2","count":4}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":2},"indices":1)" +
           of_primitive + "}]}]";
}

/// A test that writes files.
class GltfFiles : public testing::Test {
protected:
    void SetUp() override { std::filesystem::create_directories(folder_); }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string path(const std::string& name) const { return folder_ + "/" + name; }

    /// Writes a file. @return its path.
    std::string written(const std::string& name, const std::string& bytes) const {
        std::ofstream(path(name), std::ios::binary) << bytes;
        return path(name);
    }
    /// Writes a file with these members beside its version. @return its path.
    std::string gltf(const std::string& members) const {
        return written("scene.gltf", R"({"asset":{"version":"2.0"})" +
                                         (members.empty() ? "" : "," + members) + "}");
    }
    SceneDescription read(const std::string& members) const { return read_gltf(gltf(members)); }

    /// Returns what the Error says, without the folder; "" if there is none.
    std::string fault_of(const std::string& members) const { return fault_of_file(gltf(members)); }
    std::string fault_of_file(const std::string& file) const {
        try {
            read_gltf(file);
        } catch (const Error& error) {
            const std::string text = error.what();
            const std::size_t at = text.find(folder_ + "/");
            return at == 0 ? text.substr(folder_.size() + 1) : text;
        }
        return "";
    }

private:
    std::string folder_ = testing::TempDir() + "/sunfleck_gltf_" + std::to_string(::getpid());
};

/// Expects two spectra to be the same.
inline void expect_same(const Spectrum& a, const Spectrum& b) {
    for (const float nm : {420.0F, 480.0F, 550.0F, 610.0F, 680.0F})
        EXPECT_NEAR(a(nm), b(nm), 1e-4F * std::abs(b(nm))) << nm;
}

inline bool warns(const SceneDescription& scene, const std::string& of) {
    for (const Warnings::Entry& entry : scene.warnings.entries())
        if (entry.line().find(of) != std::string::npos) return true;
    return false;
}

}  // namespace sunfleck::engine::testing_support
