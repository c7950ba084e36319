// The flags of a render: a front end sets them by name and text, and gets a RenderRequest.
//
// The command line, its help, completion and man pages, and the Python module read one table.
#pragma once

#include "flags/flag.h"

#include <map>

namespace sunfleck::engine {

/// All flags of a render, in the order of the help. --photon-sampler stands before the flags that
/// change what a sampler prescribes: texts are read in this order.
const std::vector<RenderFlag>& render_flags();

/// Heading of the flags that every command has that writes pictures.
inline constexpr const char* kPictureFilesGroup = "Picture files";

/// @param name  of a flag or its alias: "--light-group", "light-group" or "light_group".
/// @throws Error for a name that no flag has, with the new name if one had it before.
const RenderFlag& render_flag(const std::string& name);
/// Returns a name as flags are written: "--light-group" of "light_group".
std::string flag_name(std::string name);

/// Collects flags one by one.
class RenderFlags {
public:
    /// @param name  as for render_flag().
    /// @throws Error for an unknown name, a word that is none of the flag's choices, and a flag
    ///         that is given twice.
    void set(const std::string& name, const std::string& text);

    /// Returns the request of all flags together. @throws Error, naming a flag, for a text that
    /// cannot be used and for flags that exclude each other.
    RenderRequest finish() const;

private:
    /// The value of a flag, as it was given or as it stands without.
    std::string text_of(const std::string& name) const;
    void check(const RenderFlag& flag, const FlagNeed& need) const;

    std::map<std::string, std::vector<std::string>> texts_;  // by the flag's name
};

}  // namespace sunfleck::engine
