// Settings by the table of flags that the command line reads.
#include "sunfleck/settings.h"

#include "core/named_rows.h"
#include "library/settings_data.h"

#include <fmt/format.h>

namespace sunfleck {
namespace {

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
    const engine::RenderFlag& flag = engine::render_flag(name);
    engine::RenderFlags().set(flag.name, value);  // throws for a word that the flag does not take
    std::vector<std::string>& texts = data_->texts[flag.name];
    if (!flag.value.repeats) texts.clear();
    texts.push_back(value);
    return *this;
}

Settings& Settings::set(const std::string& name, double value) {
    return set(name, fmt::format("{}", value));
}

Settings& Settings::set(const std::string& name, bool value) {
    const engine::RenderFlag& flag = engine::render_flag(name);
    const std::string yes = engine::row_named(flag.value.choices, "on") ? "on" : "auto";
    return set(name, value ? yes : "off");
}

void Settings::validate() const {
    data_->request();
}

SettingInfo Settings::find(const std::string& name) {
    return info_of(engine::render_flag(name));
}

std::vector<SettingInfo> Settings::list() {
    std::vector<SettingInfo> all;
    for (const engine::RenderFlag& flag : engine::render_flags()) all.push_back(info_of(flag));
    return all;
}

}  // namespace sunfleck
