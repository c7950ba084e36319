// Elements that several figures share: tables of errors, errors over time, rows of pictures.
#pragma once

#include "experiment/figure.h"
#include "experiment/methods.h"

#include <array>

namespace sunfleck::engine {

/// An error measure, and its name in tables.
struct Measure {
    ErrorKind kind;
    const char* name;
};
inline constexpr std::array<Measure, 3> kMeasures = {{
    {&PictureError::mse, "MSE"},
    {&PictureError::rel_mse, "relMSE"},
    {&PictureError::trimmed_mse, "trimmed MSE"},
}};

/// Returns all methods in all scenes, one cell per seed.
std::vector<Cell> seed_cells(const RunSettings& settings, const std::vector<std::string>& scenes,
                             const std::vector<Method>& methods);

/// Returns a row per method and scene: work, errors over seeds, and error x processor time over
/// that of methods[0]; then pictures of other renderers, and the reference with its own error.
Table error_table(const Results& results, const std::string& name,
                  const std::vector<std::string>& scenes, const std::vector<Method>& methods);

/// Returns relMSE against processor time: the median of the seeds, with a band from lowest to
/// highest.
Chart error_chart(const Results& results, const std::string& name, const std::string& scene,
                  const std::vector<Method>& methods);

/// Returns the pictures of the first seed for a scene, and the reference last.
/// @param name  of the figure.
PictureRow picture_row(const Results& results, const std::string& name, const std::string& scene,
                       const std::vector<Method>& methods);

/// Returns the ratio of error x processor time of two methods, over seeds.
Interval cost_ratio(const Results& results, const std::string& scene, const Method& a,
                    const Method& b, ErrorKind kind);

/// Returns "A over B in SCENE: relMSE x processor time 3.1 [2.8, 3.4], MSE x ..., without the worst
/// 1% ...".
std::string ratio_sentence(const Results& results, const std::string& scene, const Method& a,
                           const Method& b);

}  // namespace sunfleck::engine
