// LiveSite: what a server answers about a render, and to whom.
#pragma once

#include "live/board.h"
#include "live/wishes.h"

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
    /// @param bound  as is_own_host() has it.
    /// @param stop  called, on any thread, when a viewer asks to end the render.
    LiveSite(std::shared_ptr<LiveBoard> board, std::shared_ptr<LiveWishes> wishes,
             std::string bound, std::function<void()> stop);

    const std::string& token() const { return token_; }
    bool may_ask(const httplib::Request& request) const;
    /// Returns how many viewers get texts.
    int watching() const { return watching_; }
    void end_render() const { stop_(); }

    /// A stream of events: each text as it comes, the latest first.
    void answer_texts(httplib::Response& response);
    /// The layer of that name, or the picture itself; no content while there is none.
    void answer_picture(const httplib::Request& request, httplib::Response& response) const;
    /// The whole picture as an .exr, its light groups changed as `relight` does.
    void answer_file(const httplib::Request& request, httplib::Response& response) const;
    // What viewers want.
    void answer_look(const httplib::Request& request, httplib::Response& response) const;
    void answer_back(httplib::Response& response) const;
    void answer_pause(const httplib::Request& request, httplib::Response& response) const;
    void answer_ends(const httplib::Request& request, httplib::Response& response) const;

private:
    std::shared_ptr<LiveBoard> board_;
    std::shared_ptr<LiveWishes> wishes_;
    std::string bound_;
    std::function<void()> stop_;
    std::string token_;
    std::atomic<int> watching_ = 0;
};

/// Returns the page, which needs nothing else.
std::string live_page();

}  // namespace sunfleck::engine
