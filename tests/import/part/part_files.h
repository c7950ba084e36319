// Small parts for tests: written to a folder of their own.
#pragma once

#include "import/part/reader.h"
#include "sunfleck/error.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace sunfleck::engine::testing_support {

/// A closed tetrahedron with corners at 0, x, y and z, which faces outwards.
inline const std::string kTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
/// The same without its last face.
inline const std::string kOpenTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n";

/// A picture of one row of colours, as PFM.
inline std::string pfm(const std::vector<float>& rgb) {
    std::string bytes = "PF\n" + std::to_string(rgb.size() / 3) + " 1\n-1.0\n";
    const std::size_t head = bytes.size();
    bytes.resize(head + rgb.size() * sizeof(float));
    std::memcpy(bytes.data() + head, rgb.data(), rgb.size() * sizeof(float));
    return bytes;
}

class PartFolder : public testing::Test {
protected:
    void SetUp() override { std::filesystem::create_directories(folder_ + "/sub"); }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string path(const std::string& name) const { return folder_ + "/" + name; }
    /// Writes a file. @return its path.
    std::string written(const std::string& name, const std::string& bytes) const {
        std::ofstream(path(name), std::ios::binary) << bytes;
        return path(name);
    }

    /// Returns the scene of an OBJ file with this text.
    SceneDescription read(const std::string& text, const ImportSettings& settings = {}) const {
        return read_part(written("a.obj", text), settings);
    }
    /// Returns the scene of a tetrahedron with one material.
    SceneDescription with_material(const std::string& mtl, const std::string& mesh = kTetrahedron,
                                   const ImportSettings& settings = {}) const {
        written("a.mtl", "newmtl m\n" + mtl);
        return read("mtllib a.mtl\nusemtl m\n" + mesh, settings);
    }

    /// Returns what the Error says, without the folder; "" if there is none.
    std::string fault_of(const std::string& text, const ImportSettings& settings = {}) const {
        try {
            read(text, settings);
        } catch (const Error& error) {
            return plain(error.what());
        }
        return "";
    }
    /// Returns all warnings, one a line, without the folder.
    std::string warnings_of(const SceneDescription& scene) const {
        std::string all;
        for (const Warnings::Entry& entry : scene.warnings.entries())
            all += plain(entry.line()) + "\n";
        return all;
    }

private:
    std::string plain(std::string text) const {
        for (std::size_t at = text.find(folder_ + "/"); at != std::string::npos;
             at = text.find(folder_ + "/"))
            text.erase(at, folder_.size() + 1);
        return text;
    }

    std::string folder_ = (std::filesystem::path(testing::TempDir()) /
                           ("sunfleck_part_" + std::to_string(::getpid())))
                              .string();
};

inline const TriangleMesh& mesh_of(const ShapeDescription& shape) {
    return std::get<TriangleMesh>(shape.placed.shape);
}

}  // namespace sunfleck::engine::testing_support
