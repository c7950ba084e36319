// Means of the film's sums as floats.
#include "film/film_picture.h"

#include "core/parallel.h"
#include "film/error_bars.h"

namespace sunfleck {
namespace {

bool is_light(Layer layer) {
    return layer != Layer::albedo && layer != Layer::normal && layer != Layer::depth &&
           layer != Layer::samples;
}

void add_layer(Picture& picture, const FixedPoints& sums, const LayerRow& row, double scale) {
    const std::size_t channels = row.channels.size();
    for (std::size_t c = 0; c < channels; ++c) {
        const std::string prefix = row.name.empty() ? "" : std::string(row.name) + ".";
        std::vector<float>& values = picture.add(prefix + row.channels[c]).values;
        parallel_blocks(values.size(), 4096, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                values[i] = static_cast<float>(sums[i * channels + c].to_double() * scale);
        });
    }
}

}  // namespace

Picture film_picture(const Film& film, double scale) {
    Picture picture{film.key().width, film.key().height, {}, {}};
    const double share = film.pass_count() == 0 ? 0 : 1 / static_cast<double>(film.pass_count());
    for (std::size_t i = 0; i < kLayerCount; ++i) {
        const LayerRow& row = kLayers.at(i);
        if (film.key().has(i))
            add_layer(picture, film.sums().layers.at(i), row,
                      is_light(row.layer) ? share * scale : share);
    }
    const std::vector<MeanError> errors = pixel_errors(film);
    if (errors.empty()) return picture;
    std::vector<float>& values = picture.add("error.Y").values;
    parallel_blocks(values.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            values[i] = static_cast<float>(errors[i].standard_error * scale);
    });
    return picture;
}

}  // namespace sunfleck
