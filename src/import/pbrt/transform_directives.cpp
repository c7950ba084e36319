// Directives that change the current matrix, or name and recall it.
#include "import/pbrt/directives.h"
#include "import/pbrt/reading.h"
#include "import/pbrt/transforms.h"
#include "import/pbrt/version3.h"
#include "import/pbrt/words.h"

namespace sunfleck::engine {
namespace {

[[noreturn]] void fail(const Token& keyword, const std::string& fault, const std::string& mend) {
    throw Error(keyword.where(), std::string(keyword.text) + ": " + fault, mend);
}

/// Puts `change` before the active matrices, or in their place.
void apply(Reading& reading, const Token& keyword, const Matrix& change, bool replace = false) {
    for (std::size_t i = 0; i < 2; ++i) {
        if (!reading.state.active[i]) continue;
        Matrix& matrix = reading.state.matrix[i];
        matrix = replace ? change : change * matrix;
        if (!is_usable(matrix))
            fail(keyword, "the matrix has no inverse", "scale by no zeros, and keep numbers sane");
    }
}

Vec3d vector(TokenStream& tokens, const Token& keyword) {
    const std::string what = "a number of " + std::string(keyword.text);
    const double x = tokens.require_number(what);
    const double y = tokens.require_number(what);
    const double z = tokens.require_number(what);
    return {x, y, z};
}

void identity(Reading& reading, TokenStream&, const Token& keyword) {
    apply(reading, keyword, Matrix(), true);
}

void translate(Reading& reading, TokenStream& tokens, const Token& keyword) {
    apply(reading, keyword, translation(vector(tokens, keyword)));
}

void scale(Reading& reading, TokenStream& tokens, const Token& keyword) {
    apply(reading, keyword, scaling(vector(tokens, keyword)));
}

void rotate(Reading& reading, TokenStream& tokens, const Token& keyword) {
    const double degrees = tokens.require_number("the angle of Rotate");
    const Vec3d axis = vector(tokens, keyword);
    if (!(axis.length2() > 0)) fail(keyword, "the axis has no length", "use 0 0 1, for example");
    apply(reading, keyword, rotation(degrees, axis));
}

void look(Reading& reading, TokenStream& tokens, const Token& keyword) {
    const Vec3d eye = vector(tokens, keyword);
    const Vec3d target = vector(tokens, keyword);
    const Vec3d up = vector(tokens, keyword);
    const auto matrix = look_at(eye, target, up);
    if (!matrix)
        fail(keyword, "eye, target and up make no frame",
             "the eye must not be the target, nor up point at it");
    apply(reading, keyword, *matrix);
}

/// Sixteen numbers column by column: for row vectors, row by row.
Matrix read_matrix(TokenStream& tokens, const Token& keyword) {
    const std::string word(keyword.text);
    const bool brackets = tokens.peek() && tokens.peek()->kind == TokenKind::open;
    if (brackets) tokens.next();
    Matrix m;
    for (auto& row : m.x)
        for (double& value : row) value = tokens.require_number("one of the 16 numbers of " + word);
    if (brackets && tokens.require("the ] of " + word).kind != TokenKind::close)
        fail(keyword, "more than 16 numbers", "close the list with ] after the 16th");
    const double w = m[3][3];
    if (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0 || !(w != 0))
        fail(keyword, "the matrix is not affine", "its 4th, 8th and 12th number must be 0");
    for (auto& row : m.x)
        for (double& value : row) value /= w;
    return m;
}

void transform(Reading& reading, TokenStream& tokens, const Token& keyword) {
    apply(reading, keyword, read_matrix(tokens, keyword), true);
}

void concat_transform(Reading& reading, TokenStream& tokens, const Token& keyword) {
    apply(reading, keyword, read_matrix(tokens, keyword));
}

void coordinate_system(Reading& reading, TokenStream& tokens, const Token&) {
    reading.coordinate_systems[tokens.require_string("a name")] = reading.state.matrix;
}

void coord_sys_transform(Reading& reading, TokenStream& tokens, const Token& keyword) {
    const std::string name = tokens.require_string("the name of a coordinate system");
    const auto found = reading.coordinate_systems.find(name);
    if (found != reading.coordinate_systems.end())
        reading.state.matrix = found->second;
    else
        reading.log.warn(keyword.where(), "there is no coordinate system " + in_quotes(name) +
                                              ": the matrix stays, as in pbrt-v4");
}

void active_transform(Reading& reading, TokenStream& tokens, const Token&) {
    const Token which = tokens.require("All, StartTime or EndTime");
    if (which.text == "All")
        reading.state.active = {true, true};
    else if (which.text == "StartTime")
        reading.state.active = {true, false};
    else if (which.text == "EndTime")
        reading.state.active = {false, true};
    else
        throw Error(which.where(), "ActiveTransform of " + in_quotes(which.text),
                    "use All, StartTime or EndTime");
}

void transform_times(Reading& reading, TokenStream& tokens, const Token& keyword) {
    if (tokens.peek() && tokens.peek()->kind == TokenKind::open)
        refuse_v3("TransformTimes with brackets", keyword.where());
    const double start = tokens.require_number("the first time of TransformTimes");
    const double end = tokens.require_number("the second time of TransformTimes");
    if (end < start) fail(keyword, "the end lies before the start", "swap them");
    reading.transform_times = {start, end};
}

void reverse_orientation(Reading& reading, TokenStream&, const Token&) {
    reading.state.reverse_orientation = !reading.state.reverse_orientation;
}

constexpr std::array<Directive, 12> kDirectives = {
    {{"Identity", Place::anywhere, identity},
     {"Translate", Place::anywhere, translate},
     {"Scale", Place::anywhere, scale},
     {"Rotate", Place::anywhere, rotate},
     {"LookAt", Place::anywhere, look},
     {"Transform", Place::anywhere, transform},
     {"ConcatTransform", Place::anywhere, concat_transform},
     {"CoordinateSystem", Place::anywhere, coordinate_system},
     {"CoordSysTransform", Place::anywhere, coord_sys_transform},
     {"ActiveTransform", Place::anywhere, active_transform},
     {"TransformTimes", Place::before_world, transform_times},
     {"ReverseOrientation", Place::anywhere, reverse_orientation}}};

}  // namespace

std::span<const Directive> transform_directives() {
    return kDirectives;
}

}  // namespace sunfleck::engine
