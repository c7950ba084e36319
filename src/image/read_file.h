// A whole file as bytes, for the readers that parse in memory.
#pragma once

#include "core/error.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace sunfleck {

/// @throws Error if there is no such file, or it cannot be read.
inline std::string read_file(const std::string& path) {
    std::error_code code;
    if (!std::filesystem::is_regular_file(path, code))
        throw Error({path}, "there is no such file", "check the name");
    const std::uintmax_t size = std::filesystem::file_size(path, code);
    std::ifstream file(path, std::ios::binary);
    if (code || !file) throw Error({path}, "cannot be opened", "check that you may read it");
    std::string bytes(size, '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(size));
    if (static_cast<std::uintmax_t>(file.gcount()) != size)
        throw Error({path}, "cannot be read to its end", "check the disk");
    return bytes;
}

}  // namespace sunfleck
