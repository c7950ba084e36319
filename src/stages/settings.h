// RenderSettings: all that a user may choose about a render, stage by stage.
#pragma once

#include "aovs/channels.h"
#include "aovs/objective.h"
#include "aovs/pass_image.h"
#include "aovs/transport.h"
#include "camera_paths/settings.h"
#include "core/named_rows.h"
#include "film/target_error.h"
#include "photon/settings.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sunfleck::engine {

enum class Integrator { sppm, path, light, bdpt, mlt };

inline constexpr std::array<ChoiceRow<Integrator>, 5> kIntegrators = {{
    {Integrator::sppm, "sppm", "stochastic progressive photon mapping"},
    {Integrator::path, "path", "reference path tracer"},
    {Integrator::light, "light", "reference light tracer"},
    {Integrator::bdpt, "bdpt", "reference bidirectional path tracer"},
    {Integrator::mlt, "mlt", "reference Metropolis light transport"},
}};

inline std::string_view name_of(Integrator integrator) {
    return kIntegrators.at(static_cast<std::size_t>(integrator)).name;
}

/// Settings that, with the scene, determine a pass.
struct RenderSettings {
    Integrator integrator = Integrator::sppm;
    TransportSettings transport;
    CameraPathSettings camera;
    PhotonSettings photon;
    double alpha = 2.0 / 3.0;  // of the radius sequence, in (0,1)
    AovSet aovs{};
    Objective objective = Objective::relative;  // of what the sampler `adaptive` measures
    std::uint64_t seed = 0;
    /// Pixels of a picture whose first passes are small (film/pass_weight.h).
    std::size_t large_picture = 1'000'000;
    bool energy_compensation = false;  // of the scene's materials: compensate_energy()

    /// Lines that two renders share if and only if their passes are the same function of scene and
    /// seed: what film files are compared by.
    std::string text() const;
};

/// Sets what the sampler `paper` prescribes: all light by photons, alpha 0.7, one radius for all
/// kinds of photons (paper, section 7), of two pixels unless the user has set it.
void use_paper_mode(RenderSettings& settings);

/// Returns the number of small passes of a picture (film/pass_weight.h).
std::uint64_t small_passes(const RenderSettings& settings, std::size_t pixels);

inline bool is_small_pass(const RenderSettings& settings, std::size_t pixels, std::uint64_t pass) {
    return pass < small_passes(settings, pixels);
}

/// Returns whether each pass depends on those before it.
bool is_sequential(const RenderSettings& settings);

/// Limits of a render, of which the first reached ends it. Passes are always finished.
struct StopSettings {
    std::uint32_t first_pass = 0;
    std::optional<std::uint32_t> end_pass;  // index after the last pass
    std::optional<double> seconds;          // on the wall
    std::optional<double> cpu_seconds;      // of all threads together
    std::optional<double> target_error;     // relative, of blocks: film/target_error.h
    ErrorTerms error_terms{};               // terms of the target error
};

}  // namespace sunfleck::engine
