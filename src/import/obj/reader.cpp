// Statements of OBJ, in one pass.
#include "import/obj/reader.h"

#include "core/file_content.h"
#include "core/float_range.h"
#include "core/printable.h"
#include "core/text_cursor.h"
#include "import/obj/faces.h"
#include "import/obj/smoothing.h"
#include "import/obj/statements.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

namespace sunfleck::engine {
namespace {

/// An element whose numbers are not finite, and its place in the text.
struct Broken {
    std::uint32_t index = 0;
    std::size_t offset = 0;
};

class ObjReader {
public:
    ObjReader(std::string_view text, const std::string& name) : cursor_(text, name), name_(name) {}

    ObjMesh read() {
        for (; !cursor_.at_end(); cursor_.next_line()) {
            const std::string_view word = cursor_.word();
            if (!word.empty()) read_statement(word);
        }
        corners_.check(cursor_, counts());
        if (faces_.triangles() == 0) refuse_without_faces();
        const ObjFaceCounts counted = faces_.finish(mesh_);
        if (mesh_.triangles.empty()) refuse_without_faces();
        check_positions();
        finish_colours();
        broken_normals_ = drop_broken_normals(mesh_);
        smooth(mesh_);
        add_remarks(counted);
        return std::move(mesh_);
    }

private:
    void read_statement(std::string_view word) {
        switch (statement_of(word)) {
            case ObjStatement::vertex:
                return read_vertex();
            case ObjStatement::uv:
                return read_uv();
            case ObjStatement::normal:
                return read_normal();
            case ObjStatement::face:
                return read_face();
            case ObjStatement::material:
                return read_material();
            case ObjStatement::library:
                return read_library();
            case ObjStatement::smoothing:
                return read_smoothing();
            case ObjStatement::object:
                return read_object();
            case ObjStatement::group:
                if (!has_objects_) read_name();
                return;
            case ObjStatement::points:
                ++points_;
                return;
            case ObjStatement::lines:
                ++lines_;
                return;
            case ObjStatement::surfaces:
                ++surfaces_;
                return;
            case ObjStatement::ignored:
                return;
            case ObjStatement::unknown:
                if (unknown_++ == 0) first_unknown_ = in_quotes(word, 40);
        }
    }

    void read_library() {
        const SourceLocation where = cursor_.location();
        mesh_.libraries.push_back({std::string(cursor_.rest_of_line()), where});
    }

    ObjCorner counts() const {
        return {static_cast<std::uint32_t>(mesh_.positions.size()),
                static_cast<std::uint32_t>(mesh_.uvs.size()),
                static_cast<std::uint32_t>(mesh_.normals.size())};
    }

    /// @throws Error  if one more element could not be named by an index.
    template <class List>
    std::uint32_t next_index(const List& list) const {
        if (list.size() >= kNoIndex - 1)
            cursor_.fail(cursor_.offset(), "has more than four billion vertices",
                         "divide the part");
        return static_cast<std::uint32_t>(list.size());
    }

    void read_vertex() {
        const std::uint32_t index = next_index(mesh_.positions);
        const std::size_t offset = cursor_.offset();
        Vec3d p;
        for (int c = 0; c < 3; ++c) p[c] = cursor_.number("three coordinates");
        if (!(is_finite_float(p.x) && is_finite_float(p.y) && is_finite_float(p.z)))
            broken_.push_back({index, offset});
        mesh_.positions.push_back(p);
        if (cursor_.at_line_end()) return;
        const double fourth = cursor_.number("a weight or a colour");
        if (cursor_.at_line_end())
            weighted_ += fourth != 1 ? 1 : 0;
        else
            read_colour(fourth);
    }

    /// Vertices before the first with a colour are white, as those are that have none.
    void read_colour(double red) {
        const double green = cursor_.number("a colour");
        const double blue = cursor_.number("a colour");
        mesh_.colours.resize(mesh_.positions.size(), Vec3(1));
        const Vec3d colour(red, green, blue);
        for (int c = 0; c < 3; ++c)
            mesh_.colours.back()[c] =
                colour[c] > 0 ? static_cast<float>(std::min(colour[c], 255.0)) : 0;
    }

    /// Some writers have bytes.
    void finish_colours() {
        if (mesh_.colours.empty()) return;
        mesh_.colours.resize(mesh_.positions.size(), Vec3(1));
        const bool are_bytes =
            std::any_of(mesh_.colours.begin(), mesh_.colours.end(),
                        [](const Vec3& c) { return c.x > 1 || c.y > 1 || c.z > 1; });
        if (are_bytes)
            for (Vec3& colour : mesh_.colours) colour /= 255;
    }

    void read_uv() {
        next_index(mesh_.uvs);
        const double u = cursor_.number("texture coordinates");
        const double v = cursor_.find_number().value_or(0);
        const bool is_good = is_finite_float(u) && is_finite_float(v);
        broken_uvs_ += is_good ? 0 : 1;
        mesh_.uvs.push_back(is_good ? Vec2(Vec2d(u, v)) : Vec2(0));
    }

