// Temporary file, fsync, rename: POSIX calls behind AtomicFile.
#include "image/atomic_file.h"

#include "core/error.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>
#include <vector>

namespace sunfleck {
namespace {

namespace fs = std::filesystem;

std::string reason(int code) {
    return std::generic_category().message(code);
}

[[noreturn]] void fail(const std::string& path, int code) {
    const bool full = code == ENOSPC || code == EDQUOT || code == EFBIG;
    throw Error({path}, "cannot write: " + reason(code),
                full ? "make room on the disk, or write to another one"
                     : "choose a file in a folder that you may write to");
}

fs::path folder_of(const fs::path& target) {
    const fs::path folder = target.parent_path();
    return folder.empty() ? "." : folder;
}

/// Where the bytes shall stand in the end.
/// @throws Error if that cannot be a file: a folder, a device, a folder that is missing.
std::string target_of(const std::string& path) {
    if (path.empty()) throw Error({"output"}, "the file has no name", "name one, as in out.exr");
    std::error_code code;
    const bool link = fs::is_symlink(path, code);
    const fs::path target = link ? fs::weakly_canonical(path, code) : fs::path(path);
    const fs::file_status status = fs::status(target, code);
    if (fs::is_directory(status) || !target.has_filename())
        throw Error({path}, "is a folder", "name a file in it");
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw Error({path}, "is no regular file", "name a new file, or one to replace");
    const fs::path folder = folder_of(target);
    if (!fs::is_directory(folder, code))
        throw Error({path}, "there is no folder " + folder.string(),
                    "create it, or choose a folder that exists");
    return target.string();
}

/// A name that no other file under way has, neither in this process nor in another one.
std::string temporary_name(const std::string& target) {
    static std::atomic<unsigned> count{0};
    return target + "." + std::to_string(::getpid()) + "-" + std::to_string(count++) + ".part";
}

/// The process whose temporary_name() this is; nothing for any other name.
std::optional<pid_t> writer_of(const std::string& name, const std::string& target) {
    if (!name.starts_with(target + ".")) return {};
    pid_t process = 0;
    unsigned count = 0;
    int used = 0;
    const std::string rest = name.substr(target.size());
    // NOLINTNEXTLINE(cert-err34-c): the conversion is checked by the count and by %n
    const int read = std::sscanf(rest.c_str(), ".%d-%u.part%n", &process, &count, &used);
    if (read != 2 || static_cast<std::size_t>(used) != rest.size() || process <= 0) return {};
    return process;
}

/// After a rename the folder's entry is brought to the disk, where the file system can do it.
void sync_folder(const std::string& target) {
    const int descriptor = ::open(folder_of(target).c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) return;
    ::fsync(descriptor);
    ::close(descriptor);
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : target_(target_of(path)) {
    for (int attempt = 0; descriptor_ < 0; ++attempt) {
        temporary_ = temporary_name(target_);
        descriptor_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        // EEXIST: left over from a process that had our number and was killed.
        if (descriptor_ < 0 && (errno != EEXIST || attempt == 100)) fail(target_, errno);
    }
}

AtomicFile::~AtomicFile() {
    if (descriptor_ < 0) return;
    ::close(descriptor_);
    ::unlink(temporary_.c_str());
}

void AtomicFile::write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail(target_, errno);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
        position_ += static_cast<std::uint64_t>(written);
    }
}

void AtomicFile::seek(std::uint64_t position) {
    if (::lseek(descriptor_, static_cast<off_t>(position), SEEK_SET) < 0) fail(target_, errno);
    position_ = position;
}

void AtomicFile::commit() {
    if (::fsync(descriptor_) != 0) fail(target_, errno);
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(target_, errno);
    ::close(descriptor_);
    descriptor_ = -1;
    sync_folder(target_);
}

void check_writable(const std::string& path) {
    const AtomicFile trial(path);
}

void remove_leftovers(const std::string& path) {
    const fs::path target = target_of(path);
    std::error_code code;
    std::vector<fs::path> left;
    for (const auto& entry : fs::directory_iterator(folder_of(target), code)) {
        const auto writer = writer_of(entry.path().filename(), target.filename());
        if (writer && ::kill(*writer, 0) != 0 && errno == ESRCH) left.push_back(entry.path());
    }
    for (const fs::path& file : left) fs::remove(file, code);
}

void write_file(const std::string& path, std::span<const std::byte> bytes) {
    AtomicFile file(path);
    file.write(bytes);
    file.commit();
}

}  // namespace sunfleck
