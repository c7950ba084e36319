// LiveServer: a render in the browser, on this machine alone.
//
// In:  a board. Out: a page at url(), its texts as server-sent events, its pictures as bytes. A
// request without the token of the url is refused, as is one by a page from elsewhere. No request
// reaches the disk. Its threads read the board alone: a slow reader costs the render nothing, and
// does not keep it from ending.
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
    /// Serves at a free port of 127.0.0.1. @param stop  as LiveSite has it.
    /// @throws Error if there is no port.
    LiveServer(std::shared_ptr<LiveBoard> board, std::function<void()> stop);
    /// Closes the board and ends all answers.
    ~LiveServer();
    LiveServer(const LiveServer&) = delete;
    LiveServer& operator=(const LiveServer&) = delete;
    LiveServer(LiveServer&&) = delete;
    LiveServer& operator=(LiveServer&&) = delete;

    /// Returns http://127.0.0.1:PORT/?token=TOKEN
    std::string url() const;

private:
    std::shared_ptr<LiveBoard> board_;
    std::shared_ptr<LiveSite> site_;
    Workers workers_;
    std::unique_ptr<httplib::Server> server_;
    int port_ = 0;
    std::thread thread_;
};

}  // namespace sunfleck::engine
