// Textures by name, as far as they are read: constants; of others it is said what stands in.
#pragma once

#include "import/pbrt/parameters.h"
#include "import/pbrt/spectra.h"

#include <map>
#include <utility>

namespace sunfleck {

class TextureTable {
public:
    /// @param kind  "float" or "spectrum". @param statement  its type is the class.
    /// @throws Error for an unknown kind or class, or a name given before.
    void add(const std::string& kind, const std::string& name, Statement statement);

    /// The texture that a parameter names. @throws Error when there is none.
    const Statement& at(const std::string& kind, const Parameter& parameter) const;

private:
    std::map<std::pair<std::string, std::string>, Statement> textures_;  // by kind and name
};

/// A spectrum or a spectrum texture: constants as they are, for others `stand_in` and a warning.
std::optional<SpectralCurve> find_textured_curve(const Statement& statement, std::string_view name,
                                                 SpectrumUse use, float stand_in, Reading& reading);

/// A number or a float texture: constants as they are, for others `stand_in` and a warning.
std::optional<double> find_textured_real(const Statement& statement, std::string_view name,
                                         double stand_in, Reading& reading);

}  // namespace sunfleck
