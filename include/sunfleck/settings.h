// What is asked of a render, by the names of the command line's flags.
#pragma once

#include <sunfleck/export.h>

#include <concepts>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace sunfleck {

/// A flag of `sunfleck render` that is also a setting.
struct SUNFLECK_API SettingInfo {
    std::string name;                  // "photons-per-pass"
    std::string form;                  // "N", "WxH", "on|off"
    std::vector<std::string> choices;  // all words that it takes; empty: any that fits the form
    bool repeats = false;              // set() adds to it
    std::string default_value;         // where it is not set; empty: nothing
    std::string help;
};

/// A value that may be copied. For one thread at a time; const calls for any number.
class SUNFLECK_API Settings {
public:
    Settings();
    ~Settings();
    Settings(const Settings&);
    Settings& operator=(const Settings&);
    Settings(Settings&&) noexcept;
    Settings& operator=(Settings&&) noexcept;

    /// Sets a flag: set("photons-per-pass", 1000000).set("seed", 7).set("aovs", "caustic,depth").
    /// @param name  with or without "--"; "_" counts as "-". @param value  as on the command line.
    /// @throws Error  for a name that no setting has, and a value that it cannot have.
    Settings& set(const std::string& name, const std::string& value);
    Settings& set(const std::string& name, const char* value) {
        return set(name, std::string(value));
    }
    Settings& set(const std::string& name, std::string_view value) {
        return set(name, std::string(value));
    }
    Settings& set(const std::string& name, double value);
    template <std::integral Whole>
    Settings& set(const std::string& name, Whole value) {
        return set(name, std::to_string(value));
    }
    /// Sets what is on or off, or chosen by the renderer (auto) or off.
    Settings& set(const std::string& name, bool value);

    /// @throws Error  for a value that cannot be used, and for settings that do not go together.
    void validate() const;

    /// The setting of that name, as for set(). @throws Error  if there is none.
    static SettingInfo find(const std::string& name);
    /// All settings that there are, in the order of the help.
    static std::vector<SettingInfo> list();

    // For the library alone.
    struct Data;
    const Data& data() const { return *data_; }

private:
    std::unique_ptr<Data> data_;
};

}  // namespace sunfleck
