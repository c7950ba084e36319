// Results: statistics of finished cells, and errors of their pictures against the reference.
//
// Errors are of luminance per pixel: MSE is the mean square over the squared mean of the reference,
// relMSE the mean of squares over (reference^2 + 0.01 mean^2). The variance of the reference, if
// known (channel error.Y), is subtracted from both, so an error below it can be negative. Trimmed
// MSE leaves out the worst hundredth of each picture's pixels: it distinguishes methods if few
// bright pixels dominate the MSE. If a picture has the AOV emission, pixels that see a lamp are
// left out.
#pragma once

#include "experiment/store.h"

#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// A render after some passes. Missing statistics are NaN.
struct CellFacts {
    static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

    std::string picture;  // file name
    double passes = 0;
    double seconds = 0;
    double cpu_seconds = 0;
    double visible_fraction = kNone;
    double visible_ratio = kNone;  // distinct visible paths, over that of uniform sampling
    double visible_ratio_with_repeats = kNone;  // with repeats: the definition of the paper
    double mutation_size = kNone;
    double acceptance = kNone;
    double mean = kNone;  // luminance
};

struct PictureError {
    double mse = CellFacts::kNone;
    double rel_mse = CellFacts::kNone;
    double trimmed_mse = CellFacts::kNone;
};

using ErrorKind = double PictureError::*;

/// The data on which errors are measured.
struct MeasuredPicture {
    std::vector<double> luminance;  // per pixel
    std::vector<bool> sees_lamp;    // empty if unknown
};

/// The reference of a scene.
struct Reference {
    std::string method;
    MeasuredPicture picture;
    std::vector<double> variance;  // of the luminance, per pixel; empty if unknown
    double mean = 0;
    double own_rel_mse = CellFacts::kNone;
};

class Results {
public:
    explicit Results(const CellStore& store) : store_(store) {}

    const CellStore& store() const { return store_; }
    const RunSettings& settings() const { return store_.settings(); }
    /// Returns the state at the end of a cell.
    CellFacts facts(const Cell& cell) const { return snapshots(cell).back(); }
    /// Returns the snapshots in order of passes, at least one; more for scenes whose series is
    /// kept.
    std::vector<CellFacts> snapshots(const Cell& cell) const;

    PictureError error(const Cell& cell) const { return error(cell.scene, facts(cell).picture); }
    PictureError error(const std::string& scene, const std::string& picture) const;
    /// @throws Error  if the reference is not finished.
    const Reference& reference(const std::string& scene) const;
    bool has_reference(const std::string& scene) const;

    /// Returns the errors of a method over all seeds, and the products of error and processor time.
    std::vector<double> errors(const std::string& scene, const Method& method,
                               ErrorKind kind = &PictureError::rel_mse) const;
    std::vector<double> costs(const std::string& scene, const Method& method,
                              ErrorKind kind = &PictureError::rel_mse) const;
    /// Returns the cells of a scene and a method, one per seed.
    std::vector<Cell> cells(const std::string& scene, const Method& method) const;

private:
    const CellStore& store_;
    PictureError measured(const std::string& scene, const std::string& picture) const;

    mutable std::map<std::string, Reference> references_;
    mutable std::map<std::string, PictureError> errors_;  // by file
};

/// @throws Error  if the file has no R, G and B.
MeasuredPicture read_measured(const std::string& exr);

}  // namespace sunfleck::engine
