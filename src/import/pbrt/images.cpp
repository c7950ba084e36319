// The table of images.
#include "import/pbrt/images.h"

#include "core/parallel.h"
#include "image/read_image.h"
#include "import/pbrt/reading.h"

#include <optional>
#include <utility>

namespace sunfleck {

std::shared_ptr<const Image> ImageTable::enter(const std::string& name, const Encoding& encoding,
                                               const SourceLocation& from, Reading& reading) {
    const std::string path = resolved(name, reading.folder);
    const auto [place, is_new] = numbers_.try_emplace({path, encoding}, slots_.size());
    if (is_new) {
        reading.count_file(path, from);
        slots_.push_back({path, encoding, from, std::make_shared<Image>()});
    }
    return slots_[place->second].image;
}

void ImageTable::load(const Reading& reading) {
    const std::size_t first = std::exchange(loaded_, slots_.size());
    std::vector<std::optional<Error>> faults(slots_.size() - first);
    parallel_for(faults.size(), [&](std::size_t i) {
        const Slot& slot = slots_[first + i];
        try {
            *slot.image =
                parse_image(reading.files(slot.path, slot.from), slot.path, slot.encoding);
        } catch (const Error& fault) {
            faults[i] = fault;
        }
    });
    for (const std::optional<Error>& fault : faults)
        if (fault) throw Error(*fault);
}

}  // namespace sunfleck
