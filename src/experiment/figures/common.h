// What several figures show alike: tables of errors, errors over time, rows of pictures.
#pragma once

#include "experiment/figure.h"
#include "experiment/methods.h"

#include <array>

namespace sunfleck::engine {

/// An error, and what tables call it.
struct Measure {
    ErrorKind kind;
    const char* name;
};
inline constexpr std::array<Measure, 3> kMeasures = {{
    {&PictureError::mse, "MSE"},
    {&PictureError::rel_mse, "relMSE"},
    {&PictureError::trimmed_mse, "trimmed MSE"},
}};

/// All methods in all scenes, one cell a seed.
std::vector<Cell> seed_cells(const RunSettings& settings, const std::vector<std::string>& scenes,
                             const std::vector<Method>& methods);

/// A row for each method and scene: work done, errors over seeds, and errors x processor seconds
/// over those of methods[0]; then other renderers' pictures, and the reference with its own error.
Table error_table(const Results& results, const std::string& name,
                  const std::vector<std::string>& scenes, const std::vector<Method>& methods);

/// relMSE against processor seconds: the median of the seeds, its band from lowest to highest.
Chart error_chart(const Results& results, const std::string& name, const std::string& scene,
                  const std::vector<Method>& methods);

/// The first seed's pictures of one scene, and the reference last.
/// @param name  of the figure.
PictureRow picture_row(const Results& results, const std::string& name, const std::string& scene,
                       const std::vector<Method>& methods);

/// Error x processor seconds of one method over that of another, over seeds.
Interval cost_ratio(const Results& results, const std::string& scene, const Method& a,
                    const Method& b, ErrorKind kind);

/// "A over B in SCENE: relMSE x processor time 3.1 [2.8, 3.4], MSE x ..., without the worst 1%
/// ...".
std::string ratio_sentence(const Results& results, const std::string& scene, const Method& a,
                           const Method& b);

}  // namespace sunfleck::engine
