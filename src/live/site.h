// LiveSite: what a server answers about a render, and to whom.
#pragma once

#include "live/board.h"

#include <atomic>
#include <functional>
#include <memory>
#include <string>

namespace httplib {
struct Request;
struct Response;
}  // namespace httplib

namespace sunfleck::engine {

class LiveSite {
public:
    /// @param stop  called, on any thread, when a viewer asks to end the render.
    LiveSite(std::shared_ptr<LiveBoard> board, std::function<void()> stop);

    const std::string& token() const { return token_; }
    bool may_ask(const httplib::Request& request) const;
    /// Returns how many viewers get texts.
    int watching() const { return watching_; }
    void end_render() const { stop_(); }

    /// A stream of events: each text as it comes, the latest first.
    void answer_texts(httplib::Response& response);
    /// The layer of that name, or the picture itself; no content while there is none.
    void answer_picture(const httplib::Request& request, httplib::Response& response) const;

private:
    std::shared_ptr<LiveBoard> board_;
    std::function<void()> stop_;
    std::string token_;
    std::atomic<int> watching_ = 0;
};

/// Returns the page, which needs nothing else.
std::string live_page();

}  // namespace sunfleck::engine
