// Output files that appear whole or not at all: written beside the target, then renamed onto it.
//
// Whoever reads the target sees the old file or the new one, also after a crash: the bytes are on
// the disk before the name is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace sunfleck {

/// A file under way. Without commit() it leaves nothing behind. All faults throw Error.
class AtomicFile {
public:
    /// Creates a temporary file in the folder of `path`. A link is followed to its target.
    explicit AtomicFile(const std::string& path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    AtomicFile(AtomicFile&&) = delete;
    AtomicFile& operator=(AtomicFile&&) = delete;

    /// Writes at the current position, and moves it.
    void write(std::span<const std::byte> bytes);
    /// Moves the position, in bytes from the beginning.
    void seek(std::uint64_t position);
    std::uint64_t position() const { return position_; }

    /// Brings the bytes to the disk and gives them their name. Call it once, last.
    void commit();

private:
    std::string target_;
    std::string temporary_;
    std::uint64_t position_ = 0;
    int descriptor_ = -1;
};

/// Tries, before long work, whether `path` can be written; throws Error if not. The file itself,
/// if there is one, is not touched, and nothing is left behind.
void check_writable(const std::string& path);

/// Removes what processes of this machine that were killed while writing `path` have left beside
/// it: temporary files of processes that live, and all else, stay.
void remove_leftovers(const std::string& path);

/// Writes a whole file, atomically.
void write_file(const std::string& path, std::span<const std::byte> bytes);
/// The same of text.
inline void write_file(const std::string& path, const std::string& text) {
    write_file(path, std::as_bytes(std::span(text)));
}

}  // namespace sunfleck
