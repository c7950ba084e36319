// Reading --light-group, and finding the lights that it means.
#include "apps/cli/light_groups.h"

#include "aovs/channels.h"
#include "scene/scene.h"
#include "sunfleck/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

namespace sunfleck::engine {
namespace {

constexpr const char* kFlag = "--light-group";

void check_name(const std::string& name, const std::vector<AskedLightGroup>& before) {
    if (!is_aov_name(name))
        throw Error({kFlag}, "\"" + name + "\" is no name of a light group",
                    "begin it with a letter, and go on with letters, digits, _ and -");
    const auto is_this = [&](const auto& other) { return other.name == name; };
    if (is_taken_aov_name(name) || std::any_of(before.begin(), before.end(), is_this))
        throw Error({kFlag}, "there is another AOV \"" + name + "\"", "use another name");
}

/// "3" or "3-5", counted from 1. @return nothing for what is neither.
std::optional<std::pair<std::uint32_t, std::uint32_t>> read_run(const std::string& text) {
    const char* const end = text.data() + text.size();
    std::uint32_t first = 0;
    auto [stop, fault] = std::from_chars(text.data(), end, first);
    if (fault != std::errc() || first == 0) return {};
    if (stop == end) return std::pair(first, first);
    std::uint32_t last = 0;
    if (*stop != '-') return {};
    const auto second = std::from_chars(stop + 1, end, last);
    if (second.ec != std::errc() || second.ptr != end || last < first) return {};
    return std::pair(first, last);
}

AskedLightGroup read_group(const std::string& text) {
    const std::size_t equals = std::min(text.find('='), text.size());
    AskedLightGroup group{
        text.substr(0, equals), text.substr(std::min(equals + 1, text.size())), {}};
    std::size_t begin = 0;
    while (begin <= group.text.size()) {
        const std::size_t end = std::min(group.text.find(',', begin), group.text.size());
        const auto run = read_run(group.text.substr(begin, end - begin));
        if (!run)
            throw Error({kFlag}, "\"" + text + "\" does not say which lights",
                        "write NAME=1,3-5 with numbers of sunfleck info --lights, or each");
        group.runs.push_back(*run);
        begin = end + 1;
    }
    return group;
}

std::vector<AskedLightGroup> each_of(std::size_t lights) {
    std::vector<AskedLightGroup> groups;
    for (std::uint32_t i = 1; i <= lights; ++i)
        groups.push_back({fmt::format("light{}", i), fmt::format("{}", i), {{i, i}}});
    return groups;
}

/// By light of the scene's file, from 0: its group.
std::vector<std::uint8_t> groups_of_statements(const std::vector<AskedLightGroup>& asked,
                                               std::size_t lights) {
    std::vector<std::uint8_t> group_of(lights, kNoLightGroup);
    for (std::size_t l = 0; l < asked.size(); ++l)
        for (const auto& [first, last] : asked[l].runs) {
            if (last > lights)
                throw Error({kFlag},
                            fmt::format("there is no light {}: the scene has {}", last, lights),
                            "see sunfleck info --lights");
            for (std::uint32_t i = first - 1; i < last; ++i) {
                if (group_of[i] != kNoLightGroup)
                    throw Error({kFlag}, fmt::format("light {} is asked for twice", i + 1),
                                "name each light once");
                group_of[i] = static_cast<std::uint8_t>(l);
            }
        }
    return group_of;
}

}  // namespace

std::vector<AskedLightGroup> read_light_groups(const std::vector<std::string>& texts,
                                               PhotonSampler sampler) {
    if (!texts.empty() && sampler == PhotonSampler::paper)
        throw Error({kFlag}, "the sampler paper sums the light of all lights in one",
                    "use another sampler");
    if (texts.size() == 1 && texts[0] == "each") return {{}};
    std::vector<AskedLightGroup> groups;
    for (const std::string& text : texts) {
        if (text == "each")
            throw Error({kFlag}, "each is given together with named groups", "give either");
        AskedLightGroup group = read_group(text);
        check_name(group.name, groups);
        groups.push_back(std::move(group));
    }
    return groups;
}

LightGroups light_groups_of(const Scene& scene, const std::vector<AskedLightGroup>& asked) {
    if (asked.empty()) return {};
    const std::size_t lights = scene.light_statements().size();
    const std::vector<AskedLightGroup> wanted = asked[0].name.empty() ? each_of(lights) : asked;
    if (wanted.size() > kMostLightGroups)
        throw Error({kFlag}, fmt::format("{} light groups are asked for", wanted.size()),
                    fmt::format("put lights together: at most {} groups", kMostLightGroups));
    const std::vector<std::uint8_t> group_of = groups_of_statements(wanted, lights);
    LightGroups groups;
    for (const AskedLightGroup& group : wanted) {
        groups.names.push_back(group.name);
        groups.text += (groups.text.empty() ? "" : " ") + group.name + "=" + group.text;
    }
    for (const std::uint32_t statement : scene.stated_in())
        groups.of_light.push_back(statement == kNone ? kNoLightGroup : group_of[statement]);
    return groups;
}

}  // namespace sunfleck::engine
