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

nlohmann::json json_of(const LivePicture& picture) {
    return {{"number", picture.number},
            {"layers", picture.layers},
            {"groups", picture.groups},
            {"is_preview", picture.is_preview}};
}

nlohmann::json json_of(const LiveLook& look) {
    return {{"region", look.region},
            {"is_moved", look.is_moved},
            {"camera", look.camera},
            {"passes", look.progress.passes},
            {"seconds", look.progress.seconds},
            {"is_learning", look.progress.is_learning},
            {"picture", json_of(look.picture)},
            {"fault", look.fault}};
}

/// Returns what is known of the progress, with names of its own.
nlohmann::json json_of(const Progress& progress) {
    nlohmann::json error;
    nlohmann::json dark_error;
    if (progress.error) {
        error = progress.error->value();
        dark_error = number_or_null(progress.error->of_dark);
    }
    return {{"passes", progress.passes},
            {"passes_of", number_or_null(progress.of)},
            {"seconds", progress.seconds},
            {"seconds_left", number_or_null(progress.seconds_left)},
            {"error", error},
            {"dark_error", dark_error},
            {"bringing", progress.bringing}};
}

}  // namespace

std::string status_json(const LiveStatus& status) {
    nlohmann::json json = json_of(status.progress);
    json.update({{"stage", name_of(status.stage)},
                 {"scene", status.scene},
                 {"width", status.width},
                 {"height", status.height},
                 {"picture", json_of(status.picture)},
                 {"exposure", status.exposure},
                 {"tone", kTones.at(static_cast<std::size_t>(status.tone)).name},
                 {"balance", number_or_null(status.balance)},
                 {"nits", number_or_null(status.nits)},
                 {"end_error", number_or_null(status.ends.error)},
                 {"end_seconds", number_or_null(status.ends.seconds)},
                 {"can_be_steered", status.can_be_steered},
                 {"is_paused", status.is_paused},
                 {"has_lens", status.has_lens},
                 {"look", status.look ? json_of(*status.look) : nlohmann::json()},
                 {"earlier", status.earlier},
                 {"earlier_picture", json_of(status.earlier_picture)},
                 {"warnings", status.warnings}});
    return json.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

}  // namespace sunfleck::engine
