// Curves: their basis, degree, widths and normals.
#include "import/pbrt/curve_shape.h"

#include "import/pbrt/meshes.h"
#include "import/pbrt/reading.h"
#include "import/pbrt/words.h"

#include <algorithm>

namespace sunfleck::engine {
namespace {

[[noreturn]] void fail(const Statement& statement, std::string_view name, const std::string& fault,
                       const std::string& mend) {
    const Parameter* found = statement.find(name);
    throw Error(found ? found->where : statement.where, "curve: " + fault, mend);
}

template <std::size_t N>
std::size_t one_of(const Statement& statement, std::string_view name,
                   const std::array<std::string_view, N>& words) {
    const std::string word = statement.text(name).value_or(std::string(words[0]));
    const auto found = std::find(words.begin(), words.end(), word);
    if (found == words.end())
        fail(statement, name, "unknown " + std::string(name) + " " + in_quotes(word),
             use_one_of(words, word));
    return static_cast<std::size_t>(found - words.begin());
}

/// The Bezier form of one segment of a uniform B-spline.
Bezier from_bspline(const Vec3d* p, int degree) {
    if (degree == 2) {
        const Vec3d first = (p[0] + p[1]) * 0.5;
        const Vec3d last = (p[1] + p[2]) * 0.5;
        return {first, (first + p[1] * 2) / 3, (p[1] * 2 + last) / 3, last};
    }
    return {(p[0] + p[1] * 4 + p[2]) / 6, (p[1] * 2 + p[2]) / 3, (p[1] + p[2] * 2) / 3,
            (p[1] + p[2] * 4 + p[3]) / 6};
}

Bezier from_bezier(const Vec3d* p, int degree) {
    if (degree == 2) return {p[0], (p[0] + p[1] * 2) / 3, (p[1] * 2 + p[2]) / 3, p[2]};
    return {p[0], p[1], p[2], p[3]};
}

/// @param points  of the statement.
std::vector<Bezier> segments_of(const Statement& statement, const std::vector<Vec3d>& points) {
    static constexpr std::array<std::string_view, 2> kBases = {"bezier", "bspline"};
    const bool bspline = one_of(statement, "basis", kBases) == 1;
    const int degree = statement.integer("degree").value_or(3);
    if (degree != 2 && degree != 3)
        fail(statement, "degree", "degree " + std::to_string(degree), "use 2 or 3");
    const auto step = static_cast<std::size_t>(bspline ? 1 : degree);
    const auto needed = static_cast<std::size_t>(degree) + 1;
    if (points.size() < needed || (points.size() - needed) % step != 0)
        fail(statement, "P",
             std::to_string(points.size()) + " control points make no whole segments of degree " +
                 std::to_string(degree),
             bspline ? "give " + std::to_string(needed) + " or more"
                     : "give one more than a multiple of the degree");
    std::vector<Bezier> result;
    for (std::size_t i = 0; i + needed <= points.size(); i += step)
        result.push_back(bspline ? from_bspline(&points[i], degree)
                                 : from_bezier(&points[i], degree));
    return result;
}

/// Makes points relative to an origin near them. Hair is many short curves that are joined into one
/// shape where they have the same origin: that of the curve before is kept while it serves.
void move_near_origin(std::vector<Vec3d>& points, Vec3d& origin) {
    constexpr double kServes = 0x1p14;  // radii: floats then err by 2^-10 of a radius
    Bounds box;
    for (const Vec3d& p : points) box.extend(p);
    const Middle middle = middle_of({box});
    if (middle.radius > 0 && !((middle.center - origin).length() < kServes * middle.radius))
        origin = origin_near(middle);
    for (Vec3d& p : points) p -= origin;
}

/// One at each end of each segment, of ribbons; none otherwise.
std::vector<Vec3> normals_of(const Statement& statement, bool ribbon, std::size_t segments,
                             Reading& reading) {
    const Parameter* given = statement.find("N", ParameterType::normal);
    if (!ribbon) {
        if (given)
            reading.log.warn(given->where, "normals of a curve that is no ribbon are ignored");
        return {};
    }
    std::vector<Vec3> normals = float_triples(given);
    if (normals.size() != segments + 1)
        fail(statement, "N",
             std::to_string(normals.size()) + " normals for a ribbon of " +
                 std::to_string(segments) + " segments",
             "give one more than there are segments");
    for (const Vec3& n : normals)
        if (!(n.length2() > 0)) fail(statement, "N", "a normal without length", "use 0 0 1, say");
    return normals;
}

}  // namespace

LocalShape curve(const Statement& statement, Reading& reading) {
    static constexpr std::array<std::string_view, 3> kTypes = {"flat", "cylinder", "ribbon"};
    static constexpr std::array<CurveKind, 3> kKinds = {CurveKind::flat, CurveKind::cylinder,
                                                        CurveKind::ribbon};
    Curves result;
    result.kind = kKinds.at(one_of(statement, "type", kTypes));
    std::vector<Vec3d> points = triples(statement.find("P", ParameterType::point3));
    move_near_origin(points, reading.curve_origin);
    const std::vector<Bezier> segments = segments_of(statement, points);
    const double width = statement.real("width", 1);
    const double start = statement.real("width0", width);
    const double end = statement.real("width1", width);
    if (start < 0 || end < 0)
        fail(statement, start < 0 ? "width0" : "width1", "a negative width", "use 0 or more");
    const std::vector<Vec3> normals =
        normals_of(statement, result.kind == CurveKind::ribbon, segments.size(), reading);
    const auto width_at = [&](std::size_t i) {
        const double along = double(i) / double(segments.size());
        return static_cast<float>(start * (1 - along) + end * along);
    };
    for (std::size_t i = 0; i < segments.size(); ++i) {
        CurveSegment& segment = result.segments.emplace_back();
        std::transform(segments[i].begin(), segments[i].end(), segment.points.begin(),
                       [](const Vec3d& p) { return Vec3(p); });
        segment.width = {width_at(i), width_at(i + 1)};
        if (!normals.empty()) segment.normal = {normals[i], normals[i + 1]};
    }
    statement.ignore({"splitdepth"});
    return {std::move(result), reading.curve_origin};
}

}  // namespace sunfleck::engine
