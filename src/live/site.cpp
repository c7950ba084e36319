// The page, and the stream of texts.
#include "live/site.h"

#include "live/access.h"
#include "live/assets.h"

#include <fmt/format.h>
#include <httplib.h>

#include <utility>

namespace sunfleck::engine {
namespace {

constexpr int kMostWatching = 16;                // viewers that get texts
constexpr std::chrono::milliseconds kTick(500);  // between looks at whether a viewer is still there
constexpr int kTicksOfSilence = 20;              // then a line that says nothing keeps it connected

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

LiveSite::LiveSite(std::shared_ptr<LiveBoard> board, std::shared_ptr<LiveWishes> wishes,
                   std::string bound, std::function<void()> stop)
    : board_(std::move(board)),
      wishes_(std::move(wishes)),
      bound_(std::move(bound)),
      stop_(std::move(stop)),
      token_(new_token()) {}

bool LiveSite::may_ask(const httplib::Request& request) const {
    const std::string host = request.get_header_value("Host");
    return is_own_host(host, bound_) && is_own_origin(request.get_header_value("Origin"), host) &&
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
