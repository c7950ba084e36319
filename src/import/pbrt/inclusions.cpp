// The count of words, file by file, each file once.
#include "import/pbrt/inclusions.h"

namespace sunfleck::engine {
namespace {

/// Words in whose time a file is opened.
constexpr double kWordsPerOpening = 50;
constexpr double kMostRepeated = 1e9;
constexpr int kDeepest = 100;  // as deep as files are read

}  // namespace

void Inclusions::add(const std::string& path, const SourceLocation& from, const Lexer& root,
                     const Files& files) {
    if (included_.insert(path).second || is_counted_) return;
    is_counted_ = true;
    const double all = words_of(root.file(), root.text(), files);
    if (all - distinct_ > kMostRepeated)
        throw Error(from,
                    "files that include each other make more than 1000 million words out of "
                    "this scene",
                    "include them less often, or use ObjectInstance");
}

double Inclusions::words_of(const std::string& path, const std::string& text, const Files& files) {
    const auto [known, is_new] = words_.try_emplace(path, 0);
    if (!is_new || depth_ > kDeepest) return known->second;  // zero for files in a circle
    ++depth_;
    double own = 0;
    double all = 0;
    try {
        Lexer lexer(text, path);
        bool includes = false;
        for (auto token = lexer.next(); token; token = lexer.next()) {
            ++own;
            if (includes && token->kind == TokenKind::string) {
                const NamedFile next = files(unescaped(*token), token->where());
                all += kWordsPerOpening + words_of(next.path, next.bytes, files);
            }
            includes = token->kind == TokenKind::word &&
                       (token->text == "Include" || token->text == "Import");
        }
    } catch (const Error&) {  // it is told when the file is read as far as there
    }
    --depth_;
    distinct_ += own;
    return known->second = all + own;
}

}  // namespace sunfleck::engine
