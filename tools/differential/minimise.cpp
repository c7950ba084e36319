// Greedy removal, in rounds until one changes nothing.
#include "differential/minimise.h"

#include <cstddef>

namespace sunfleck::engine::differential {
namespace {

class Minimiser {
public:
    Minimiser(SceneText scene, const std::function<bool(const SceneText&)>& still_fails,
              int most_tries)
        : scene_(std::move(scene)), still_fails_(still_fails), tries_left_(most_tries) {}

    SceneText run() {
        do {
            has_changed_ = false;
            drop_each(
                [this]() -> auto& { return scene_.world; }, is_droppable_block);
            for_blocks([this](const auto& block) {
                drop_each(
                    [&]() -> auto& { return block().statements; },
                    [](const Statement& statement) { return !statement.is_kept; });
            });
            for_blocks([this](const auto& block) {
                for (std::size_t s = 0; s < block().statements.size(); ++s)
                    if (!block().statements[s].is_kept)
                        drop_each(
                            [&]() -> auto& { return block().statements[s].parameters; },
                            [](const std::string&) { return true; });
            });
        } while (has_changed_ && tries_left_ > 0);
        return scene_;
    }

private:
    static bool is_droppable_block(const Block& block) {
        for (const Statement& statement : block.statements)
            if (statement.is_kept) return false;
        return true;
    }

    template <class Visit>
    void for_blocks(const Visit& visit) {
        visit([this]() -> Block& { return scene_.options; });
        for (std::size_t b = 0; b < scene_.world.size(); ++b)
            visit([this, b]() -> Block& { return scene_.world[b]; });
    }

    /// @param list  finds the list in the scene as it is: a failed try puts another one there.
    template <class List, class May>
    void drop_each(const List& list, const May& may_drop) {
        for (std::size_t i = list().size(); i-- > 0 && tries_left_ > 0;) {
            if (!may_drop(list()[i])) continue;
            const SceneText before = scene_;
            list().erase(list().begin() + static_cast<std::ptrdiff_t>(i));
            --tries_left_;
            if (still_fails_(scene_))
                has_changed_ = true;
            else
                scene_ = before;
        }
    }

    SceneText scene_;
    const std::function<bool(const SceneText&)>& still_fails_;
    int tries_left_;
    bool has_changed_ = false;
};

}  // namespace

SceneText minimised(SceneText scene, const std::function<bool(const SceneText&)>& still_fails,
                    int most_tries) {
    return Minimiser(std::move(scene), still_fails, most_tries).run();
}

}  // namespace sunfleck::engine::differential
