// Indented as a person would write it.
#include "differential/scene_text.h"

namespace sunfleck::engine::differential {
namespace {

void append(std::string& text, const Block& block, const char* indent) {
    for (const Statement& statement : block.statements) {
        text += indent + statement.head;
        for (const std::string& parameter : statement.parameters)
            text += (statement.parameters.size() > 1 ? "\n    " : " ") + parameter;
        text += '\n';
    }
}

}  // namespace

std::string text_of(const SceneText& scene) {
    std::string text;
    append(text, scene.options, "");
    text += "WorldBegin\n";
    for (const Block& block : scene.world) {
        if (block.is_scoped) text += "AttributeBegin\n";
        append(text, block, block.is_scoped ? "  " : "");
        if (block.is_scoped) text += "AttributeEnd\n";
    }
    return text;
}

}  // namespace sunfleck::engine::differential
