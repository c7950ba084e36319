// Blocks, defaults and matrices of a reading.
#include "import/pbrt/reading.h"

#include "import/pbrt/transforms.h"

#include <algorithm>

namespace sunfleck::engine {

void Reading::warn_unused_defaults() {
    for (const auto& parameter : defaults)
        if (!parameter->used)
            log.warn(parameter->where, "parameter " + parameter->title() +
                                           " of Attribute is ignored: no later statement uses it");
}

void Reading::check_blocks_closed(std::size_t base) const {
    if (blocks.size() <= base) return;
    const Block& block = blocks.back();
    const std::string end = block.begin.substr(0, block.begin.size() - 5) + "End";
    throw Error(block.where, block.begin + " is not closed", "add " + end);
}

Matrix Reading::still_matrix(const SourceLocation& where) {
    return still(state.matrix, where);
}

Matrix Reading::still(const Motion& motion, const SourceLocation& where) {
    if (!is_finite_float(motion[0]) || !is_finite_float(motion[1]))
        throw Error(where, "the transformation is beyond the range of floats",
                    "keep the entries of its matrix below 3.4e38");
    if (motion[0] == motion[1]) return motion[0];
    log.warn(where,
             "motion is not simulated: objects stay where they are in the middle of the exposure");
    const double open = options.camera ? options.camera->real("shutteropen", 0) : 0;
    const double close = options.camera ? options.camera->real("shutterclose", 1) : 1;
    const double span = transform_times[1] - transform_times[0];
    const double elapsed = 0.5 * (open + close) - transform_times[0];
    const double share = span > 0 ? std::clamp(elapsed / span, 0.0, 1.0) : elapsed > 0 ? 1 : 0;
    return between(motion[0], motion[1], share);
}

}  // namespace sunfleck::engine
