// Corners of OBJ faces: indices, and what they name.
#pragma once

#include "core/text_cursor.h"
#include "import/obj/mesh.h"

#include <optional>

namespace sunfleck::engine {

/// What a corner's indices count: vertices, texture coordinates, normals.
inline constexpr std::size_t kObjLists = 3;
using ObjCorner = std::array<std::uint32_t, kObjLists>;  // from 0; kNoIndex without

/// Reads the corners of faces, and checks at the end that all they name exists.
class ObjCorners {
public:
    /// Reads the next corner of the line: v, v/vt, v//vn or v/vt/vn.
    /// @param counts  elements read so far, which negative indices count from.
    /// @return nothing at the end of the line.
    /// @throws Error  for what is no corner.
    std::optional<ObjCorner> next(TextCursor& cursor, const ObjCorner& counts);

    /// @param counts  of the whole file. @throws Error  at the first index beyond them.
    void check(const TextCursor& cursor, const ObjCorner& counts) const;

private:
    /// An index of what was not read yet, greater than all before it.
    struct Ahead {
        std::uint32_t index = 0;
        std::size_t offset = 0;  // in the text
    };

    std::array<std::vector<Ahead>, kObjLists> ahead_;
};

}  // namespace sunfleck::engine
