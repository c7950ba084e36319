// GltfDocument: a glTF 2.0 file, with its buffers in memory.
//
// In:  a .gltf file with its parts beside it or in data URIs, or a .glb file. Out: JSON with places
// for messages, and the bytes of buffer views.
// Source: Khronos Group, glTF 2.0 Specification (2021), sections 3.6 and 4.
#pragma once

#include "core/missing_files.h"
#include "import/gltf/json_place.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

/// Returns the bytes of a file that a scene names. @throws Error, or MissingFile.
using GltfFileAccess =
    std::function<std::string(const std::string& path, const SourceLocation& from)>;

class GltfDocument {
public:
    /// Reads a file and its buffers.
    /// @throws Error  for what is not glTF 2.0, is damaged or misses a part: for all parts at once.
    explicit GltfDocument(const std::string& path);
    /// Takes the bytes of the main file. @param files  reads the others.
    GltfDocument(const std::string& path, std::string bytes, GltfFileAccess files);

    JsonPlace root() const { return {json_, path_, ""}; }
    /// Returns the number of elements of a list of the root; 0 if there is no such list.
    std::size_t count(std::string_view list) const;
    /// Returns element `index` of a list of the root, such as "meshes". @param index  in the list.
    JsonPlace element(std::string_view list, const JsonPlace& index) const;

    /// Returns the bytes of a buffer view. @param view  of "bufferViews".
    /// @throws Error  for one beyond its buffer.
    std::string_view bytes_of(const JsonPlace& view) const;

    /// Returns the bytes of a URI: of the data within, or of a file beside the scene, which is
    /// listed. A missing file is noted, and its bytes are empty.
    std::string read(const JsonPlace& uri);
    /// @throws Error  that names all files that are missing, if any are.
    void check_missing() const;

    /// Returns the program that wrote the file; empty if the file does not say.
    const std::string& generator() const { return generator_; }
    const std::string& path() const { return path_; }
    /// Returns the paths of all files that were read, the main one among them.
    const std::vector<std::string>& files() const { return files_; }

private:
    void parse(std::string bytes);
    void parse_binary(std::string_view bytes);
    void parse_json(std::string_view text);
    void load_buffers();
    void unpack_views();

    std::string path_;
    GltfFileAccess access_;
    std::string generator_;
    nlohmann::json json_;
    std::string chunk_;                                  // binary chunk of a .glb
    std::vector<std::string> buffers_;                   // as many as "buffers" has
    std::map<const void*, std::string> unpacked_views_;  // by their identity
    std::vector<std::string> files_;
    MissingFiles missing_;
};

}  // namespace sunfleck::engine
