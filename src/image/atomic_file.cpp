// AtomicFile by POSIX calls: temporary file, fsync, rename.
#include "image/atomic_file.h"

#include "core/file_identity.h"
#include "core/machine_fault.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <new>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

namespace sunfleck::engine {
namespace {

namespace fs = std::filesystem;

std::string reason(int code) {
    return std::generic_category().message(code);
}

[[noreturn]] void fail(const std::string& path, int code) {
    const std::string what = "cannot write: " + reason(code);
    switch (code) {
        case EACCES:
        case EPERM:
            throw Error({path}, what, "choose a file in a folder that you may write to");
        case ENAMETOOLONG:
            throw Error({path}, what, "give it a shorter name");
        case EROFS:
            throw MachineFault({path}, what, "write to another disk");
        case ENOSPC:
        case EDQUOT:
        case EFBIG:
            throw MachineFault({path}, what, "make room on the disk, or write to another one");
        default:
            throw MachineFault({path}, what, "check the folder and its disk");
    }
}

fs::path folder_of(const fs::path& target) {
    const fs::path folder = target.parent_path();
    return folder.empty() ? "." : folder;
}

/// Returns the final path of an output file.
/// @throws Error  if it cannot be a file: a folder, a device, or in a folder that does not exist.
std::string target_of(const std::string& path) {
    if (path.empty()) throw Error({"output"}, "the file has no name", "name one, as in out.exr");
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (fs::is_directory(status) || !fs::path(path).has_filename())
        throw Error({path}, "is a folder", "name a file in it");
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw Error({path}, "is no regular file", "name a new file, or one to replace");
    const fs::path target = link_target(path);
    const fs::path folder = folder_of(target);
    if (!fs::is_directory(folder, code))
        throw Error({path}, "the folder does not exist: " + folder.string(),
                    "create it, or choose a folder that exists");
    return target.string();
}

/// Returns a name that no other temporary file has, in this process or another one.
std::string temporary_name(const std::string& target) {
    static std::atomic<unsigned> count{0};
    return target + "." + std::to_string(::getpid()) + "-" + std::to_string(count++) + ".part";
}

/// Returns the process that made this temporary_name(); nothing for any other name.
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

/// Temporary files of this process, for remove_own_temporaries(). A thread that exchanges a name
/// for null owns its memory.
constexpr std::size_t kMostAtOnce = 1000;
std::array<std::atomic<char*>, kMostAtOnce> own_temporaries{};
static_assert(std::atomic<char*>::is_always_lock_free);  // a signal handler may then use it

/// Adds a name to the list. @return its index.
std::size_t enlist(const std::string& temporary) {
    char* name = ::strdup(temporary.c_str());
    if (name == nullptr) throw std::bad_alloc();
    for (std::size_t i = 0; i < kMostAtOnce; ++i) {
        char* none = nullptr;
        if (own_temporaries[i].compare_exchange_strong(none, name)) return i;
    }
    std::free(name);
    throw Error({temporary}, "more than 1000 files are being written", "write fewer at once");
}

void delist(std::size_t place) {
    std::free(own_temporaries[place].exchange(nullptr));
}

/// Creates a new file and locks it. @return -1, with errno, on failure.
int open_locked(const std::string& name) {
    const int descriptor = ::open(name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) return descriptor;
    ::flock(descriptor, LOCK_EX);
    struct stat status {};
    if (::fstat(descriptor, &status) == 0 && status.st_nlink > 0) return descriptor;
    // Another program took the file for a leftover and removed it before it was locked.
    ::close(descriptor);
    errno = EEXIST;
    return -1;
}

/// Gives a new file the permissions of the one that it will replace, if there is one.
void take_mode(int descriptor, const std::string& target) {
    struct stat before {};
    if (::stat(target.c_str(), &before) == 0 && S_ISREG(before.st_mode))
        ::fchmod(descriptor, before.st_mode & 0777U);
}

/// Locks a folder against claims of other programs while it lives, where the system has locks.
class FolderLock {
public:
    explicit FolderLock(const std::string& target)
        : descriptor_(::open(folder_of(target).c_str(), O_RDONLY | O_CLOEXEC)) {
        if (descriptor_ >= 0) ::flock(descriptor_, LOCK_EX);
    }
    ~FolderLock() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;
    FolderLock(FolderLock&&) = delete;
    FolderLock& operator=(FolderLock&&) = delete;

private:
    int descriptor_;
};

/// Returns whether the writer of a temporary file lives (it holds a lock); else removes the file.
bool is_alive_or_removed(const std::string& temporary) {
    const int descriptor = ::open(temporary.c_str(), O_RDWR | O_CLOEXEC);
    if (descriptor < 0) return false;
    const bool alive = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    if (!alive) ::unlink(temporary.c_str());
    ::close(descriptor);
    return alive;
}

/// Returns another process that writes the target; leftovers of dead ones are removed.
std::optional<pid_t> other_writer(const AtomicFile& ours) {
    const std::string target = fs::path(ours.target()).filename();
    const std::string own = fs::path(ours.temporary()).filename();
    std::optional<pid_t> living;
    std::error_code code;
    std::vector<std::pair<std::string, pid_t>> others;
    for (const auto& entry : fs::directory_iterator(folder_of(ours.target()), code)) {
        const std::string name = entry.path().filename();
        if (const auto writer = writer_of(name, target); writer && name != own)
            others.emplace_back(entry.path().string(), *writer);
    }
    for (const auto& [file, writer] : others)
        if (is_alive_or_removed(file)) living = writer;
    return living;
}

/// Flushes the folder's entry to the disk after a rename, where the file system can.
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
        place_ = enlist(temporary_);
        descriptor_ = open_locked(temporary_);
        if (descriptor_ >= 0) {
            take_mode(descriptor_, target_);
            continue;
        }
        const int fault = errno;
        delist(place_);
        // A killed process of the same number left the file.
        if (fault != EEXIST || attempt == 100) fail(target_, fault);
    }
}

AtomicFile::~AtomicFile() {
    if (descriptor_ < 0) return;
    ::unlink(temporary_.c_str());
    ::close(descriptor_);
    delist(place_);
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
    delist(place_);
    ::close(descriptor_);  // a fault of close() has no effect: the bytes are on the disk
    descriptor_ = -1;
    sync_folder(target_);
}

OutputClaim::OutputClaim(const std::string& path) {
    const FolderLock lock(target_of(path));
    file_.emplace(path);
    if (const auto writer = other_writer(*file_))
        throw Error({path}, "is being written by process " + std::to_string(*writer),
                    "wait for its end, or write to another file");
}

bool ignores_case(const std::string& path) {
    const AtomicFile trial(path);
    std::string other = trial.temporary();
    other.replace(other.size() - 4, 4, "PART");
    return ::access(other.c_str(), F_OK) == 0;
}

void remove_own_temporaries() {
    for (std::atomic<char*>& name : own_temporaries) {
        char* const file = name.exchange(nullptr);
        if (file == nullptr) continue;
        ::unlink(file);
        char* none = nullptr;
        name.compare_exchange_strong(none, file);  // its AtomicFile frees it
    }
}

void write_file(const std::string& path, std::span<const std::byte> bytes) {
    AtomicFile file(path);
    file.write(bytes);
    file.commit();
}

}  // namespace sunfleck::engine
