// Segments: a header, the heads of the grids, their bytes.
#include "import/nvdb/file.h"

#include "core/file_content.h"
#include "core/printable.h"
#include "core/zlib_stream.h"
#include "import/nvdb/bytes.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

constexpr std::string_view kMagics[] = {"NanoVDB0", "NanoVDB2"};  // up to 32.5, and from 32.6 on
constexpr std::uint32_t kMajor = 32;
constexpr std::size_t kSegmentHead = 16;
constexpr std::size_t kGridHead = 176;
constexpr std::size_t kLongestName = 4096;

bool is_magic(std::string_view bytes) {
    return std::find(std::begin(kMagics), std::end(kMagics), bytes) != std::end(kMagics);
}

/// Where a grid's bytes are, which follow the heads of all grids of a segment.
struct Head {
    NvdbGridHead grid;
    std::uint64_t packed_size = 0;
};

/// @param at  where the head begins; then, where the next one does.
Head read_head(const NvdbBytes& file, std::uint64_t& at, std::uint16_t codec) {
    Head head;
    head.grid.size = file.at<std::uint64_t>(at);
    head.packed_size = file.at<std::uint64_t>(at + 8);
    head.grid.type = file.at<std::uint32_t>(at + 32);
    head.grid.grid_class = file.at<std::uint32_t>(at + 36);
    head.grid.codec = codec;
    const auto length = file.at<std::uint32_t>(at + 136);
    if (length > kLongestName)
        file.refuse("has a grid of a name that is too long", "write it again");
    const std::string_view name = file.part(at + kGridHead, length);
    head.grid.name = std::string(name.substr(0, name.find('\0')));
    at += kGridHead + length;
    return head;
}

/// @param at  where the segment begins; then, where it ends.
void read_segment(const NvdbBytes& file, std::uint64_t& at, std::vector<NvdbGridHead>& grids) {
    if (!is_magic(file.part(at, 8)))
        file.refuse("has bytes of no NanoVDB grid after its grids", "copy or write it again");
    check_nvdb_version(file.at<std::uint32_t>(at + 8), file.name());
    const auto count = file.at<std::uint16_t>(at + 12);
    const auto codec = file.at<std::uint16_t>(at + 14);
    at += kSegmentHead;
    std::vector<Head> heads;
    for (std::size_t i = 0; i < count; ++i) heads.push_back(read_head(file, at, codec));
    for (Head& head : heads) {
        head.grid.packed = file.part(at, head.packed_size);
        at += head.packed_size;
        grids.push_back(std::move(head.grid));
    }
}

}  // namespace

void check_nvdb_version(std::uint32_t version, const std::string& where) {
    const std::uint32_t major = version >> 21U;
    if (major == kMajor) return;
    throw Error({where},
                "is of NanoVDB's format " + std::to_string(major) + "." +
                    std::to_string(version >> 10U & 0x7FFU) + "." +
                    std::to_string(version & 0x3FFU) + ", of which only versions " +
                    std::to_string(kMajor) + ".* are read",
                "write it again by a NanoVDB of OpenVDB 8.1 to 12");
}

std::vector<NvdbGridHead> nvdb_grids(std::string_view file, const std::string& name) {
    if (!is_magic(file.substr(0, 8))) {
        refuse_other_content(file, name, "a NanoVDB grid");
        throw Error({name}, "is no NanoVDB file", "write one, by nanovdb_convert for example");
    }
    const NvdbBytes bytes(file, name);
    std::vector<NvdbGridHead> grids;
    for (std::uint64_t at = 0; at < file.size();) read_segment(bytes, at, grids);
    return grids;
}

std::string unpacked_grid(const NvdbGridHead& grid, const std::string& name) {
    const NvdbBytes packed(grid.packed, name);
    if (grid.codec == 0) return std::string(packed.part(0, grid.size));
    if (grid.codec != 1)
        packed.refuse(grid.codec == 2 ? "is packed by Blosc, which is not read"
                                      : "is packed in an unknown way",
                      "write it with the codec zip or none, by nanovdb_convert -z for example");
    const auto size = packed.at<std::uint64_t>(0);
    if (auto bytes = inflated(packed.part(8, size), grid.size)) return *std::move(bytes);
    packed.refuse("has damaged bytes in grid " + in_quotes(grid.name), "copy or write it again");
}

}  // namespace sunfleck::engine
