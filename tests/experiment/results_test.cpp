// Errors of pictures made by hand, against references made by hand.
#include "experiment/results.h"

#include "experiment/methods.h"
#include "image/exr.h"
#include "image/temporary_folder.h"
#include "sunfleck/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>

namespace sunfleck::engine {
namespace {

using Floats = std::vector<float>;

class ExperimentResults : public testing_support::TemporaryFolder {
protected:
    /// A cell of one row of grey pixels.
    void write(const Cell& cell, const Floats& grey, const std::optional<Floats>& error,
               const std::optional<Floats>& emission) const {
        Picture picture{static_cast<int>(grey.size()), 1, {}, {}};
        for (const char* name : {"R", "G", "B"}) picture.add(name).values = grey;
        if (error) picture.add("error.Y").values = *error;
        if (emission) {
            picture.add("emission.R").values = Floats(grey.size());
            picture.add("emission.G").values = *emission;
            picture.add("emission.B").values = Floats(grey.size());
        }
        const std::string folder = path("cells/" + cell.key());
        std::filesystem::create_directories(folder);
        write_exr(folder + "/passes-000001.exr", picture);
        std::ofstream(folder + "/passes-000001.json")
            << R"({"seconds": {"total": 2}, "cpu_seconds": 3,
                   "visible_fraction": {}, "image": {}})";
    }

    RunSettings settings() const {
        RunSettings s;
        s.folder = path("");
        s.seeds = 1;
        return s;
    }
    Cell reference() const { return reference_cell("box", settings()); }
    const Cell cell_{"box", {"random", {}}, 1};
};

TEST_F(ExperimentResults, errors_lose_the_variance_of_the_reference) {
    write(reference(), {1, 3}, Floats{0.5F, 0}, {});
    write(cell_, {2, 4}, {}, {});
    const CellStore store(settings());
    const Results results(store);
    const PictureError error = results.error(cell_);
    EXPECT_NEAR(error.mse, (0.75 / 4 + 1.0 / 4) / 2, 1e-6);
    EXPECT_NEAR(error.rel_mse, (0.75 / 1.04 + 1 / 9.04) / 2, 1e-6);
    EXPECT_NEAR(results.reference("box").own_rel_mse, 0.25 / 1.04 / 2, 1e-6);
    EXPECT_NEAR(results.costs("box", cell_.method)[0], 3 * error.rel_mse, 1e-6);
    EXPECT_NEAR(results.costs("box", cell_.method, &PictureError::mse)[0], 3 * error.mse, 1e-6);
}

/// Of 250 pixels two.
TEST_F(ExperimentResults, trimmed_errors_leave_out_the_worst_hundredth) {
    Floats grey(250, 2);
    grey[7] = 100;
    grey[249] = -50;
    grey[100] = 4;
    write(reference(), Floats(grey.size(), 1), {}, {});
    write(cell_, grey, {}, {});
    const CellStore store(settings());
    const PictureError error = Results(store).error(cell_);
    EXPECT_NEAR(error.trimmed_mse, (247 + 9) / 248.0, 1e-6);
    EXPECT_NEAR(error.mse, (247 + 9 + 99 * 99 + 51 * 51) / 250.0, 1e-6);
}

/// One lamp is seen in the reference alone, one in the picture alone.
TEST_F(ExperimentResults, pixels_that_see_a_lamp_are_left_out) {
    write(reference(), {1, 3, 900, 4}, Floats{0.5F, 0, 400, 7}, Floats{0, 0, 800, 0});
    write(cell_, {2, 4, 5, 700}, {}, Floats{0, 0, 0, 650});
    const CellStore store(settings());
    const Results results(store);
    const double mean = 908.0 / 4;
    EXPECT_NEAR(results.error(cell_).mse, (0.75 + 1) / (mean * mean) / 2, 1e-9);
    const double floor = 0.01 * mean * mean;
    EXPECT_NEAR(results.reference("box").own_rel_mse, (0.25 / (1 + floor) + 49 / (16 + floor)) / 3,
                1e-6);
}

TEST_F(ExperimentResults, the_layer_of_one_of_them_is_enough) {
    write(reference(), {1, 9}, {}, Floats{0, 8});
    write(cell_, {2, 9}, {}, {});
    const CellStore store(settings());
    EXPECT_NEAR(Results(store).error(cell_).mse, 1.0 / 25, 1e-9);
}

TEST_F(ExperimentResults, another_size_is_refused) {
    write(reference(), {1, 9}, {}, {});
    write(cell_, {2, 9, 1}, {}, {});
    const CellStore store(settings());
    EXPECT_THROW(Results(store).error(cell_), Error);
}

}  // namespace
}  // namespace sunfleck::engine
