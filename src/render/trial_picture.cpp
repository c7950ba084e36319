// The pixels that a trial has traced, close together.
#include "render/trial_picture.h"

namespace sunfleck::engine {

Picture trial_picture(const CameraTrial& trial, const PixelWindow& window) {
    const PixelCells cells{window, trial.cells};
    Picture picture{cells.across(), cells.down(), {}, {}};
    for (std::size_t c = 0; c < kAovs[0].channels.size(); ++c) {
        std::vector<float>& values = picture.add(std::string(1, kAovs[0].channels[c])).values;
        auto value = values.begin();
        for (int y = 0; y < cells.down(); ++y)
            for (int x = 0; x < cells.across(); ++x)
                *value++ = static_cast<float>(
                    trial.image.value(Aov::total, cells.pixel_of(x, y), c).to_double());
    }
    return picture;
}

}  // namespace sunfleck::engine
