// What finished cells say: their statistics, and how far their pictures are from the reference.
//
// Errors are of luminance, by pixel: MSE is the mean square over the reference's mean squared,
// relMSE the mean of squares over (reference^2 + 0.01 mean^2). The reference's own variance, where
// its error is known (layer error.Y), is taken out of both: an error below it can come out
// negative. Trimmed MSE leaves out the worst hundredth of each picture's pixels: where a few bright
// ones are nearly all of the MSE, it tells methods apart. Where a picture has the layer emission,
// pixels that see a lamp are left out.
#pragma once

#include "experiment/store.h"

#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// A render as it stood after some passes. What its statistics do not say is not a number.
struct CellFacts {
    static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

    std::string picture;  // file
    double passes = 0;
    double seconds = 0;
    double cpu_seconds = 0;
    double visible_fraction = kNone;
    double visible_ratio = kNone;               // distinct visible paths, over uniform sampling's
    double visible_ratio_with_repeats = kNone;  // deposited ones: the paper's reading
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

/// What errors are measured on.
struct MeasuredPicture {
    std::vector<double> luminance;  // by pixel
    std::vector<bool> sees_lamp;    // empty: nothing is known of that
};

/// What a scene's errors are measured by.
struct Reference {
    std::string method;
    MeasuredPicture picture;
    std::vector<double> variance;  // of that, by pixel; empty where it is not known
    double mean = 0;
    double own_rel_mse = CellFacts::kNone;
};

class Results {
public:
    explicit Results(const CellStore& store) : store_(store) {}

    const CellStore& store() const { return store_; }
    const RunSettings& settings() const { return store_.settings(); }
    /// As the cell ended.
    CellFacts facts(const Cell& cell) const { return snapshots(cell).back(); }
    /// In the order of passes, at least one; more than one for scenes whose series is kept.
    std::vector<CellFacts> snapshots(const Cell& cell) const;

    PictureError error(const Cell& cell) const { return error(cell.scene, facts(cell).picture); }
    PictureError error(const std::string& scene, const std::string& picture) const;
    /// @throws Error if the reference is not finished.
    const Reference& reference(const std::string& scene) const;
    bool has_reference(const std::string& scene) const;

    /// The errors of one method over all seeds, and its errors times processor seconds.
    std::vector<double> errors(const std::string& scene, const Method& method,
                               ErrorKind kind = &PictureError::rel_mse) const;
    std::vector<double> costs(const std::string& scene, const Method& method,
                              ErrorKind kind = &PictureError::rel_mse) const;
    /// Of a scene and a method, one a seed.
    std::vector<Cell> cells(const std::string& scene, const Method& method) const;

private:
    const CellStore& store_;
    PictureError measured(const std::string& scene, const std::string& picture) const;

    mutable std::map<std::string, Reference> references_;
    mutable std::map<std::string, PictureError> errors_;  // by file
};

/// @throws Error for what is no picture of R, G and B.
MeasuredPicture read_measured(const std::string& exr);

}  // namespace sunfleck::engine
