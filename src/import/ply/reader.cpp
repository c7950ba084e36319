// PLY files from their first byte to the mesh.
#include "import/ply/reader.h"

#include "core/file_content.h"
#include "core/gzip.h"
#include "import/ply/body.h"
#include "import/ply/header.h"
#include "import/ply/rows.h"

namespace sunfleck::engine {
namespace {

PlyMesh parse_plain_ply(std::string_view bytes, const std::string& name) {
    bytes = without_mark(bytes);
    if (!bytes.starts_with("ply")) refuse_other_content(bytes, name, "a PLY mesh");
    const PlyHeader header = parse_ply_header(bytes, name);
    return finished_ply(read_rows(header, bytes.substr(header.size), name), name);
}

}  // namespace

PlyMesh parse_ply(std::string_view bytes, const std::string& name) {
    if (!is_gzip(bytes)) return parse_plain_ply(bytes, name);
    return parse_plain_ply(gunzip(bytes, name), name);
}

}  // namespace sunfleck::engine
