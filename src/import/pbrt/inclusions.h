// How much text Include and Import make out of the files of a scene, before it is read.
//
// The language has no conditions: a file holds the same words whenever it is included, so what a
// scene amounts to is counted without reading it that often.
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
    /// The file of that name. @throws Error if there is none.
    using Files = std::function<NamedFile(const std::string& name, const SourceLocation& from)>;

    /// Notes that a file is included. The first time that one is included again, all that the
    /// scene amounts to is counted.
    /// @param path  of the included file. @param root  the main file. @throws Error  for a scene
    /// whose repeated files amount to more than a thousand million words.
    void add(const std::string& path, const SourceLocation& from, const Lexer& root,
             const Files& files);

private:
    double words_of(const std::string& path, const std::string& text, const Files& files);

    std::set<std::string> included_;
    std::map<std::string, double> words_;  // that a file amounts to, by path
    double distinct_ = 0;                  // words that stand in the files
    int depth_ = 0;                        // of the file that is being counted
    bool is_counted_ = false;
};

}  // namespace sunfleck::engine
