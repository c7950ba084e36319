// Conversion of table entries, and the components of mixes.
#include "import/pbrt/scene_materials.h"

#include "import/pbrt/materials.h"
#include "import/pbrt/names.h"
#include "import/pbrt/words.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace sunfleck::engine {
namespace {

constexpr int kDeepestMix = 32;

/// Looks up the components of mixes.
class MixComponents {
public:
    MixComponents(MaterialTable& table, ImportLog& log) : table_(table), log_(log) {}

    /// Returns the mix with the entries of its components. If one component is an interface, the
    /// other is used everywhere. @throws Error  for cyclic mixes.
    Material complete(MixMaterial mix, const Statement& statement) {
        const Parameter& names = checked_components(statement, 0);
        std::vector<std::string> there;
        for (const std::string& name : names.texts)
            if (!is_interface(name, names.where)) there.push_back(name);
        if (there.size() < 2)
            log_.warn(
                statement.where,
                "a mix with \"interface\" is not simulated: the other material is used everywhere");
        if (there.empty()) return InterfaceMaterial{};
        for (std::size_t i = 0; i < 2; ++i) {
            mix.components.at(i) =
                table_.slot_of(there.at(std::min(i, there.size() - 1)), names.where);
            table_.use(mix.components.at(i));
        }
        return mix;
    }

private:
    bool is_interface(const std::string& name, const SourceLocation& where) const {
        if (name == "interface" || name == "none" || name.empty()) return true;
        const std::string& type = table_.named(name, where).type;
        return type == "interface" || type == "none" || type.empty();
    }

    /// Returns the names of both components. All mixes below are checked, each once.
    const Parameter& checked_components(const Statement& statement, int depth) {
        const Parameter* names = statement.find("materials", ParameterType::text);
        if (!names || names->texts.size() != 2)
            throw Error(statement.where, "a mix without two materials",
                        "add \"string materials\" [ \"one\" \"another\" ]");
        if (depth >= kDeepestMix)
            throw Error(statement.where,
                        "mixes refer to each other in a cycle, or more than " +
                            std::to_string(kDeepestMix) + " deep",
                        "break the cycle, or mix fewer");
        for (const std::string& name : names->texts) {
            if (is_interface(name, names->where)) continue;
            const Statement& part = table_.named(name, names->where);
            if (part.type != "mix" || sound_.contains(&part)) continue;
            checked_components(part, depth + 1);
            sound_.insert(&part);
        }
        return *names;
    }

    MaterialTable& table_;
    ImportLog& log_;
    std::set<const Statement*> sound_;  // named mixes that are known to end
};

}  // namespace

void finish_materials(MaterialTable& table, Assets& assets, SceneDescription& scene) {
    MixComponents components(table, assets.log);
    // NOLINTNEXTLINE(modernize-loop-convert): mixes add slots of their components
    for (std::size_t i = 0; i < table.slots().size(); ++i) {
        const MaterialTable::Slot slot = table.slots()[i];
        Material& material = scene.materials.emplace_back(DiffuseMaterial{});
        BumpMap& bump_map = scene.bump_maps.emplace_back();
        scene.material_names.push_back(slot.statement ? material_name(*slot.statement) : slot.name);
        if (!slot.statement && !slot.used && !table.is_made(slot.name)) {
            assets.log.warn(slot.from, "there is no material " + in_quotes(slot.name) +
                                           ", but no shape uses it");
            continue;
        }
        const Statement& statement =
            slot.statement ? *slot.statement : table.named(slot.name, slot.from);
        assets.log.count_word("Material", statement.type);
        try {
            material = material_of(statement, assets);
            if (const auto* mix = std::get_if<MixMaterial>(&material))
                material = components.complete(*mix, statement);
            bump_map = bump_map_of(statement, assets);
            assets.log.warn_unused(statement);
        } catch (const MissingFile& missing) {
            assets.files.note_missing(missing);
        }
    }
}

}  // namespace sunfleck::engine
