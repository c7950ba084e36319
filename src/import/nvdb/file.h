// Files of NanoVDB (.nvdb): which grids there are, and the bytes of one.
//
// Source: OpenVDB's nanovdb/util/IO.h (Mozilla Public License), for the format alone.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sunfleck::engine {

/// What a file says of a grid before its bytes.
struct NvdbGridHead {
    std::string name;
    std::uint32_t type = 0;        // 1: float
    std::uint32_t grid_class = 0;  // 0: unknown, 2: fog volume
    std::uint16_t codec = 0;       // 0: none, 1: zip, 2: Blosc
    std::uint64_t size = 0;        // of its bytes when unpacked
    std::string_view packed;       // its bytes in the file
};

/// Returns the grids of all segments, whose bytes are all in the file.
/// @param name  of the file, for errors.
/// @throws Error  for another kind of file, another version of the format, and what is cut short.
std::vector<NvdbGridHead> nvdb_grids(std::string_view file, const std::string& name);

/// Returns the unpacked bytes of a grid.
/// @throws Error  for Blosc's codec, and for damaged bytes.
std::string unpacked_grid(const NvdbGridHead& grid, const std::string& name);

/// Refuses a version of the format that is not read. @param where  the file's name.
void check_nvdb_version(std::uint32_t version, const std::string& where);

}  // namespace sunfleck::engine
