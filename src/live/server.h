// LiveServer: a render in the browser, on this machine alone unless another address is asked for.
//
// In:  a board. Out: a page at url(), its texts as server-sent events, its pictures as bytes, and
// what viewers wish. A request without the token of the url is refused, as is one by a page from
// elsewhere. No request reaches the disk. Its threads read the board alone: a slow reader costs the
// render nothing, and does not keep it from ending.
#pragma once

#include "live/site.h"
#include "live/workers.h"

#include <memory>
#include <string>
#include <thread>

namespace httplib {
class Server;
}

namespace sunfleck::engine {

class LiveServer {
public:
    /// Serves at a free port. @param bound  the address; empty: 127.0.0.1. @param stop  as LiveSite
    /// has it. @throws Error if there is no port, or the address is not this machine's.
    LiveServer(std::shared_ptr<LiveBoard> board, std::shared_ptr<LiveWishes> wishes,
               const std::string& bound, std::function<void()> stop);
    /// Closes the board and ends all answers.
    ~LiveServer();
    LiveServer(const LiveServer&) = delete;
    LiveServer& operator=(const LiveServer&) = delete;
    LiveServer(LiveServer&&) = delete;
    LiveServer& operator=(LiveServer&&) = delete;

    /// Returns http://127.0.0.1:PORT/?token=TOKEN, or with the address that it is bound to.
    std::string url() const;
    /// Returns how many viewers there are.
    int watching() const { return site_->watching(); }

private:
    std::shared_ptr<LiveBoard> board_;
    std::shared_ptr<LiveSite> site_;
    Workers workers_;
    std::unique_ptr<httplib::Server> server_;
    std::string host_;  // in the url
    int port_ = 0;
    std::thread thread_;
};

}  // namespace sunfleck::engine
