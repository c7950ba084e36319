// The corpus of each fuzz target, read once: a file on which a reader has failed fails here at
// once. tools/fuzz.sh goes on from there.
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

using FuzzTarget = int(const std::uint8_t* data, std::size_t size);
extern "C" {
FuzzTarget fuzz_bsdf;
FuzzTarget fuzz_checkpoint;
FuzzTarget fuzz_exr;
FuzzTarget fuzz_gltf;
FuzzTarget fuzz_image;
FuzzTarget fuzz_live;
FuzzTarget fuzz_nvdb;
FuzzTarget fuzz_obj;
FuzzTarget fuzz_pbrt;
FuzzTarget fuzz_ply;
FuzzTarget fuzz_spd;
FuzzTarget fuzz_stl;
}

namespace sunfleck::engine {
namespace {

std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

struct Corpus {
    std::string name;
    FuzzTarget* target;
};

/// Of a test's name.
std::ostream& operator<<(std::ostream& out, const Corpus& corpus) {
    return out << corpus.name;
}

class Corpora : public testing::TestWithParam<Corpus> {};

TEST_P(Corpora, end_in_what_they_are_or_in_one_line) {
    int files = 0;
    const std::string folder =
        std::string(SUNFLECK_SOURCE_DIR) + "/tests/fuzz/corpus/" + GetParam().name;
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
        SCOPED_TRACE(file.path());
        const std::string bytes = bytes_of(file.path());
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): characters as bytes
        const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
        EXPECT_EQ(GetParam().target(data, bytes.size()), 0);
        ++files;
    }
    EXPECT_GT(files, 0);
}

INSTANTIATE_TEST_SUITE_P(Of, Corpora,
                         testing::Values(Corpus{"bsdf", fuzz_bsdf},
                                         Corpus{"checkpoint", fuzz_checkpoint},
                                         Corpus{"exr", fuzz_exr}, Corpus{"gltf", fuzz_gltf},
                                         Corpus{"image", fuzz_image}, Corpus{"live", fuzz_live},
                                         Corpus{"nvdb", fuzz_nvdb}, Corpus{"obj", fuzz_obj},
                                         Corpus{"pbrt", fuzz_pbrt}, Corpus{"ply", fuzz_ply},
                                         Corpus{"spd", fuzz_spd}, Corpus{"stl", fuzz_stl}),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace sunfleck::engine
