// Inclusions: the total length of a scene with its Includes and Imports, computed before it is
// read.
//
// The language has no conditions, so a file has the same words each time it is included. The total
// is computed without reading files repeatedly.
#pragma once

#include "import/pbrt/file_access.h"
#include "import/pbrt/token_stream.h"

#include <functional>
#include <map>
#include <set>
#include <string>

namespace sunfleck::engine {

class Inclusions {
public:
    /// Returns the file of that name. @throws Error  if there is none.
    using Files = std::function<NamedFile(const std::string& name, const SourceLocation& from)>;

    /// Notes that a file is included. When a file is included for the second time, the total is
    /// computed.
    /// @param path  of the included file.
    /// @param root  the main file.
    /// @throws Error  for a scene whose files expand to more than a thousand million words.
    void add(const std::string& path, const SourceLocation& from, const Lexer& root,
             const Files& files);

private:
    double words_of(const std::string& path, const std::string& text, const Files& files);
    double words_included(const Token& name, const Files& files);

    std::set<std::string> included_;
    std::map<std::string, double> words_;  // of a file with its inclusions, by path
    double distinct_ = 0;                  // words in the files themselves
    int depth_ = 0;                        // of the file that is being counted
    bool is_counted_ = false;
};

}  // namespace sunfleck::engine
