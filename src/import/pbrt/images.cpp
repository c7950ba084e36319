// The table of images.
#include "import/pbrt/images.h"

#include "core/parallel.h"
#include "image/read_image.h"

#include <utility>

namespace sunfleck::engine {

void warn_of_image(const Image& image, const std::string& path, const SourceLocation& from,
                   ImportLog& log) {
    if (image.has_other_primaries())
        log.warn(from, "the colours of " + path +
                           " are of other primaries than sRGB's (chromaticities): they are "
                           "taken for sRGB's");
    if (!image.remark().empty()) log.warn(from, path + ": " + image.remark());
    const BrokenTexels& broken = image.broken();
    if (broken.count > 0)
        log.warn(from, std::to_string(broken.count) + " texels of " + path +
                           " are no finite numbers, the first at (" +
                           std::to_string(broken.first.x) + ", " + std::to_string(broken.first.y) +
                           "): infinite values are taken for 65504, others for 0");
}

std::shared_ptr<const Image> ImageTable::enter(const std::string& name, const Encoding& encoding,
                                               const SourceLocation& from) {
    const auto [place, is_new] =
        numbers_.try_emplace({files_.path_of(name), encoding}, slots_.size());
    if (is_new) slots_.push_back({name, encoding, from, std::make_shared<Image>()});
    return slots_[place->second].image;
}

/// May run beside others. A missing file's image has one texel, so that reading goes on to what
/// else is missing.
void ImageTable::load(const Slot& slot, Loaded& loaded) const {
    try {
        loaded.file = files_.find(slot.name, slot.from);
        *slot.image = parse_image(loaded.file.bytes, loaded.file.path, slot.encoding);
        slot.image->mend_broken();
    } catch (const MissingFile& missing) {
        loaded.missing = missing;
        *slot.image = Image({1, 1}, 1, std::vector<float>(1));
    } catch (const Error& fault) {
        loaded.fault = fault.where().file == slot.from.file ? fault : fault.asked_for_at(slot.from);
    }
    loaded.file.bytes = {};
}

void ImageTable::load() {
    const std::size_t first = std::exchange(loaded_, slots_.size());
    std::vector<Loaded> loaded(slots_.size() - first);
    parallel_for(loaded.size(), [&](std::size_t i) { load(slots_[first + i], loaded[i]); });
    for (std::size_t i = 0; i < loaded.size(); ++i) {
        const Slot& slot = slots_[first + i];
        if (loaded[i].missing) {
            files_.note_missing(*loaded[i].missing);
            continue;
        }
        if (loaded[i].fault) throw Error(*loaded[i].fault);
        files_.note(loaded[i].file, slot.from);
        warn_of_image(*slot.image, loaded[i].file.path, slot.from, log_);
    }
}

}  // namespace sunfleck::engine
