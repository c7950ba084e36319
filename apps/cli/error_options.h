// Flags about the bias of the discs: whether it is subtracted, and whether it counts.
#pragma once

#include "apps/cli/options.h"

namespace CLI {
class App;
}

namespace sunfleck::engine {

/// Flags whose text is a choice.
struct ErrorTexts {
    std::string extrapolate = "off";
    std::string target_error_of = "all";
};

void add_extrapolate_flag(CLI::App& app, ErrorTexts& texts);
/// That one, and what else a render has.
void add_error_flags(CLI::App& app, ErrorTexts& texts);

/// After integrator and sampler are known.
/// @throws Error for a flag where nothing is gathered from discs that shrink.
void finish_error(const CLI::App& given, const ErrorTexts& texts, RenderOptions& options);

}  // namespace sunfleck::engine
