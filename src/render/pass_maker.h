// Passes one after the other, each added to a film.
#pragma once

#include "render/paper.h"
#include "render/progressive.h"

#include <optional>

namespace sunfleck {

/// Does each pass build on those before?
bool is_sequential(const RenderSettings& settings);

/// What is known of a pass beside what the film counts.
struct PassNote {
    std::vector<GroupCounts> groups;
    double radius_factor = 1;
};

class PassMaker {
public:
    /// @param state  its seconds grow with each pass; with the sampler `paper` its memory goes on.
    PassMaker(const RenderJob& job, RenderState& state);

    /// Renders a pass and adds it, with all that it counted, to a film of this job.
    PassNote make(std::uint32_t number, Film& film);

private:
    const RenderJob& job_;
    RenderState& state_;
    std::optional<Epoch> epoch_;
    std::optional<PaperRender> paper_;
};

}  // namespace sunfleck
