// MaterialTable: the material statements of a scene, by index and by name.
#pragma once

#include "import/pbrt/parameters.h"

#include <map>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// Index 0 is pbrt-v4's default, diffuse 0.5.
class MaterialTable {
public:
    MaterialTable();

    /// Adds a Material statement. @throws Error  for an unknown type.
    std::uint32_t add(Statement statement);
    /// Returns the index of a name, which may be made later. @param from  statement that names it.
    std::uint32_t slot_of(const std::string& name, const SourceLocation& from);
    /// Adds a MakeNamedMaterial. @throws Error  for a repeated name, or an unknown type.
    void make(const std::string& name, Statement statement);

    /// Marks an entry as used by a shape: its name must be made before the end.
    void use(std::uint32_t slot) { slots_[slot].used = true; }
    /// Returns the statement that made the name. @throws Error  if there is none.
    const Statement& named(const std::string& name, const SourceLocation& from) const;
    /// Returns whether a statement has made the name.
    bool is_made(const std::string& name) const { return named_.contains(name); }

    struct Slot {
        std::optional<Statement> statement;  // nothing if the entry refers to the name
        std::string name;
        SourceLocation from;
        bool used = false;
    };
    const std::vector<Slot>& slots() const { return slots_; }

private:
    std::vector<Slot> slots_;
    std::map<std::string, std::uint32_t> slot_by_name_;
    std::map<std::string, Statement> named_;
};

}  // namespace sunfleck::engine
