// A small reader of our own scene files, independent of the importer: words, shapes, meshes.
#pragma once

#include "procedural/mesh.h"
#include "procedural/scenes.h"

#include <algorithm>
#include <bit>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// The words of a pbrt file: quoted strings with their opening quote, brackets, and the rest.
/// @throws std::runtime_error for a string that its line does not close.
inline std::vector<std::string> pbrt_words(const std::string& text) {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        std::size_t end = i + 1;
        if (c == '#') {
            i = std::min(text.find('\n', i), text.size());
            continue;
        }
        if (c == '"') {
            end = text.find_first_of("\"\n", i + 1);
            if (end == std::string::npos || text[end] == '\n')
                throw std::runtime_error("open string");
            words.push_back(text.substr(i, end - i));
            ++end;
        } else if (c == '[' || c == ']') {
            words.emplace_back(1, c);
        } else if (c != ' ' && c != '\n') {
            end = std::min(text.find_first_of(" \n[]\"#", i), text.size());
            words.push_back(text.substr(i, end - i));
        }
        i = end;
    }
    return words;
}

/// The numbers in brackets that follow the parameter of this name, searched from `first`.
inline std::vector<float> pbrt_numbers(const std::vector<std::string>& words, std::size_t first,
                                       const std::string& parameter) {
    auto at = std::find(words.begin() + static_cast<std::ptrdiff_t>(first), words.end(),
                        "\"" + parameter);
    if (at == words.end()) throw std::runtime_error("no " + parameter);
    std::vector<float> numbers;
    for (at += 2; at != words.end() && *at != "]"; ++at) numbers.push_back(std::stof(*at));
    return numbers;
}

/// The index that was set last before a file of geometry is named. @throws std::runtime_error.
inline double eta_of(const std::vector<std::string>& words, const std::string& file) {
    const auto name = std::find(words.begin(), words.end(), "\"" + file);
    const auto eta = std::find(std::reverse_iterator(name), words.rend(), "\"float eta");
    if (name == words.end() || eta == words.rend()) throw std::runtime_error("no eta of " + file);
    return std::stod(*eta.base());
}

inline Mesh ply_mesh(const std::string& bytes) {
    Mesh mesh;
    std::istringstream header(bytes);
    std::string line;
    std::size_t points = 0;
    std::size_t faces = 0;
    std::size_t floats = 3;  // a vertex
    for (std::getline(header, line); line != "end_header"; std::getline(header, line)) {
        if (!header) throw std::runtime_error("no end_header");
        if (line.starts_with("element vertex ")) points = std::stoul(line.substr(15));
        if (line == "property float nx") floats = 6;
        if (line.starts_with("element face ")) faces = std::stoul(line.substr(13));
    }
    const auto begin = static_cast<std::size_t>(header.tellg());
    const std::size_t vertices = points * floats * 4;
    if (bytes.size() != begin + vertices + faces * 13) throw std::runtime_error("wrong size");
    const auto word = [&](std::size_t at) {
        std::uint32_t value = 0;
        for (std::size_t i = 4; i-- > 0;)
            value = value << 8U | static_cast<unsigned char>(bytes[begin + at + i]);
        return value;
    };
    const auto number = [&](std::size_t at) { return std::bit_cast<float>(word(at)); };
    const auto triple = [&](std::size_t at) {
        return std::array<float, 3>{number(at), number(at + 4), number(at + 8)};
    };
    for (std::size_t at = 0; at < vertices; at += floats * 4) {
        mesh.points.push_back(triple(at));
        if (floats == 6) mesh.normals.push_back(triple(at + 12));
    }
    for (std::size_t at = vertices; at < vertices + 13 * faces; at += 13) {
        if (bytes[begin + at] != 3) throw std::runtime_error("not a triangle");
        mesh.triangles.push_back({word(at + 1), word(at + 5), word(at + 9)});
    }
    return mesh;
}

inline Mesh text_mesh(const std::vector<std::string>& words, std::size_t shape) {
    Mesh mesh;
    const std::vector<float> p = pbrt_numbers(words, shape, "point3 P");
    for (std::size_t i = 0; i + 2 < p.size(); i += 3)
        mesh.points.push_back({p[i], p[i + 1], p[i + 2]});
    const std::vector<float> t = pbrt_numbers(words, shape, "integer indices");
    for (std::size_t i = 0; i + 2 < t.size(); i += 3)
        mesh.triangles.push_back({static_cast<std::uint32_t>(t[i]),
                                  static_cast<std::uint32_t>(t[i + 1]),
                                  static_cast<std::uint32_t>(t[i + 2])});
    return mesh;
}

/// All meshes of a scene in the order of its file. (Its spheres are no meshes.)
inline std::vector<Mesh> scene_meshes(const std::vector<SceneFile>& files) {
    const std::vector<std::string> words = pbrt_words(files.at(0).bytes);
    std::vector<Mesh> meshes;
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        if (words[i] != "Shape" || words[i + 1] == "\"sphere") continue;
        if (words[i + 1] == "\"trianglemesh") {
            meshes.push_back(text_mesh(words, i));
            continue;
        }
        const auto file = std::find_if(files.begin(), files.end(), [&](const SceneFile& f) {
            return "\"" + f.name == words.at(i + 3);
        });
        if (file == files.end()) throw std::runtime_error("no file " + words.at(i + 3));
        meshes.push_back(ply_mesh(file->bytes));
    }
    return meshes;
}

}  // namespace sunfleck::engine
