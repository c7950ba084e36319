// Error estimates of the whole picture from batch means.
#include "stats/image_stats.h"

#include "film/bias.h"
#include "math/wavelengths.h"

#include <fmt/format.h>

#include <optional>

namespace sunfleck::engine {
namespace {

/// Returns the widened standard error; nothing if it is zero and the picture is not black.
std::optional<MeanError> known_error(const Film& film) {
    const auto error = image_error(film);
    if (!error || is_too_dim(film)) return {};
    if (error->standard_error == 0 && error->mean != 0) return {};
    return MeanError{error->mean, widening(film) * error->standard_error};
}

}  // namespace

nlohmann::ordered_json image_json(const Film& film, ErrorTerms terms) {
    nlohmann::ordered_json json;
    json["mean"] = image_mean(film);
    if (const auto error = known_error(film)) {
        json["mean_std_error"] = error->standard_error;
        if (error->mean > 0) json["relative_std_error"] = error->standard_error / error->mean;
        json["error_degrees"] = error_degrees(film);
        json["error_widening"] = widening(film);
    }
    if (const auto bias = image_bias(film)) {
        json["bias"] = bias->value;
        json["bias_std_error"] = line_widening(film) * bias->standard_error;
        if (const auto relative = relative_bias(film)) json["relative_bias"] = *relative;
    }
    if (const auto error = target_error(film, terms)) {
        json["noise"] = error->noise;
        json["target_error"] = error->value();
        json["dark_error"] = nullptr;
        if (error->of_dark) json["dark_error"] = *error->of_dark;
    }
    json["extrapolated"] = terms.extrapolated && has_pixel_biases(film);
    return json;
}

std::vector<std::string> extrapolation_warnings(const Film& film, bool wanted) {
    if (!wanted || has_pixel_biases(film)) return {};
    const std::string what = "the picture is not extrapolated: ";
    const std::uint64_t batches = whole_batches(film.passes());
    if (batches < kWholeBatches)
        return {what + fmt::format("its bias is known from {} complete batches of {} passes on, "
                                   "of which it has {}",
                                   kWholeBatches, kBatchPasses, batches)};
    return {what + "radii have hardly shrunk over its passes, so its bias is not known"};
}

}  // namespace sunfleck::engine
