// No output over an input or another output: files are known by device and inode.
#include "apps/cli/outputs.h"
#include "apps/cli/snapshots.h"
#include "core/file_identity.h"
#include "core/small_letters.h"
#include "sunfleck/error.h"

#include <filesystem>
#include <map>

namespace sunfleck::engine {
namespace {

namespace fs = std::filesystem;

const char* const kMend = "give each file a name of its own";

/// Files by what they are; each with the name that the command has for it.
using KnownFiles = std::map<FileIdentity, std::string>;

KnownFiles known_files(const std::vector<std::string>& names) {
    KnownFiles known;
    for (const std::string& name : names)
        if (const auto identity = identity_of(name == "-" ? "/dev/stdin" : name))
            known.emplace(*identity, name);
    return known;
}

/// Two files that are yet to be made are one where their folder ignores the case of names.
bool are_one_but_for_case(const FileIdentity& a, const FileIdentity& b, const std::string& path) {
    return a.device == b.device && a.inode == b.inode && !a.new_name.empty() &&
           small_letters(a.new_name) == small_letters(b.new_name) && ignores_case(path);
}

void check_outputs_apart(const std::vector<std::string>& outputs, const KnownFiles& inputs) {
    KnownFiles known;
    for (const std::string& output : outputs) {
        const auto identity = identity_of(output);
        if (!identity) continue;
        if (const auto input = inputs.find(*identity); input != inputs.end())
            throw Error({output}, "would replace " + input->second + ", which the command reads",
                        kMend);
        for (const auto& [other, name] : known)
            if (other == *identity || are_one_but_for_case(other, *identity, output))
                throw Error({output}, "is to be written twice", kMend);
        known.emplace(*identity, output);
    }
}

/// Neither may a snapshot take the place of a file, nor what a snapshot's name is a link to.
void check_snapshots_apart(const std::string& folder, const CommandFiles& files) {
    const auto place = identity_of(folder);
    std::vector<std::string> all = files.inputs;
    all.insert(all.end(), files.outputs.begin(), files.outputs.end());
    const auto refuse = [&](const std::string& file) {
        throw Error({file}, "would be replaced by a snapshot in " + folder, "name another folder");
    };
    for (const std::string& file : all) {
        const fs::path target = link_target(file);
        const fs::path parent = target.parent_path().empty() ? "." : target.parent_path();
        if (is_snapshot(target.filename()) && identity_of(parent) == place) refuse(file);
    }
    const KnownFiles known = known_files(all);
    std::error_code code;
    for (const auto& entry : fs::directory_iterator(folder, code)) {
        if (!is_snapshot(entry.path().filename())) continue;
        const auto identity = identity_of(entry.path());
        if (identity && known.contains(*identity)) refuse(known.at(*identity));
    }
}

}  // namespace

void check_apart(const CommandFiles& files) {
    check_outputs_apart(files.outputs, known_files(files.inputs));
    if (!files.snapshots.empty()) check_snapshots_apart(files.snapshots, files);
}

}  // namespace sunfleck::engine
