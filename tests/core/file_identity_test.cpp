// One file is known under all of its names.
#include "core/file_identity.h"

#include "image/temporary_folder.h"
#include "sunfleck/error.h"

#include <fcntl.h>
#include <unistd.h>

#include <fstream>

namespace sunfleck::engine {
namespace {

namespace fs = std::filesystem;
using FileIdentities = testing_support::TemporaryFolder;

TEST_F(FileIdentities, of_one_file_are_one_by_any_name) {
    std::ofstream(path("a")) << "a";
    std::ofstream(path("b")) << "a";
    fs::create_directory(path("sub"));
    fs::create_symlink("../a", path("sub/soft"));
    fs::create_hard_link(path("a"), path("hard"));
    for (const char* name : {"hard", "sub/soft", "sub/../a", ".//a"})
        EXPECT_EQ(identity_of(path(name)), identity_of(path("a"))) << name;
    EXPECT_NE(identity_of(path("b")), identity_of(path("a")));
}

TEST_F(FileIdentities, of_files_to_be_are_their_folder_and_name) {
    fs::create_directory(path("sub"));
    fs::create_directory_symlink("sub", path("way"));
    fs::create_symlink("way/x", path("soft"));
    ASSERT_TRUE(identity_of(path("sub/x")));
    EXPECT_EQ(identity_of(path("sub/x"))->new_name, "x");
    for (const char* name : {"soft", "way/x", "sub/../way/x"})
        EXPECT_EQ(identity_of(path(name)), identity_of(path("sub/x"))) << name;
    EXPECT_NE(identity_of(path("sub/y")), identity_of(path("sub/x")));
    EXPECT_FALSE(identity_of(path("no/x")));
    EXPECT_FALSE(identity_of(""));
}

TEST_F(FileIdentities, links_that_lead_nowhere_are_refused) {
    fs::create_symlink("one", path("two"));
    fs::create_symlink("two", path("one"));
    EXPECT_THROW(link_target(path("one")), Error);
    const int gone = ::open(path("gone").c_str(), O_CREAT | O_RDWR, 0600);
    fs::remove(path("gone"));
    EXPECT_THROW(link_target("/proc/self/fd/" + std::to_string(gone)), Error);
    ::close(gone);
}

}  // namespace
}  // namespace sunfleck::engine
