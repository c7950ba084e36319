// Output files that appear complete or not at all: a temporary file, renamed onto the target.
//
// A reader of the target sees the old file or the new one, also after a crash: the bytes are on the
// disk before the name is. The temporary file is locked while its process lives, so that other
// programs can tell it from the remains of a killed process.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace sunfleck::engine {

/// A file that is being written; without commit() it leaves nothing behind. All faults throw Error,
/// or MachineFault where no other name would help.
class AtomicFile {
public:
    /// Creates a temporary file in the folder of `path`. A symbolic link is followed to its target.
    explicit AtomicFile(const std::string& path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    AtomicFile(AtomicFile&&) = delete;
    AtomicFile& operator=(AtomicFile&&) = delete;

    /// Writes at the current position and advances it.
    void write(std::span<const std::byte> bytes);
    /// Sets the position, in bytes from the beginning.
    void seek(std::uint64_t position);
    std::uint64_t position() const { return position_; }

    /// Flushes the bytes to the disk and renames the file to its target. It is the last call.
    void commit();

    const std::string& target() const { return target_; }
    const std::string& temporary() const { return temporary_; }

private:
    std::string target_;
    std::string temporary_;
    std::size_t place_ = 0;  // index among the temporary files of this process
    std::uint64_t position_ = 0;
    int descriptor_ = -1;
};

/// Claims an output file while it lives: no other program that uses claims gets one, under any
/// symbolic link. The claim is an empty temporary file beside the target. A killed process leaves
/// it behind, and the next claim removes it. The target itself is not touched. On file systems
/// without locks claims exclude nobody.
class OutputClaim {
public:
    /// @throws Error  if the file cannot be written, or another program has claimed it.
    explicit OutputClaim(const std::string& path);

private:
    std::optional<AtomicFile> file_;
};

/// Checks, before long work, that `path` can be written and claimed. It leaves nothing behind.
/// @throws Error  if not.
inline void check_writable(const std::string& path) {
    const OutputClaim claim(path);
}

/// Returns whether names in the folder of `path` that differ in case alone are the same file.
/// @throws Error  if the folder cannot be written to.
bool ignores_case(const std::string& path);

/// Removes all temporary files of this process. It may be called in a signal handler, before an
/// exit that runs no destructors.
void remove_own_temporaries();

/// Writes a complete file atomically.
void write_file(const std::string& path, std::span<const std::byte> bytes);
/// Writes text atomically.
inline void write_file(const std::string& path, const std::string& text) {
    write_file(path, std::as_bytes(std::span(text)));
}

}  // namespace sunfleck::engine
