// Wishes, each answered by a line of text.
#include "flags/values.h"
#include "live/site.h"
#include "sunfleck/error.h"

#include <fmt/format.h>
#include <httplib.h>

namespace sunfleck::engine {
namespace {

void answer(httplib::Response& response, int status, std::string_view text) {
    response.status = status;
    response.set_content(fmt::format("{}\n", text), "text/plain");
}

void answer_taken(httplib::Response& response, bool is_taken) {
    if (is_taken)
        answer(response, 200, "It will be so.");
    else
        answer(response, 409, "This picture cannot be steered: no single machine renders it now.");
}

/// Answers what cannot be read by a line that says so.
template <class Task>
void answer_wish(httplib::Response& response, const Task& task) {
    try {
        answer_taken(response, task());
    } catch (const Error& fault) {
        answer(response, 400, fault.what());
    }
}

/// Returns a parameter read by `read`; nothing for none, or an empty one.
template <class Read>
std::optional<double> read_parameter(const httplib::Request& request, const char* name,
                                     const Read& read) {
    const std::string text = request.get_param_value(name);
    if (text.empty()) return {};
    return read(text, name);
}

}  // namespace

void LiveSite::answer_look(const httplib::Request& request, httplib::Response& response) const {
    answer_wish(response, [&] { return wishes_->look(read_look(request.params)); });
}

void LiveSite::answer_back(httplib::Response& response) const {
    answer_taken(response, wishes_->end_look());
}

void LiveSite::answer_pause(const httplib::Request& request, httplib::Response& response) const {
    answer_taken(response, wishes_->pause(request.get_param_value("on") == "1"));
}

void LiveSite::answer_ends(const httplib::Request& request, httplib::Response& response) const {
    answer_wish(response, [&] {
        return wishes_->end_at({read_parameter(request, "error", read_share),
                                read_parameter(request, "seconds", read_duration)});
    });
}

}  // namespace sunfleck::engine
