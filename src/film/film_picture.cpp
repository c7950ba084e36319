// Means of a film's sums as floats.
#include "film/film_picture.h"

#include "core/parallel.h"
#include "film/bias.h"
#include "film/film_metadata.h"

#include <span>
#include <vector>

namespace sunfleck::engine {
namespace {

/// The sums of an AOV, and those of open groups minus what does not count in the picture.
class AovSums {
public:
    /// @param aov  accessor for FilmSums and OpenGroup.
    template <class AovOf>
    AovSums(const Film& film, const AovOf& aov) : all_(aov(film.sums())) {
        for (const auto& [first, group] : film.sums().open_groups) {
            const double left_out = 1 - film.share_of_pass(first);
            if (left_out > 0) groups_.push_back({aov(group), left_out});
        }
    }
    double operator[](std::size_t i) const {
        double sum = all_[i].to_double();
        for (const Group& group : groups_) sum -= group.left_out * group.sums[i].to_double();
        return sum;
    }

private:
    struct Group {
        std::span<const FixedPoint> sums;
        double left_out;
    };
    std::span<const FixedPoint> all_;
    std::vector<Group> groups_;
};

/// @param names  of the channels, a letter each.
void add_aov(Picture& picture, const AovSums& sums, std::string_view aov, std::string_view names,
             double scale) {
    const std::size_t channels = names.size();
    for (std::size_t c = 0; c < channels; ++c) {
        const std::string prefix = aov.empty() ? "" : std::string(aov) + ".";
        std::vector<float>& values = picture.add(prefix + names[c]).values;
        parallel_blocks(values.size(), 4096, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                values[i] = static_cast<float>(sums[i * channels + c] * scale);
        });
    }
}

/// Adds bias channels, and subtracts the bias from RGB if requested.
void add_bias(Picture& picture, const Film& film, const FilmPictureOptions& options) {
    const auto biases = pixel_biases(film);
    if (biases.empty()) return;
    const std::string_view channels = kAovs[0].channels;
    for (std::size_t c = 0; c < channels.size(); ++c) {
        std::vector<float>& values = picture.add(std::string("bias.") + channels[c]).values;
        std::vector<float>& light = picture.channels[c].values;
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = static_cast<float>(biases[i][c]);
            if (options.extrapolate) light[i] -= values[i];
        }
    }
    if (options.extrapolate) picture.metadata[kExtrapolated] = "to a radius of zero";
}

/// Adds the error channel if there are two batches.
void add_error(Picture& picture, const Film& film, const FilmPictureOptions& options) {
    std::vector<double> errors;
    if (options.extrapolate) errors = extrapolated_pixel_errors(film);
    const bool extrapolated = !errors.empty();
    if (!extrapolated)
        for (const MeanError& pixel : pixel_errors(film)) errors.push_back(pixel.standard_error);
    if (errors.empty()) return;
    const double wider = extrapolated ? line_widening(film) : widening(film);
    std::vector<float>& values = picture.add("error.Y").values;
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<float>(wider * errors[i]);
}

}  // namespace

Picture film_picture(const Film& film, FilmPictureOptions options) {
    Picture picture{film.key().width, film.key().height, {}, film_metadata(film)};
    picture.pixel_aspect = pixel_aspect_of(film.key());
    const double share = film.pass_count() == 0 ? 0 : 1 / film.passes_in_picture();
    for (std::size_t i = 0; i < kAovCount; ++i) {
        const AovRow& row = kAovs.at(i);
        if (film.key().has(i))
            add_aov(picture, {film, [i](const auto& sums) { return std::span(sums.aovs.at(i)); }},
                    row.name, row.channels, share);
    }
    for (std::size_t i = 0; i < film.key().light_groups.size(); ++i)
        add_aov(picture, {film, [i](const auto& sums) { return std::span(sums.light_groups[i]); }},
                film.key().light_groups[i], "RGB", share);
    for (const std::string& name : film.key().light_groups) {
        std::string& names = picture.metadata[kLightGroupNames];
        names += (names.empty() ? "" : " ") + name;
    }
    add_error(picture, film, options);
    add_bias(picture, film, options);
    return picture;
}

}  // namespace sunfleck::engine
