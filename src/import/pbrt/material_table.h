// Material statements of a scene file, by the slots and the names that shapes and mixes refer to.
#pragma once

#include "import/pbrt/parameters.h"

#include <map>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// Slot 0 is pbrt-v4's default, diffuse 0.5.
class MaterialTable {
public:
    MaterialTable();

    /// A slot for a Material statement. @throws Error for an unknown type.
    std::uint32_t add(Statement statement);
    /// The slot of a name, which may be made later. @param from  the statement that names it.
    std::uint32_t slot_of(const std::string& name, const SourceLocation& from);
    /// MakeNamedMaterial. @throws Error for a name made before, or an unknown type.
    void make(const std::string& name, Statement statement);

    /// VisibleFlags a slot as that of a shape: its name must be made before the end.
    void use(std::uint32_t slot) { slots_[slot].used = true; }
    /// The statement that made the name. @throws Error when there is none.
    const Statement& named(const std::string& name, const SourceLocation& from) const;
    /// Has a statement made the name?
    bool is_made(const std::string& name) const { return named_.contains(name); }

    struct Slot {
        std::optional<Statement> statement;  // nothing: the slot is that of the name
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
