// The statements of OBJ.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace sunfleck::engine {

/// Statements of OBJ, by what is done with them.
enum class ObjStatement {
    vertex,
    uv,
    normal,
    face,
    material,
    library,
    smoothing,
    object,
    group,
    points,
    lines,
    surfaces,
    ignored,  // changes no picture
    unknown
};

struct ObjStatementRow {
    std::string_view word;
    ObjStatement statement;
};

inline constexpr auto kObjStatements = std::to_array<ObjStatementRow>({
    {"v", ObjStatement::vertex},          {"vt", ObjStatement::uv},
    {"vn", ObjStatement::normal},         {"f", ObjStatement::face},
    {"fo", ObjStatement::face},           {"usemtl", ObjStatement::material},
    {"mtllib", ObjStatement::library},    {"s", ObjStatement::smoothing},
    {"p", ObjStatement::points},          {"l", ObjStatement::lines},
    {"vp", ObjStatement::surfaces},       {"cstype", ObjStatement::surfaces},
    {"deg", ObjStatement::surfaces},      {"bmat", ObjStatement::surfaces},
    {"step", ObjStatement::surfaces},     {"curv", ObjStatement::surfaces},
    {"curv2", ObjStatement::surfaces},    {"surf", ObjStatement::surfaces},
    {"parm", ObjStatement::surfaces},     {"trim", ObjStatement::surfaces},
    {"hole", ObjStatement::surfaces},     {"scrv", ObjStatement::surfaces},
    {"sp", ObjStatement::surfaces},       {"end", ObjStatement::surfaces},
    {"con", ObjStatement::surfaces},      {"bzp", ObjStatement::surfaces},
    {"bsp", ObjStatement::surfaces},      {"cdc", ObjStatement::surfaces},
    {"cdp", ObjStatement::surfaces},      {"res", ObjStatement::surfaces},
    {"ctech", ObjStatement::surfaces},    {"stech", ObjStatement::surfaces},
    {"g", ObjStatement::group},           {"o", ObjStatement::object},
    {"mg", ObjStatement::ignored},        {"bevel", ObjStatement::ignored},
    {"c_interp", ObjStatement::ignored},  {"d_interp", ObjStatement::ignored},
    {"lod", ObjStatement::ignored},       {"shadow_obj", ObjStatement::ignored},
    {"trace_obj", ObjStatement::ignored}, {"maplib", ObjStatement::ignored},
    {"usemap", ObjStatement::ignored},
});

inline ObjStatement statement_of(std::string_view word) {
    const auto* const found =
        std::find_if(kObjStatements.begin(), kObjStatements.end(),
                     [&](const ObjStatementRow& row) { return row.word == word; });
    return found == kObjStatements.end() ? ObjStatement::unknown : found->statement;
}

}  // namespace sunfleck::engine
