// Output files that appear whole or not at all: written beside the target, then renamed onto it.
//
// Whoever reads the target sees the old file or the new one, also after a crash: the bytes are on
// the disk before the name is. The temporary file is locked while its process lives, so that others
// can tell it from one that a killed process has left.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace sunfleck::engine {

/// A file under way. Without commit() it leaves nothing behind. All faults throw Error; those that
/// no other name would mend, MachineFault.
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

    const std::string& target() const { return target_; }
    const std::string& temporary() const { return temporary_; }

private:
    std::string target_;
    std::string temporary_;
    std::size_t place_ = 0;  // among the temporary files of this process
    std::uint64_t position_ = 0;
    int descriptor_ = -1;
};

/// While it lives no other program that asks for a claim gets one on the file, under any of its
/// symbolic links. It is an empty temporary file beside it, which a process that is killed leaves
/// behind; the next claim removes that. The file itself, if there is one, is not touched.
/// Where a file system has no locks, claims exclude nobody.
class OutputClaim {
public:
    /// @throws Error if the file cannot be written, or another program is about to.
    explicit OutputClaim(const std::string& path);

private:
    std::optional<AtomicFile> file_;
};

/// Tries, before long work, whether `path` can be written and claimed; throws Error if not.
/// Nothing is left behind.
inline void check_writable(const std::string& path) {
    const OutputClaim claim(path);
}

/// Whether the folder of `path` takes names for one that differ in their case alone.
/// @throws Error if it cannot be written to.
bool ignores_case(const std::string& path);

/// Removes all temporary files of this process. For an end that runs no destructors: may be called
/// in a signal handler.
void remove_own_temporaries();

/// Writes a whole file, atomically.
void write_file(const std::string& path, std::span<const std::byte> bytes);
/// The same of text.
inline void write_file(const std::string& path, const std::string& text) {
    write_file(path, std::as_bytes(std::span(text)));
}

}  // namespace sunfleck::engine
