// Routes and limits.
#include "live/server.h"

#include "live/access.h"
#include "live/tones.h"
#include "sunfleck/error.h"

#include <fmt/format.h>
#include <httplib.h>

#include <mutex>
#include <utility>
#include <vector>

namespace sunfleck::engine {
namespace {

constexpr int kWorkers = 32;  // connections at a time; others wait
constexpr int kSeconds = 5;   // that a peer may keep a connection waiting
constexpr std::size_t kLongestBody = 1024;
constexpr std::chrono::milliseconds kTick(1);
constexpr std::chrono::milliseconds kFarewell(1000);  // for viewers to hear the last text

/// The library's wish for a queue, as a way to ours.
class Queue : public httplib::TaskQueue {
public:
    explicit Queue(Workers& workers) : workers_(workers) {}
    void enqueue(std::function<void()> task) override { workers_.add(std::move(task)); }
    void shutdown() override {}  // ~LiveServer waits

private:
    Workers& workers_;
};

httplib::Headers usual_headers() {
    return {{"Cache-Control", "no-store"},
            {"X-Content-Type-Options", "nosniff"},
            {"Referrer-Policy", "no-referrer"},
            {"Content-Security-Policy",
             "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; "
             "connect-src 'self'; img-src data:; frame-ancestors 'none'; base-uri 'none'; "
             "form-action 'none'"}};
}

void set_limits(httplib::Server& server) {
    server.set_payload_max_length(kLongestBody);
    server.set_read_timeout(kSeconds);
    server.set_write_timeout(kSeconds);
    server.set_keep_alive_max_count(1);  // one that is kept would take a worker
    server.set_default_headers(usual_headers());
}

using Handled = httplib::Server::HandlerResponse;

/// @param site  is kept as long as any of its answers.
void set_routes(httplib::Server& server, const std::shared_ptr<LiveSite>& site) {
    server.set_pre_routing_handler([site](const httplib::Request& q, httplib::Response& response) {
        if (site->may_ask(q)) return Handled::Unhandled;
        response.status = 403;
        response.set_content("This address needs the token that the render has printed.\n",
                             "text/plain");
        return Handled::Handled;
    });
    server.Get("/", [page = live_page()](const httplib::Request&, httplib::Response& response) {
        response.set_content(page, "text/html; charset=utf-8");
    });
    server.Get("/texts", [site](const httplib::Request&, httplib::Response& response) {
        site->answer_texts(response);
    });
    server.Get("/picture", [site](const httplib::Request& q, httplib::Response& response) {
        site->answer_picture(q, response);
    });
    server.Get("/file", [site](const httplib::Request& q, httplib::Response& response) {
        site->answer_file(q, response);
    });
    server.Get("/tone", [](const httplib::Request& q, httplib::Response& response) {
        response.set_content(tone_json(q.get_param_value("name")), "application/json");
    });
    server.Post("/look", [site](const httplib::Request& q, httplib::Response& response) {
        site->answer_look(q, response);
    });
    server.Post("/back", [site](const httplib::Request&, httplib::Response& response) {
        site->answer_back(response);
    });
    server.Post("/pause", [site](const httplib::Request& q, httplib::Response& response) {
        site->answer_pause(q, response);
    });
    server.Post("/ends", [site](const httplib::Request& q, httplib::Response& response) {
        site->answer_ends(q, response);
    });
    server.Post("/stop", [site](const httplib::Request&, httplib::Response& response) {
        site->end_render();
        response.set_content("The render ends after this pass.\n", "text/plain");
    });
}

/// A peer that dawdles keeps its thread, and so the server that it belongs to.
void keep_for_ever(std::unique_ptr<httplib::Server> server) {
    static std::mutex mutex;
    static auto& kept = *new std::vector<std::unique_ptr<httplib::Server>>;  // never destroyed
    const std::lock_guard lock(mutex);
    kept.push_back(std::move(server));
}

}  // namespace

LiveServer::LiveServer(std::shared_ptr<LiveBoard> board, std::shared_ptr<LiveWishes> wishes,
                       const std::string& bound, std::function<void()> stop)
    : board_(std::move(board)),
      site_(std::make_shared<LiveSite>(board_, std::move(wishes), bound, std::move(stop))),
      workers_(kWorkers),
      server_(std::make_unique<httplib::Server>()),
      host_(url_host(bound)) {
    server_->new_task_queue = [this] { return new Queue(workers_); };
    set_limits(*server_);
    set_routes(*server_, site_);
    const std::string address = bound.empty() ? "127.0.0.1" : bound;
    port_ = server_->bind_to_any_port(address);
    if (port_ <= 0)
        throw Error({"--view"}, "no port of " + address + " is free here",
                    "give --view-host an address of this machine, or none", ErrorCode::machine);
    thread_ = std::thread([this] { server_->listen_after_bind(); });
    while (!server_->is_running()) std::this_thread::sleep_for(kTick);  // or nothing stops it
}

LiveServer::~LiveServer() {
    board_->close();
    for (auto left = kFarewell; left.count() > 0 && site_->watching() > 0; left -= kTick)
        std::this_thread::sleep_for(kTick);
    server_->stop();
    thread_.join();
    if (!workers_.end(kFarewell)) keep_for_ever(std::move(server_));
}

std::string LiveServer::url() const {
    return fmt::format("http://{}:{}/?token={}", host_, port_, site_->token());
}

}  // namespace sunfleck::engine
