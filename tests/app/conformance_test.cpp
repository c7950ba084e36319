// What the reader says of each file of the public conformance set, against a kept table: a change
// of any warning or error shows as a line that comes or goes.
#include "import/pbrt/scene_text.h"

#include <filesystem>
#include <fstream>
#include <set>

namespace sunfleck::engine {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder =
    (fs::path(SUNFLECK_SOURCE_DIR) / "../shared/data/pbrt-conformance/scenes").lexically_normal();
const fs::path kTable = fs::path(SUNFLECK_SOURCE_DIR) / "tests/scenes/conformance.txt";

using Lines = std::vector<std::string>;

std::vector<fs::path> scene_files() {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(kFolder))
        if (entry.path().extension() == ".pbrt") found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

/// Every mention of the folder goes; of what lies beside it, "../" is left.
std::string without_folder(std::string text) {
    for (const auto& [folder, left] :
         {std::pair(kFolder, ""), std::pair(kFolder.parent_path(), "../")}) {
        const std::string begin = folder.string() + "/";
        for (std::size_t at = 0; (at = text.find(begin, at)) != std::string::npos;)
            text.replace(at, begin.size(), left);
    }
    return text;
}

/// "file: loads", or one line for each warning, or one for the error, with a remedy.
Lines lines_of(const fs::path& file) {
    Lines lines;
    const auto add = [&](const std::string& said) {
        EXPECT_EQ(said.find('\n'), std::string::npos) << said;
        lines.push_back(without_folder(said));
    };
    try {
        const SceneDescription scene = read_pbrt(file.string());
        for (const auto& entry : scene.warnings.entries()) add(entry.line());
        if (lines.empty()) add(file.string() + ": loads");
    } catch (const Error& error) {
        EXPECT_TRUE(contains(error.what(), "; ")) << error.what();
        add(std::string("error: ") + error.what());
    }
    return lines;
}

Lines kept_table() {
    Lines lines;
    std::ifstream table(kTable);
    for (std::string line; std::getline(table, line);) lines.push_back(line);
    return lines;
}

TEST(Conformance, what_is_said_of_each_scene_is_as_kept) {
    if (!fs::is_directory(kFolder)) GTEST_SKIP() << "shared/data/pbrt-conformance is not here";
    Lines seen;
    for (const fs::path& file : scene_files())
        for (std::string& line : lines_of(file)) seen.push_back(std::move(line));
    const Lines kept = kept_table();
    if (seen == kept) return;
    const std::multiset<std::string> now(seen.begin(), seen.end());
    const std::multiset<std::string> before(kept.begin(), kept.end());
    for (const std::string& line : before)
        if (now.count(line) != before.count(line)) ADD_FAILURE() << "- " << line;
    for (const std::string& line : now)
        if (now.count(line) != before.count(line)) ADD_FAILURE() << "+ " << line;
    const fs::path update = fs::path(testing::TempDir()) / "conformance.txt";
    std::ofstream file(update);
    for (const std::string& line : seen) file << line << '\n';
    ADD_FAILURE() << "if all of it is meant, copy " << update << " to " << kTable;
}

}  // namespace
}  // namespace sunfleck::engine