    void read_normal() {
        next_index(mesh_.normals);
        Vec3d n;
        for (int c = 0; c < 3; ++c) n[c] = cursor_.number("three coordinates");
        const bool is_good = is_finite_float(n.x) && is_finite_float(n.y) && is_finite_float(n.z);
        mesh_.normals.push_back(is_good ? Vec3(n) : Vec3(0));
    }

    void read_face() {
        const ObjCorner counted = counts();
        face_.clear();
        while (const auto corner = corners_.next(cursor_, counted)) face_.push_back(*corner);
        faces_.add(face_, cursor_);
    }

    void read_material() {
        const std::size_t offset = cursor_.offset();
        const std::string name(cursor_.rest_of_line());
        std::uint32_t material = kNoIndex;
        if (!name.empty()) {
            const auto [found, is_new] =
                numbers_.try_emplace(name, static_cast<std::uint32_t>(mesh_.materials.size()));
            if (is_new) mesh_.materials.push_back({name, cursor_.location(offset)});
            material = found->second;
        }
        faces_.set_material(material);
    }

    /// Groups count as objects until the file names an object.
    void read_object() {
        has_objects_ = true;
        read_name();
    }

    void read_name() {
        const std::string name(cursor_.rest_of_line());
        std::uint32_t object = kNoIndex;
        if (!name.empty()) {
            const auto [found, is_new] = numbers_of_objects_.try_emplace(
                name, static_cast<std::uint32_t>(mesh_.objects.size()));
            if (is_new) mesh_.objects.push_back(name);
            object = found->second;
        }
        faces_.set_object(object);
    }

    /// "off" and 0 end smoothing.
    void read_smoothing() {
        const std::string_view word = cursor_.word();
        std::uint32_t group = 0;
        const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), group);
        const bool is_number = fault == std::errc() && end == word.data() + word.size();
        if (!is_number && word == "on") group = 1;
        if (!is_number && word != "on" && word != "off" && word != "null" && !word.empty())
            cursor_.fail(cursor_.offset() - word.size(),
                         in_quotes(word, 40) + " is no smoothing group",
                         "write its number, or off");
        faces_.set_smoothing(group);
    }

    [[noreturn]] void refuse_without_faces() {
        std::string has = "has no face with three corners";
        if (surfaces_ > 0) has = "has curves and surfaces, but no polygons";
        if (points_ + lines_ > 0 && surfaces_ == 0) has = "has points and lines alone, no polygons";
        throw Error({name_}, has, "export the part as polygons");
    }

    /// A vertex that is not finite may stand in the file, but not in a face.
    void check_positions() const {
        if (broken_.empty()) return;
        std::vector<bool> is_used(mesh_.positions.size());
        for (const ObjTriangle& t : mesh_.triangles)
            for (const std::uint32_t corner : t) is_used[corner] = true;
        for (const Broken& vertex : broken_)
            if (is_used[vertex.index])
                cursor_.fail(vertex.offset, "a vertex of a face is not finite, or too far away",
                             "export the part again without it");
    }

    void add_remarks(const ObjFaceCounts& faces) {
        const auto remark = [&](std::size_t count, const std::string& what) {
            if (count > 0) mesh_.remarks.push_back(what + " (" + std::to_string(count) + ")");
        };
        remark(faces.crossing,
               "faces that cross themselves, or are concave with more than 5000 corners, may be "
               "filled wrongly");
        remark(faces.small, "faces of fewer than three corners are left out");
        remark(faces.flat, "triangles with two corners at one vertex are left out");
        remark(points_, "points are left out");
        remark(lines_, "lines are left out");
        remark(surfaces_, "statements of curves and surfaces are left out");
        remark(weighted_, "weights of vertices other than 1 are left out");
        remark(broken_normals_, "triangles whose normals are zero or not finite are flat");
        remark(broken_uvs_, "texture coordinates that are not finite became (0, 0)");
        remark(unknown_, "statements that are no OBJ are left out, first " + first_unknown_);
    }

    TextCursor cursor_;
    const std::string& name_;
    ObjMesh mesh_;
    ObjCorners corners_;
    ObjFaces faces_;
    std::vector<ObjCorner> face_;
    std::map<std::string, std::uint32_t, std::less<>> numbers_;  // of materials
    std::map<std::string, std::uint32_t, std::less<>> numbers_of_objects_;
    bool has_objects_ = false;
    std::vector<Broken> broken_;  // vertices
    std::size_t points_ = 0;
    std::size_t lines_ = 0;
    std::size_t surfaces_ = 0;
    std::size_t weighted_ = 0;
    std::size_t broken_uvs_ = 0;
    std::size_t broken_normals_ = 0;
    std::size_t unknown_ = 0;
    std::string first_unknown_;
};

}  // namespace

ObjMesh parse_obj(std::string_view bytes, const std::string& name) {
    const auto content = content_of(bytes);
    if (content && content->what.find("OBJ") == std::string_view::npos)
        refuse_other_content(bytes, name, "an OBJ mesh");
    return ObjReader(without_mark(bytes), name).read();
}

}  // namespace sunfleck::engine
