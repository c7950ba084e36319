// Flags of a render: looked up, checked against one another, read into the request.
#include "flags/render_flags.h"

#include "flags/flag_tables.h"
#include "flags/renamed_flags.h"
#include "sunfleck/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

namespace sunfleck::engine {
namespace {

/// Only this sampler has a use for the flag.
FlagNeed needs_sampler(const std::string& name, const std::string& mend = "leave it out") {
    return {.flag = "--photon-sampler",
            .values = {name},
            .why = "has a meaning with the sampler " + name + " alone",
            .mend = mend};
}

std::vector<RenderFlag> joined_tables() {
    std::vector<RenderFlag> all;
    const auto add = [&](const char* group, std::vector<RenderFlag> flags,
                         const std::vector<FlagNeed>& needs = {}) {
        for (RenderFlag& flag : flags) {
            flag.group = group;
            flag.needs.insert(flag.needs.begin(), needs.begin(), needs.end());
            if (flag.default_value.empty() && flag.value.choices.size() > 1 && !flag.value.is_list)
                flag.default_value = flag.value.choices.front().name;
            all.push_back(std::move(flag));
        }
    };
    add("When the render ends", end_flags());
    add("Picture", picture_flags());
    add(kPictureFilesGroup, file_flags());
    add("Light transport", transport_flags());
    add("Method", method_flags());
    add("Parts of the sampler adaptive", adaptive_flags(),
        {needs_photon_mapping(), needs_sampler("adaptive")});
    add("Parts of the sampler paper", paper_flags(),
        {needs_photon_mapping(), needs_sampler("paper", "leave it out, or add --mode paper")});
    add("Run", run_flags());
    return all;
}

void check_choice(const RenderFlag& flag, const std::string& word) {
    std::vector<std::string> names;
    for (const FlagChoice& choice : flag.value.choices) {
        if (choice.name == word) return;
        names.push_back(choice.name);
    }
    throw Error({flag.name}, fmt::format("does not take \"{}\"", word),
                fmt::format("use {}", fmt::join(names, " or ")));
}

void check_choices(const RenderFlag& flag, const std::string& text) {
    if (flag.value.choices.empty()) return;
    if (!flag.value.is_list) return check_choice(flag, text);
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');) check_choice(flag, word);
}

/// A render of which no end is given ends by error or by time, whichever comes first.
void set_default_ends(RenderRequest& request) {
    StopSettings& stop = request.stop;
    request.ends_by_default =
        !stop.end_pass && !stop.seconds && !stop.cpu_seconds && !stop.target_error;
    if (!request.ends_by_default) return;
    stop.seconds = 600;
    if (!is_sequential(request.settings)) stop.target_error = 0.02;  // else there are no error bars
}

}  // namespace

std::string flag_name(std::string name) {
    std::replace(name.begin(), name.end(), '_', '-');
    return name.starts_with("--") ? name : "--" + name;
}

const std::vector<RenderFlag>& render_flags() {
    static const std::vector<RenderFlag> all = joined_tables();
    return all;
}

const RenderFlag& render_flag(const std::string& name) {
    const std::string wanted = flag_name(name);
    for (const RenderFlag& flag : render_flags())
        if (wanted == flag.name || wanted == flag.alias) return flag;
    if (const std::string now(name_now(wanted)); !now.empty())
        throw Error({wanted}, "has another name now", "write " + now);
    throw Error({wanted}, "is no flag of a render", "see sunfleck render --help");
}

void RenderFlags::set(const std::string& name, const std::string& text) {
    const RenderFlag& flag = render_flag(name);
    check_choices(flag, text);
    std::vector<std::string>& texts = texts_[flag.name];
    if (!texts.empty() && !flag.value.repeats)
        throw Error({flag.name}, "is given twice", "give it once");
    texts.push_back(text);
}

std::string RenderFlags::text_of(const std::string& name) const {
    const auto given = texts_.find(name);
    return given == texts_.end() ? render_flag(name).default_value : given->second.back();
}

void RenderFlags::check(const RenderFlag& flag, const FlagNeed& need) const {
    if (!need.of_value.empty() && text_of(flag.name) != need.of_value) return;
    if (need.values.empty()) {
        if (!texts_.contains(need.flag)) return;
        throw Error({flag.name}, need.why.empty() ? "given together with " + need.flag : need.why,
                    "give one");
    }
    const std::string other = text_of(need.flag);
    if (std::find(need.values.begin(), need.values.end(), other) != need.values.end()) return;
    throw Error({flag.name},
                need.why.empty() ? "has no meaning with " + need.flag + " " + other : need.why,
                need.mend);
}

RenderRequest RenderFlags::finish() const {
    RenderFlags all = *this;  // with what --mode stands for
    if (texts_.contains("--mode")) all.texts_.try_emplace("--photon-sampler", 1, "paper");
    RenderRequest request;
    for (const RenderFlag& flag : render_flags()) {
        const auto given = texts_.find(flag.name);
        if (given == texts_.end()) continue;
        for (const FlagNeed& need : flag.needs) all.check(flag, need);
        for (const std::string& text : given->second) flag.value.read(request, text, flag.name);
    }
    set_default_ends(request);
    return request;
}

}  // namespace sunfleck::engine
