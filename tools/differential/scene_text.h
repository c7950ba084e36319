// A scene file as a tree that can be made smaller: blocks of statements with parameters.
#pragma once

#include <string>
#include <vector>

namespace sunfleck::engine::differential {

/// A directive, its own words and its parameters: Shape "sphere" | "float radius" 1.
struct Statement {
    std::string head;
    std::vector<std::string> parameters;
    bool is_kept = false;  // statement and parameters stay in every smaller scene

    friend bool operator==(const Statement&, const Statement&) = default;
};

/// Statements that belong together; in AttributeBegin and AttributeEnd where they are `scoped`.
struct Block {
    bool is_scoped = true;
    std::vector<Statement> statements;

    friend bool operator==(const Block&, const Block&) = default;
};

struct SceneText {
    Block options;  // what stands before WorldBegin
    std::vector<Block> world;

    friend bool operator==(const SceneText&, const SceneText&) = default;
};

/// The scene as pbrt-v4 reads it.
std::string text_of(const SceneText& scene);

}  // namespace sunfleck::engine::differential
