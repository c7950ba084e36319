// Containers, JSON and buffers of glTF.
#include "import/gltf/document.h"

#include "core/file_content.h"
#include "import/gltf/meshopt.h"
#include "import/gltf/uri.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <optional>

namespace sunfleck::engine {
namespace {

constexpr std::string_view kMeshopt = "EXT_meshopt_compression";
constexpr std::string_view kMagic = "glTF";
constexpr std::size_t kHead = 12;  // magic, version, length
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;

std::uint32_t word_at(std::string_view bytes, std::size_t place) {
    std::uint32_t word = 0;
    for (std::size_t i = 4; i-- > 0;)
        word = word << 8U | static_cast<unsigned char>(bytes[place + i]);
    return word;
}

/// Line and column of a byte.
SourceLocation location_of(const std::string& file, std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, std::min(byte, text.size()));
    const auto lines = std::count(before.begin(), before.end(), '\n');
    const std::size_t line_begin = before.rfind('\n') + 1;  // 0 without one
    return {file, static_cast<int>(lines) + 1, static_cast<int>(before.size() - line_begin) + 1};
}

}  // namespace

GltfDocument::GltfDocument(const std::string& path)
    : GltfDocument(path, read_input_file(path, {path}), read_input_file) {}

GltfDocument::GltfDocument(const std::string& path, std::string bytes, GltfFileAccess files)
    : path_(path), access_(std::move(files)) {
    files_.push_back(path);
    parse(std::move(bytes));
    const JsonPlace asset = root().at("asset");
    const std::string version = asset.text("version", "");
    if (!version.starts_with("2."))
        asset.refuse("is of glTF version \"" + version + "\"", "export it as glTF 2.0");
    generator_ = asset.text("generator", "");
    load_buffers();
    if (has_meshopt()) unpack_views();
}

void GltfDocument::parse(std::string bytes) {
    if (bytes.starts_with(kMagic)) return parse_binary(bytes);
    const std::string_view text = without_mark(bytes);
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    const bool is_json =
        first != std::string_view::npos && (text[first] == '{' || text[first] == '[');
    if (!is_json) refuse_other_content(bytes, path_, "a glTF scene");
    parse_json(text);
}

void GltfDocument::parse_binary(std::string_view bytes) {
    const auto damaged = [&](const std::string& what) {
        return Error({path_}, what, "export or copy the file again");
    };
    if (bytes.size() < kHead) throw damaged("ends in its head");
    if (word_at(bytes, 4) != 2)
        throw damaged("is a binary glTF file of version " + std::to_string(word_at(bytes, 4)) +
                      ", not 2");
    if (word_at(bytes, 8) > bytes.size())
        throw damaged("has " + std::to_string(bytes.size()) + " bytes of " +
                      std::to_string(word_at(bytes, 8)));
    bytes = bytes.substr(0, word_at(bytes, 8));
    std::string_view json;
    for (std::size_t at = kHead; at + 8 <= bytes.size();) {
        const std::size_t size = word_at(bytes, at);
        const std::uint32_t type = word_at(bytes, at + 4);
        at += 8;
        if (size > bytes.size() - at)
            throw damaged("byte " + std::to_string(at) + ": a chunk is longer than the file");
        const std::string_view chunk = bytes.substr(at, size);
        if (type == kJsonChunk && json.empty()) json = chunk;
        if (type == kBinaryChunk && chunk_.empty()) chunk_ = chunk;
        at += size;
    }
    if (json.empty()) throw damaged("has no JSON");
    parse_json(json);
}

void GltfDocument::parse_json(std::string_view text) {
    try {
        json_ = nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& fault) {
        throw Error(location_of(path_, text, fault.byte > 0 ? fault.byte - 1 : 0),
                    "is not valid JSON here", "export or copy the file again");
    } catch (const nlohmann::json::exception&) {
        throw Error({path_}, "has a number that is too large for JSON", "export the file again");
    }
    if (!json_.is_object()) throw Error({path_}, "is JSON, but not a glTF scene", "name a scene");
}

std::size_t GltfDocument::count(std::string_view list) const {
    const auto found = root().find(list);
    return found ? found->size() : 0;
}

JsonPlace GltfDocument::element(std::string_view list, const JsonPlace& index) const {
    const auto all = root().find(list);
    if (!all)
        index.refuse("names one of " + std::string(list) + ", of which there are none",
                     "export the file again");
    return (*all)[index.index(all->size(), list)];
}

std::string GltfDocument::read(const JsonPlace& uri) {
    const std::string text = uri.text();
    if (is_data_uri(text)) {
        auto data = data_of(text);
        if (!data) uri.refuse("is not valid base64", "export the file again");
        return std::move(data->bytes);
    }
    if (text.empty()) uri.refuse("is an empty name", "name the file");
    const std::filesystem::path folder = std::filesystem::path(path_).parent_path();
    std::optional<MissingFile> fault;
    for (const std::string& name : names_of_file(text)) {
        const std::string path = (folder / name).lexically_normal().string();
        try {
            std::string bytes = access_(path, uri.where());
            if (std::find(files_.begin(), files_.end(), path) == files_.end())
                files_.push_back(path);
            return bytes;
        } catch (const MissingFile& missing) {
            if (!fault) fault = missing;
        }
    }
    missing_.note(*fault);
    return {};
}

void GltfDocument::check_missing() const {
    const std::size_t count = missing_.files().size();
    if (count == 0) return;
    if (count == 1) throw MissingFile(missing_.files().front());
    throw Error({path_}, std::to_string(count) + " files are missing: " + missing_.line(),
                "put them beside the scene");
}

void GltfDocument::load_buffers() {
    for (const JsonPlace& buffer : root().elements("buffers")) {
        const std::uint64_t size = buffer.at("byteLength").whole();
        const auto uri = buffer.find("uri");
        const auto packed = buffer.extension(kMeshopt);
        const bool is_void = !uri && packed && packed->flag("fallback", false);
        buffers_.push_back(uri ? read(*uri) : is_void ? std::string() : std::move(chunk_));
        const bool is_missing = (!missing_.files().empty() && buffers_.back().empty()) || is_void;
        if (buffers_.back().size() < size && !is_missing)
            buffer.refuse("has " + std::to_string(buffers_.back().size()) + " bytes of " +
                              std::to_string(size),
                          "export or copy the file again");
    }
    check_missing();
}

void GltfDocument::unpack_views() {
    for (const JsonPlace& view : root().elements("bufferViews"))
        if (const auto packed = view.extension(kMeshopt))
            unpacked_views_[view.identity()] = unpack_meshopt(*packed, bytes_of(*packed));
}

std::string_view GltfDocument::bytes_of(const JsonPlace& view) const {
    const auto unpacked = unpacked_views_.find(view.identity());
    if (unpacked != unpacked_views_.end()) return unpacked->second;
    const std::size_t number = view.at("buffer").index(buffers_.size(), "buffer");
    const std::string_view buffer = buffers_[number];
    const std::uint64_t begin = view.whole("byteOffset", 0);
    const std::uint64_t size = view.at("byteLength").whole();
    if (begin > buffer.size() || size > buffer.size() - begin)
        view.refuse("is beyond the end of its buffer", "export the file again");
    return buffer.substr(static_cast<std::size_t>(begin), static_cast<std::size_t>(size));
}

}  // namespace sunfleck::engine
