// Output files are whole or absent, whatever goes wrong.
#include "image/atomic_file.h"

#include "image/read_file.h"
#include "sunfleck/error.h"
#include "temporary_folder.h"

#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <fstream>
#include <vector>

namespace sunfleck::engine {
namespace {

using AtomicFiles = testing_support::TemporaryFolder;

std::span<const std::byte> bytes_of(const std::string& text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}

std::string fault_of(const std::string& path) {
    try {
        check_writable(path);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST_F(AtomicFiles, the_name_appears_with_commit_alone) {
    {
        AtomicFile file(path("a"));
        file.write(bytes_of("half"));
        EXPECT_FALSE(std::filesystem::exists(path("a")));
    }
    EXPECT_EQ(files(), 0);
    AtomicFile file(path("a"));
    file.write(bytes_of("12345"));
    file.seek(1);
    file.write(bytes_of("x"));
    EXPECT_EQ(file.position(), 2U);
    file.commit();
    EXPECT_EQ(read_file(path("a")), "1x345");
    EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFiles, the_old_file_stands_until_the_new_one_is_whole) {
    write_file(path("a"), bytes_of("old"));
    {
        AtomicFile file(path("a"));
        file.write(bytes_of("new, but not"));
    }
    EXPECT_EQ(read_file(path("a")), "old");
    write_file(path("a"), bytes_of("new"));
    EXPECT_EQ(read_file(path("a")), "new");
    EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFiles, a_new_version_keeps_the_permissions_of_the_file) {
    write_file(path("a"), bytes_of("old"));
    for (const ::mode_t mode : {0640U, 0600U, 0664U}) {
        ::chmod(path("a").c_str(), mode);
        write_file(path("a"), bytes_of("new"));
        struct stat status {};
        ASSERT_EQ(::stat(path("a").c_str(), &status), 0);
        EXPECT_EQ(status.st_mode & 0777U, mode);
    }
}

TEST_F(AtomicFiles, two_at_once_do_not_mix) {
    AtomicFile one(path("a"));
    AtomicFile two(path("a"));
    one.write(bytes_of("one"));
    two.write(bytes_of("two"));
    one.commit();
    two.commit();
    EXPECT_EQ(read_file(path("a")), "two");
    EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFiles, a_link_keeps_pointing_to_its_target) {
    write_file(path("target"), bytes_of("old"));
    std::filesystem::create_symlink(path("target"), path("link"));
    write_file(path("link"), bytes_of("new"));
    EXPECT_TRUE(std::filesystem::is_symlink(path("link")));
    EXPECT_EQ(read_file(path("target")), "new");
}

TEST_F(AtomicFiles, a_claim_excludes_others_until_it_ends) {
    std::filesystem::create_symlink("a", path("link"));
    {
        const OutputClaim claim(path("a"));
        EXPECT_NE(fault_of(path("a")).find("is being written by process"), std::string::npos);
        EXPECT_NE(fault_of(path("link")).find("is being written by process"), std::string::npos);
        EXPECT_EQ(fault_of(path("b")), "");
        write_file(path("a"), bytes_of("ours"));
        EXPECT_NE(fault_of(path("a")), "") << "the file itself has been replaced";
    }
    EXPECT_EQ(fault_of(path("a")), "");
    EXPECT_EQ(files(), 2);
}

/// A temporary file that nobody has locked is of a dead process, whatever number it had.
TEST_F(AtomicFiles, a_claim_removes_what_a_killed_process_has_left) {
    for (const char* name : {"a.1-0.part", "a.99999999-7.part", "a.1-0.part.txt", "aa.1-0.part"})
        write_file(path(name), bytes_of("left"));
    const OutputClaim claim(path("a"));
    EXPECT_EQ(files(), 3) << "two files of other names, and the claim";
}

TEST_F(AtomicFiles, an_end_by_signal_leaves_nothing) {
    const AtomicFile file(path("a"));
    const OutputClaim claim(path("b"));
    EXPECT_EQ(files(), 2);
    remove_own_temporaries();
    EXPECT_EQ(files(), 0);
}

/// A disk that is full is played by a limit on the size of files.
TEST_F(AtomicFiles, a_full_disk_leaves_nothing_behind) {
    write_file(path("a"), bytes_of("old"));
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    rlimit small = before;
    small.rlim_cur = 1000;
    setrlimit(RLIMIT_FSIZE, &small);
    std::string message;
    try {
        write_file(path("a"), bytes_of(std::string(5000, 'x')));
    } catch (const Error& error) {
        message = error.what();
    }
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(message, path("a") +
                           ": cannot write: File too large; make room on the disk, or write to "
                           "another one");
    EXPECT_EQ(read_file(path("a")), "old");
    EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFiles, check_writable_says_what_is_wrong_and_leaves_nothing) {
    EXPECT_EQ(fault_of(path("a")), "");
    EXPECT_EQ(files(), 0);
    EXPECT_EQ(fault_of(path("no/a")), path("no/a") + ": the folder does not exist: " + path("no") +
                                          "; create it, or choose a folder that exists");
    EXPECT_EQ(fault_of(path("")), path("") + ": is a folder; name a file in it");
    EXPECT_EQ(fault_of("/dev/null"),
              "/dev/null: is no regular file; name a new file, or one to replace");
    EXPECT_NE(fault_of("/proc/sunfleck.exr"), "");
    EXPECT_NE(fault_of(""), "");
    EXPECT_EQ(fault_of("sunfleck_here.exr"), "");
    write_file(path("old"), bytes_of("old"));
    EXPECT_EQ(fault_of(path("old")), "");
    EXPECT_EQ(read_file(path("old")), "old");
    EXPECT_NE(fault_of(path("old/a")), "");
    EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFiles, a_folder_without_permission_is_refused) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
    std::filesystem::create_directory(path("locked"));
    std::filesystem::permissions(
        path("locked"), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    EXPECT_NE(fault_of(path("locked/a")), "");
}

}  // namespace
}  // namespace sunfleck::engine
