// Materials of a scene file: slots that shapes refer to, filled in when all files have ended.
#pragma once

#include "import/pbrt/parameters.h"

#include <map>
#include <string>
#include <vector>

namespace sunfleck {

struct Reading;

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

    /// All slots as materials of the scene. @throws Error for names that were never made, though a
    /// shape uses them, and for parameters that cannot be used.
    void finish(Reading& reading);

    /// Marks a slot as that of a shape: its name must be made before the end.
    void use(std::uint32_t slot) { slots_[slot].used = true; }
    /// The statement that made the name. @throws Error when there is none.
    const Statement& named(const std::string& name, const SourceLocation& from) const;

private:
    struct Slot {
        std::optional<Statement> statement;
        std::string name;
        SourceLocation from;
        bool used = false;
    };

    std::vector<Slot> slots_;
    std::map<std::string, std::uint32_t> slot_by_name_;
    std::map<std::string, Statement> named_;
};

}  // namespace sunfleck
