// Settings by the table of flags that the command line reads.
#include "sunfleck/settings.h"

#include "core/named_rows.h"
#include "library/settings_data.h"
#include "sunfleck/error.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace sunfleck {
namespace {

/// A flag of the program that is no setting, and what a program does in its place.
struct ProgramFlag {
    std::string_view name;
    std::string_view in_its_place;
};
constexpr std::array<ProgramFlag, 8> kProgramFlags = {{
    {"--checkpoint", "keep the Renderer, which goes on"},
    {"--log-level", "use RendererOptions::log"},
    {"--memory-limit", "limit the process"},
    {"--nthreads", "use RendererOptions::threads"},
    {"--output", "use Picture::save()"},
    {"--quiet", "leave RendererOptions::log out"},
    {"--stats", "use Renderer::statistics()"},
    {"--threads", "use RendererOptions::threads"},
}};

const engine::RenderFlag& flag_of(const std::string& name) {
    const std::string flag = engine::flag_name(name);
    if (const ProgramFlag* const row = engine::row_named(kProgramFlags, flag))
        throw Error({flag}, "is no setting of a render", std::string(row->in_its_place));
    return engine::render_flag(flag);
}

SettingInfo info_of(const engine::RenderFlag& flag) {
    SettingInfo info;
    info.name = flag.name.substr(2);
    info.form = flag.value.form;
    for (const engine::FlagChoice& choice : flag.value.choices) info.choices.push_back(choice.name);
    info.repeats = flag.value.repeats;
    info.default_value = flag.default_value;
    info.help = engine::help_text(flag);
    return info;
}

}  // namespace

engine::RenderRequest Settings::Data::request() const {
    engine::RenderFlags flags;
    for (const auto& [name, given] : texts)
        for (const std::string& text : given) flags.set(name, text);
    return flags.finish();
}

Settings::Settings() : data_(std::make_unique<Data>()) {}
Settings::~Settings() = default;
Settings::Settings(const Settings& other) : data_(std::make_unique<Data>(*other.data_)) {}
Settings& Settings::operator=(const Settings& other) {
    data_ = std::make_unique<Data>(*other.data_);
    return *this;
}
Settings::Settings(Settings&&) noexcept = default;
Settings& Settings::operator=(Settings&&) noexcept = default;

Settings& Settings::set(const std::string& name, const std::string& value) {
    const engine::RenderFlag& flag = flag_of(name);
    engine::RenderFlags().set(flag.name, value);  // throws for a word that the flag does not take
    engine::RenderRequest request;
    flag.value.read(request, value, flag.name);  // throws for a value that it cannot have
    std::vector<std::string>& texts = data_->texts[flag.name];
    if (!flag.value.repeats) texts.clear();
    texts.push_back(value);
    return *this;
}

Settings& Settings::set(const std::string& name, double value) {
    return set(name, fmt::format("{}", value));
}

Settings& Settings::set(const std::string& name, bool value) {
    const engine::RenderFlag& flag = flag_of(name);
    const std::vector<engine::FlagChoice>& choices = flag.value.choices;
    const std::string word = !value ? "off" : engine::row_named(choices, "on") ? "on" : "auto";
    if (!engine::row_named(choices, word))
        throw Error({flag.name}, "is not a matter of on and off", "give it " + flag.value.form);
    return set(name, word);
}

void Settings::validate() const {
    data_->request();
}

SettingInfo Settings::find(const std::string& name) {
    return info_of(flag_of(name));
}

std::vector<SettingInfo> Settings::list() {
    std::vector<SettingInfo> all;
    for (const engine::RenderFlag& flag : engine::render_flags()) all.push_back(info_of(flag));
    return all;
}

}  // namespace sunfleck
