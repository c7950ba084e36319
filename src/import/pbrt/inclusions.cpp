// Counts words file by file, each file once.
#include "import/pbrt/inclusions.h"

namespace sunfleck::engine {
namespace {

/// Cost of opening a file, in words.
constexpr double kWordsPerOpening = 50;
constexpr double kMostRepeated = 1e9;
constexpr int kDeepest = 100;  // limit of nesting when files are read

}  // namespace

void Inclusions::add(const std::string& path, const SourceLocation& from, const Lexer& root,
                     const Files& files) {
    if (included_.insert(path).second || is_counted_) return;
    is_counted_ = true;
    const double all = words_of(root.file(), root.text(), files);
    if (all - distinct_ > kMostRepeated)
        throw Error(from,
                    "included files expand to more than 1000 million words"
                    "this scene",
                    "include them less often, or use ObjectInstance");
}

double Inclusions::words_of(const std::string& path, const std::string& text, const Files& files) {
    const auto [known, is_new] = words_.try_emplace(path, 0);
    if (!is_new || depth_ > kDeepest) return known->second;  // zero for files in a cycle
    ++depth_;
    double own = 0;
    double all = 0;
    try {
        Lexer lexer(text, path);
        bool includes = false;
        for (auto token = lexer.next(); token; token = lexer.next()) {
            ++own;
            if (includes && token->kind == TokenKind::string) all += words_included(*token, files);
            includes = token->kind == TokenKind::word &&
                       (token->text == "Include" || token->text == "Import");
        }
    } catch (const Error&) {  // reported when reading reaches the file
    }
    --depth_;
    distinct_ += own;
    return known->second = all + own;
}

double Inclusions::words_included(const Token& name, const Files& files) {
    const NamedFile file = files(unescaped(name), name.where());
    return kWordsPerOpening + words_of(file.path, file.bytes, files);
}

}  // namespace sunfleck::engine
