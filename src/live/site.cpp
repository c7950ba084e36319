// Answers piece by piece, so that a board that is closed ends them.
#include "live/site.h"

#include "live/access.h"
#include "live/assets.h"
#include "live/layers.h"

#include <fmt/format.h>
#include <httplib.h>

#include <algorithm>
#include <utility>

namespace sunfleck::engine {
namespace {

constexpr int kMostWatching = 16;                // viewers that get texts
constexpr std::chrono::milliseconds kTick(500);  // between looks at whether a viewer is still there
constexpr int kTicksOfSilence = 20;              // then a line that says nothing keeps it connected
constexpr std::size_t kPiece = 1U << 16U;        // of a picture

/// Returns an event of a text, which is a line of JSON, with the seconds since it was told.
std::string event_of(const LiveBoard::Text& text) {
    const std::chrono::duration<double> age = LiveBoard::Clock::now() - text.told;
    return fmt::format("id: {}\ndata: {{\"age\":{:.3f},\"status\":{}}}\n\n", text.number,
                       age.count(), text.text);
}

/// The events of one viewer.
class Events {
public:
    explicit Events(std::shared_ptr<LiveBoard> board) : board_(std::move(board)) {}

    /// Writes the next event, or nothing for a while. @return whether the viewer is still there.
    bool write_next(httplib::DataSink& sink) {
        const auto text = board_->text_after(seen_, kTick);
        if (text) {
            seen_ = text->number;
            silent_ = 0;
            const std::string event = event_of(*text);
            return sink.write(event.data(), event.size());
        }
        if (board_->is_closed()) {
            sink.done();
            return true;
        }
        constexpr std::string_view kStillHere = ": still here\n\n";
        return ++silent_ % kTicksOfSilence != 0 || sink.write(kStillHere.data(), kStillHere.size());
    }

private:
    std::shared_ptr<LiveBoard> board_;
    std::uint64_t seen_ = 0;
    int silent_ = 0;
};

}  // namespace

LiveSite::LiveSite(std::shared_ptr<LiveBoard> board, std::function<void()> stop)
    : board_(std::move(board)), stop_(std::move(stop)), token_(new_token()) {}

bool LiveSite::may_ask(const httplib::Request& request) const {
    const std::string host = request.get_header_value("Host");
    return is_own_host(host) && is_own_origin(request.get_header_value("Origin"), host) &&
           is_token(request.get_param_value("token"), token_);
}

void LiveSite::answer_texts(httplib::Response& response) {
    if (++watching_ > kMostWatching) {
        --watching_;
        response.status = 503;
        response.set_content("There are too many viewers.\n", "text/plain");
        return;
    }
    response.set_chunked_content_provider(
        "text/event-stream",
        [events = Events(board_)](std::size_t, httplib::DataSink& sink) mutable {
            return events.write_next(sink);
        },
        [this](bool) { --watching_; });
}

void LiveSite::answer_picture(const httplib::Request& request, httplib::Response& response) const {
    const LiveBoard::Shown shown = board_->shown();
    response.status = 204;
    if (!shown.picture) return;
    const std::vector<LiveLayer> layers = layers_of(*shown.picture);
    if (layers.empty()) return;
    const std::string name = request.get_param_value("layer");
    const auto named = std::find_if(layers.begin(), layers.end(),
                                    [&](const LiveLayer& layer) { return layer.name == name; });
    const LiveLayer& layer = named == layers.end() ? layers.front() : *named;
    response.status = 200;
    response.set_header("X-Width", std::to_string(shown.picture->width));
    response.set_header("X-Height", std::to_string(shown.picture->height));
    response.set_header("X-Layer", layer.name);
    response.set_header("X-Number", std::to_string(shown.number));
    const auto bytes = std::make_shared<const std::string>(layer_bytes(layer));
    response.set_content_provider(
        bytes->size(), "application/octet-stream",
        [bytes, board = board_](std::size_t begin, std::size_t length, httplib::DataSink& sink) {
            return !board->is_closed() &&
                   sink.write(bytes->data() + begin, std::min(length, kPiece));
        });
}

std::string live_page() {
    std::string page(kLivePage);
    const auto fill = [&](std::string_view mark, std::string_view element,
                          std::string_view content) {
        page.replace(page.find(mark), mark.size(),
                     fmt::format("<{0}>\n{1}</{0}>", element, content));
    };
    fill("<!-- style -->", "style", kLiveStyle);
    fill("<!-- script -->", "script", kLiveScript);
    return page;
}

}  // namespace sunfleck::engine
