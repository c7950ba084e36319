// Indices count from 1, or from the end backwards.
#include "import/obj/corners.h"

#include "core/printable.h"

#include <charconv>
#include <string>

namespace sunfleck::engine {
namespace {

constexpr std::array<std::string_view, kObjLists> kWhat = {"vertex", "texture coordinate",
                                                           "normal"};

/// Returns an index as the file counts, or nothing where it is left out.
/// @param at  is moved behind it and behind a slash.
std::optional<std::int64_t> index_at(const char*& at, const char* end, bool& is_good) {
    std::optional<std::int64_t> index;
    if (at != end && *at != '/') {
        std::int64_t value = 0;
        const auto [behind, fault] = std::from_chars(at, end, value);
        is_good = is_good && fault == std::errc() && (behind == end || *behind == '/');
        index = value;
        at = behind;
    }
    if (at != end && *at == '/') ++at;
    return index;
}

}  // namespace

std::optional<ObjCorner> ObjCorners::next(TextCursor& cursor, const ObjCorner& counts) {
    const std::string_view word = cursor.word();
    if (word.empty()) return std::nullopt;
    const std::size_t offset = cursor.offset() - word.size();
    const char* at = word.data();
    const char* const end = at + word.size();
    bool is_good = true;
    ObjCorner corner = {kNoIndex, kNoIndex, kNoIndex};
    for (std::size_t list = 0; list < kObjLists; ++list) {
        const auto stated = index_at(at, end, is_good);
        if (!is_good) break;
        if (!stated) continue;
        const std::int64_t index = *stated < 0 ? *stated + counts.at(list) : *stated - 1;
        if (index < 0 || index >= kNoIndex)
            cursor.fail(offset,
                        std::string(kWhat.at(list)) + " " + std::to_string(*stated) +
                            " does not exist: there are " + std::to_string(counts.at(list)),
                        "indices count from 1, or from -1 backwards");
        corner.at(list) = static_cast<std::uint32_t>(index);
        auto& ahead = ahead_.at(list);
        if (corner.at(list) >= counts.at(list) &&
            (ahead.empty() || ahead.back().index < corner.at(list)))
            ahead.push_back({corner.at(list), offset});
    }
    if (!is_good || at != end || corner[0] == kNoIndex)
        cursor.fail(offset, in_quotes(word, 40) + " is no corner of a face",
                    "write vertex, vertex/texture, vertex//normal or vertex/texture/normal");
    return corner;
}

void ObjCorners::check(const TextCursor& cursor, const ObjCorner& counts) const {
    for (std::size_t list = 0; list < kObjLists; ++list)
        for (const Ahead& ahead : ahead_.at(list))
            if (ahead.index >= counts.at(list))
                cursor.fail(ahead.offset,
                            std::string(kWhat.at(list)) + " " + std::to_string(ahead.index + 1) +
                                " does not exist: the file has " + std::to_string(counts.at(list)),
                            "export the part again");
}

}  // namespace sunfleck::engine
