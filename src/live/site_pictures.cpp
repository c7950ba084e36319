// Pictures, piece by piece, so that a board that is closed ends them.
#include "film/film_picture.h"
#include "film/relight.h"
#include "flags/values.h"
#include "image/exr.h"
#include "live/layers.h"
#include "live/site.h"
#include "sunfleck/error.h"

#include <fmt/format.h>
#include <httplib.h>

#include <algorithm>
#include <string_view>

namespace sunfleck::engine {
namespace {

constexpr std::size_t kPiece = 1U << 16U;

LivePlace place_of(const httplib::Request& request) {
    const std::string name = request.get_param_value("of");
    if (name == "look") return LivePlace::look;
    return name == "earlier" ? LivePlace::earlier : LivePlace::render;
}

void send(std::string bytes, const char* type, const std::shared_ptr<LiveBoard>& board,
          httplib::Response& response) {
    response.status = 200;
    const auto shared = std::make_shared<const std::string>(std::move(bytes));
    response.set_content_provider(
        shared->size(), type,
        [shared, board](std::size_t begin, std::size_t length, httplib::DataSink& sink) {
            return !board->is_closed() &&
                   sink.write(shared->data() + begin, std::min(length, kPiece));
        });
}

std::vector<LightGroupFactor> factors_of(const httplib::Request& request) {
    std::vector<LightGroupFactor> factors;
    const auto [begin, end] = request.params.equal_range("factor");
    for (auto one = begin; one != end; ++one) factors.push_back(read_factor(one->second, "factor"));
    return factors;
}

}  // namespace

void LiveSite::answer_picture(const httplib::Request& request, httplib::Response& response) const {
    const LiveBoard::Shown shown = board_->shown(place_of(request));
    response.status = 204;
    if (!shown.picture) return;
    const std::string name = request.get_param_value("layer");
    const Picture rest = name == kRestOfLight ? rest_of_light(*shown.picture) : Picture();
    const std::vector<LiveLayer> layers = layers_of(name == kRestOfLight ? rest : *shown.picture);
    if (layers.empty()) return;
    const auto named = std::find_if(layers.begin(), layers.end(),
                                    [&](const LiveLayer& layer) { return layer.name == name; });
    const LiveLayer& layer = named == layers.end() ? layers.front() : *named;
    response.set_header("X-Width", std::to_string(shown.picture->width));
    response.set_header("X-Height", std::to_string(shown.picture->height));
    response.set_header("X-Layer", name == kRestOfLight ? name : layer.name);
    response.set_header("X-Number", std::to_string(shown.number));
    send(layer_bytes(layer), "application/octet-stream", board_, response);
}

void LiveSite::answer_file(const httplib::Request& request, httplib::Response& response) const {
    const LiveBoard::Shown shown = board_->shown(place_of(request));
    response.status = 404;
    if (!shown.picture) return;
    try {
        const std::vector<LightGroupFactor> factors = factors_of(request);
        std::string bytes = factors.empty()
                                ? exr_bytes(*shown.picture)
                                : exr_bytes(relit(*shown.picture, factors, "the picture").picture);
        response.set_header("Content-Disposition", "attachment; filename=\"sunfleck.exr\"");
        send(std::move(bytes), "image/x-exr", board_, response);
    } catch (const Error& fault) {
        response.status = 400;
        response.set_content(fmt::format("{}\n", fault.what()), "text/plain");
    }
}

}  // namespace sunfleck::engine
