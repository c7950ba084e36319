// Numbers that are not known yet are null.
#include "live/status.h"

#include <nlohmann/json.hpp>

namespace sunfleck::engine {
namespace {

const char* name_of(LiveStage stage) {
    switch (stage) {
        case LiveStage::reading:
            return "reading";
        case LiveStage::learning:
            return "learning";
        case LiveStage::rendering:
            return "rendering";
        case LiveStage::ended:
            break;
    }
    return "ended";
}

template <class Value>
nlohmann::json number_or_null(const std::optional<Value>& value) {
    return value ? nlohmann::json(*value) : nlohmann::json();
}

}  // namespace

std::string status_json(const LiveStatus& status) {
    const Progress& progress = status.progress;
    nlohmann::json error;
    nlohmann::json dark_error;
    if (progress.error) {
        error = progress.error->value();
        dark_error = number_or_null(progress.error->of_dark);
    }
    return nlohmann::json{{"stage", name_of(status.stage)},
                          {"scene", status.scene},
                          {"width", status.width},
                          {"height", status.height},
                          {"picture", status.picture},
                          {"is_preview", status.is_preview},
                          {"layers", status.layers},
                          {"exposure", status.exposure},
                          {"passes", progress.passes},
                          {"passes_of", number_or_null(progress.of)},
                          {"seconds", progress.seconds},
                          {"seconds_left", number_or_null(progress.seconds_left)},
                          {"error", error},
                          {"dark_error", dark_error},
                          {"target_error", number_or_null(progress.target)},
                          {"bringing", progress.bringing},
                          {"warnings", status.warnings}}
        .dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

}  // namespace sunfleck::engine
