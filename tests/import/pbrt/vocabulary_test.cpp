// The table of words: it knows what the reader knows, it counts, and the documentation shows it.
#include "import/pbrt/vocabulary.h"

#include "import/pbrt/directives.h"
#include "import/pbrt/scene_text.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace sunfleck::engine {
namespace {

void expect_known(std::string_view directive, std::string_view word) {
    const WordRow* row = find_word(directive, word);
    EXPECT_NE(row, nullptr) << directive << ' ' << word;
}

TEST(Vocabulary, has_every_word_that_is_read) {
    for (const auto directives : {transform_directives(), block_directives(), option_directives(),
                                  world_directives(), file_directives()})
        for (const Directive& directive : directives) expect_known("Directive", directive.word);
    EXPECT_EQ(find_word("Shape", "teapot"), nullptr);
    EXPECT_EQ(find_word("Directive", "Attribute")->word, "Attribute");
    EXPECT_EQ(find_word("Directive", "Begin"), nullptr) << "a part of a word is none";
    EXPECT_EQ(find_word("Integrator", "volpath")->word, "any other");
}

/// All rows but of directives: a word of a scene that is read, or the scene is refused.
TEST(Vocabulary, says_only_what_the_reader_does) {
    for (const WordRow& row : vocabulary()) {
        if (row.directive != "Camera" || row.treatment == Treatment::refused) continue;
        const std::string text = "Camera \"" + std::string(row.word) + "\"\nWorldBegin\n";
        EXPECT_NO_THROW(read_pbrt_text(text, "test.pbrt")) << row.word;
    }
    EXPECT_EQ(find_word("Camera", "realistic")->treatment, Treatment::refused);
    EXPECT_THROW(read_pbrt_text("Camera \"realistic\"\nWorldBegin\n", "test.pbrt"), Error);
    for (const WordRow& row : vocabulary()) {
        if (row.directive != "Film" && row.directive != "PixelFilter") continue;
        const std::string text =
            std::string(row.directive) + " \"" + std::string(row.word) + "\"\nWorldBegin\n";
        const SceneDescription scene = read_pbrt_text(text, "test.pbrt");
        EXPECT_EQ(scene.warnings.entries().empty(), row.treatment == Treatment::exact) << text;
    }
}

TEST(Vocabulary, of_a_scene_is_counted) {
    const SceneDescription scene = read_pbrt_text(
        "Film \"rgb\"\nWorldBegin\nMaterial \"diffuse\"\nShape \"sphere\"\nShape \"sphere\"\n"
        "LightSource \"point\"\nTexture \"t\" \"float\" \"constant\"\n",
        "test.pbrt");
    const auto count = [&](const std::string& directive, const std::string& word) {
        for (const UsedWord& used : scene.words)
            if (used.directive == directive && used.word == word) return used.count;
        return std::size_t{0};
    };
    EXPECT_EQ(count("Shape", "sphere"), 2U);
    EXPECT_EQ(count("Directive", "Shape"), 2U);
    EXPECT_EQ(count("Film", "rgb"), 1U);
    EXPECT_EQ(count("LightSource", "point"), 1U);
    EXPECT_EQ(count("Texture", "constant"), 1U);
    EXPECT_EQ(count("Material", "diffuse"), 2U) << "with pbrt-v4's default";
    for (const UsedWord& used : scene.words) expect_known(used.directive, used.word);
}

TEST(Vocabulary, is_what_the_documentation_shows) {
    std::ifstream file(SUNFLECK_SOURCE_DIR "/docs/reference/scenes.md");
    std::ostringstream text;
    text << file.rdbuf();
    for (const std::string_view directive : vocabulary_directives())
        EXPECT_NE(text.str().find(vocabulary_table(directive)), std::string::npos)
            << "the table of " << directive
            << " differs from the one in docs/reference/scenes.md: put in what `sunfleck info "
               "--words` says";
}

}  // namespace
}  // namespace sunfleck::engine
