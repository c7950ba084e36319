// Views of one scene: all that follows WorldBegin, and all other files, have the same bytes.
#pragma once

#include "procedural/scene_file.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace sunfleck::engine {

inline std::string world(const SceneFile& file) {
    return file.bytes.substr(file.bytes.find("WorldBegin"));
}

/// @param files_of  returns the files of a view.
template <class Views, class FilesOf>
void expect_one_world(const Views& views, const FilesOf& files_of) {
    const std::vector<SceneFile> whole = files_of(views[0]);
    for (const auto& view : views) {
        const std::vector<SceneFile> closer = files_of(view);
        EXPECT_EQ(world(closer.at(0)), world(whole.at(0)));
        for (std::size_t i = 1; i < whole.size(); ++i)
            EXPECT_EQ(closer.at(i).bytes, whole.at(i).bytes);
    }
}

}  // namespace sunfleck::engine
