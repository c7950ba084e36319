// NanoVDB files: their values, and what is refused. The files were written by
// OpenVDB's own NanoVDB 32.4, so that their bytes are the format's.
#include "import/nvdb/density.h"

#include "core/random.h"
#include "core/zlib_stream.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

namespace sunfleck::engine {
namespace {

/// Returns the bytes of a file, which has voxels of 0.25 at (1, 2, 3) from x =
/// -3 to 6, y = 2 to 4 and z = -9 to -5, of values 0.125 (x + 3) + (y - 2) +
/// 0.5 (z + 9).
std::string bytes_of(const std::string& name) {
    std::ifstream in(std::string(SUNFLECK_SOURCE_DIR) + "/tests/fuzz/corpus/nvdb/" + name,
                     std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

DensityGrid density_in(const std::string& bytes, const std::string& grid = "density") {
    return nvdb_density(bytes, grid, Matrix(), "a.nvdb");
}

/// Returns the error of a file; empty if there is none.
std::string fault_of(const std::string& bytes, const std::string& grid = "density") {
    try {
        density_in(bytes, grid);
    } catch (const Error& fault) {
        return fault.what();
    }
    return "";
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

Vec3 place_of(double x, double y, double z) {
    return Vec3(Vec3d(x, y, z) * 0.25 + Vec3d(1, 2, 3));
}

template <class Number>
std::string changed(std::string bytes, std::size_t at, Number to) {
    std::array<char, sizeof(Number)> raw{};
    std::memcpy(raw.data(), &to, raw.size());
    for (std::size_t i = 0; i < raw.size(); ++i) bytes.at(at + i) = raw.at(i);
    return bytes;
}

/// Where the grid begins in a file of one: behind the heads and the name.
constexpr std::size_t kGrid = 16 + 176 + 8;

/// Returns the file with its grid unpacked: of codec none in place of zip.
std::string unpacked(const std::string& file) {
    std::uint64_t size = 0;
    std::memcpy(&size, file.data() + 16, sizeof(size));
    const auto grid = inflated(file.substr(kGrid + 8), size);
    return changed(changed(file.substr(0, kGrid), 14, std::uint16_t{0}), 24, size) + *grid;
}

TEST(NvdbDensity, has_the_values_of_its_voxels_and_is_linear_between_them) {
    for (const std::string& file :
         {bytes_of("small.nvdb"), unpacked(bytes_of("small.nvdb")), bytes_of("two.nvdb")}) {
        const DensityGrid grid = density_in(file);
        for (int x = -3; x < 7; ++x)
            for (int y = 2; y < 5; ++y)
                for (int z = -9; z < -4; ++z)
                    EXPECT_NEAR(grid.at(place_of(x, y, z)),
                                0.125F * static_cast<float>(x + 3) + static_cast<float>(y - 2) +
                                    0.5F * static_cast<float>(z + 9),
                                1e-5F);
        EXPECT_NEAR(grid.at(place_of(2.5, 3.25, -6.5)), 0.125 * 5.5 + 1.25 + 0.5 * 2.5, 1e-5);
        EXPECT_FLOAT_EQ(grid.greatest(), 0.125F * 9 + 2 + 0.5F * 4);
    }
}

/// As pbrt-v4 has it, which ends a grid one voxel beyond its last.
TEST(NvdbDensity, ends_at_the_first_voxel_and_one_beyond_the_last) {
    const DensityGrid grid = density_in(bytes_of("small.nvdb"));
    EXPECT_EQ(grid.at(place_of(6, 1.99, -5)), 0);
    EXPECT_NEAR(grid.at(place_of(6.5, 4, -5)), (0.125F * 9 + 2 + 0.5F * 4) / 2, 1e-5F);
    EXPECT_EQ(grid.at(place_of(7.01, 4, -5)), 0);
}

TEST(NvdbDensity, far_voxels_of_one_grid_are_both_there) {
    const DensityGrid grid = density_in(bytes_of("apart.nvdb"));
    EXPECT_FLOAT_EQ(grid.amount({Vec3(-6000, 3, 4), Vec3(1, 0, 0)}), 0.5F * 1.5F + 2.5F);
    EXPECT_FLOAT_EQ(grid.distance_at({Vec3(-6000, 3, 4), Vec3(1, 0, 0)}, 2), 1900);
}

TEST(NvdbDensity, is_placed_by_a_matrix) {
    Matrix twice;
    twice.setScale(Vec3d(2));
    const DensityGrid grid = nvdb_density(bytes_of("small.nvdb"), "density", twice, "a.nvdb");
    EXPECT_NEAR(grid.at(place_of(1, 3, -6) * 2), 0.5F + 1 + 1.5F, 1e-5F);
}

TEST(NvdbDensity, grids_are_found_by_name) {
    EXPECT_TRUE(has_nvdb_grid(bytes_of("two.nvdb"), "temperature", "a.nvdb"));
    EXPECT_FALSE(has_nvdb_grid(bytes_of("small.nvdb"), "temperature", "a.nvdb"));
    EXPECT_FLOAT_EQ(density_in(bytes_of("two.nvdb"), "temperature").greatest(), 1000);
    EXPECT_TRUE(contains(fault_of(bytes_of("two.nvdb"), "flames"), "\"density\", \"temperature\""));
}

TEST(NvdbDensity, what_is_no_such_file_is_refused_by_what_it_is) {
    EXPECT_NE(fault_of(""), "");
    EXPECT_TRUE(contains(fault_of("volume"), "is no NanoVDB file"));
    EXPECT_TRUE(contains(fault_of(" BDV    "), "OpenVDB"));
    const std::string small = bytes_of("small.nvdb");
    EXPECT_TRUE(contains(fault_of(changed(small, 8, std::uint32_t{19})), "0.0.19"));
    EXPECT_TRUE(contains(fault_of(changed(small, 8, std::uint32_t{33} << 21U)), "33.0.0"));
    EXPECT_TRUE(contains(fault_of(changed(small, 14, std::uint16_t{2})), "Blosc"));
    EXPECT_TRUE(contains(fault_of(bytes_of("doubles.nvdb")), "not of floats"));
    EXPECT_TRUE(contains(fault_of(changed(small, 52, std::uint32_t{1})), "no fog volume"));
    EXPECT_TRUE(contains(fault_of(bytes_of("negative.nvdb")), "negative"));
}

/// Each offset of the tree, and each size.
TEST(NvdbDensity, offsets_that_lead_astray_are_refused) {
    const std::string small = unpacked(bytes_of("small.nvdb"));
    constexpr std::size_t kRoot = kGrid + 672 + 64;
    const auto refuses = [&](std::size_t at, auto to) {
        return fault_of(changed(small, at, to)) != "";
    };
    EXPECT_EQ(fault_of(small), "");
    for (const std::uint64_t wrong : {~std::uint64_t{0}, std::uint64_t{1} << 40U, small.size()}) {
        EXPECT_TRUE(refuses(16, wrong));                // the grid's size
        EXPECT_TRUE(refuses(24, wrong));                // the same in the file
        EXPECT_TRUE(refuses(kGrid + 32, wrong));        // the same in the grid
        EXPECT_TRUE(refuses(kGrid + 672 + 24, wrong));  // the root
        EXPECT_TRUE(refuses(kRoot + 64 + 8, wrong));    // its first node
    }
    EXPECT_TRUE(refuses(kRoot + 24, ~std::uint32_t{0}));  // number of nodes
    EXPECT_TRUE(refuses(kRoot + 12, 1 << 29));            // the box
    EXPECT_TRUE(refuses(kRoot + 12, -(1 << 29)));         // none
    EXPECT_TRUE(refuses(kGrid + 296 + 88, 0.0));          // flat
    EXPECT_TRUE(refuses(kGrid + 296 + 88, std::nan("")));
}

TEST(NvdbDensity, a_file_that_is_cut_is_refused) {
    for (const std::string& whole : {bytes_of("small.nvdb"), unpacked(bytes_of("small.nvdb"))})
        for (std::size_t i = 1; i < 60; ++i)
            EXPECT_NE(fault_of(whole.substr(0, whole.size() * i / 60)), "") << i;
}

/// Would see, under the sanitizers, a number that is read beside the file.
TEST(NvdbDensity, damaged_bytes_end_in_a_density_or_in_one_line) {
    const std::string small = unpacked(bytes_of("small.nvdb"));
    RandomStream random(3, Purpose::test, 0, 0);
    for (int i = 0; i < 400; ++i) {
        const auto at = static_cast<std::size_t>(random.next_float() * 2000);
        const auto to = static_cast<char>(random.next_float() * 256);
        EXPECT_FALSE(contains(fault_of(changed(small, at, to)), "\n"));
    }
}

}  // namespace
}  // namespace sunfleck::engine
