// What a Settings of the interface holds: the texts of flags.
#pragma once

#include "flags/render_flags.h"
#include "sunfleck/settings.h"

#include <map>
#include <string>
#include <vector>

namespace sunfleck {

struct Settings::Data {
    std::map<std::string, std::vector<std::string>> texts;  // by the flag's name

    /// @throws Error  as Settings::validate() does.
    engine::RenderRequest request() const;
};

}  // namespace sunfleck
