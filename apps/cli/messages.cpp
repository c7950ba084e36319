// Plain system calls, so that a signal handler may speak.
#include "apps/cli/messages.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <system_error>

namespace sunfleck::engine {
namespace {

constexpr std::string_view kErase = "\r\033[J";  // from the first column on

std::atomic<bool> has_live_line{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // or a signal handler may not use it

void write_error(std::string_view first, std::string_view line, std::string_view last) {
    const auto piece = [](std::string_view text) {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): writev() only reads
        return iovec{const_cast<char*>(text.data()), text.size()};
    };
    const std::array<iovec, 3> pieces{piece(first), piece(line), piece(last)};
    while (::writev(STDERR_FILENO, pieces.data(), pieces.size()) < 0 && errno == EINTR) {
    }
}

}  // namespace

void keep_streams() {
    std::signal(SIGPIPE, SIG_IGN);
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
        if (::fcntl(stream, F_GETFD) >= 0 || errno != EBADF) continue;
        // The lowest free number is this stream's. What it opens fails as the closed stream does.
        ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
}

void say(std::string_view line) {
    const bool erase = has_live_line.exchange(false);
    const int before = errno;
    write_error(erase ? kErase : "", line, "\n");
    errno = before;
}

void draw_live_line(std::string_view line) {
    const bool erase = has_live_line.exchange(!line.empty());
    if (erase || !line.empty()) write_error(erase ? kErase : "", line, line.empty() ? "" : "\r");
}

void print_all(const std::function<void()>& task) {
    const auto fail = [](int code) {
        throw std::runtime_error("cannot write to standard output: " +
                                 std::generic_category().message(code));
    };
    try {
        task();
    } catch (const std::system_error& error) {
        if (std::ferror(stdout) == 0) throw;
        fail(error.code().value());
    }
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) fail(errno);
}

}  // namespace sunfleck::engine
