// The table of materials.
#include "import/pbrt/material_table.h"

#include "import/pbrt/materials.h"
#include "import/pbrt/version3.h"
#include "import/pbrt/words.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

void check_type(const Statement& statement) {
    const auto known = material_types();
    if (std::find(known.begin(), known.end(), statement.type) != known.end()) return;
    throw Error(statement.where, "unknown material " + in_quotes(statement.type),
                use_one_of(known, statement.type));
}

}  // namespace

MaterialTable::MaterialTable() {
    Statement grey;
    grey.keyword = "Material";
    grey.type = "diffuse";
    slots_.push_back({grey, "", {}, false});
}

std::uint32_t MaterialTable::add(Statement statement) {
    check_type(statement);
    slots_.push_back({std::move(statement), "", {}, false});
    return static_cast<std::uint32_t>(slots_.size() - 1);
}

std::uint32_t MaterialTable::slot_of(const std::string& name, const SourceLocation& from) {
    const auto next = static_cast<std::uint32_t>(slots_.size());
    const auto [place, is_new] = slot_by_name_.try_emplace(name, next);
    if (is_new) slots_.push_back({std::nullopt, name, from, false});
    return place->second;
}

void MaterialTable::make(const std::string& name, Statement statement) {
    const auto type = statement.text("type");
    if (!type)
        throw Error(statement.where, "named material " + in_quotes(name) + " has no type",
                    "add \"string type\" \"diffuse\" or another");
    statement.type = *type;
    check_not_of_v3("Material", *type, statement.where);
    check_type(statement);
    const SourceLocation where = statement.where;
    if (!named_.try_emplace(name, std::move(statement)).second)
        throw Error(where, "a second material " + in_quotes(name), "give it another name");
}

const Statement& MaterialTable::named(const std::string& name, const SourceLocation& from) const {
    const auto found = named_.find(name);
    if (found != named_.end()) return found->second;
    throw Error(from, "there is no material " + in_quotes(name),
                "make the material, or name another: " + did_you_mean(names_of(named_), name));
}

}  // namespace sunfleck::engine
