// Header of a PLY file, line by line, each fault with its line and column.
#include "import/ply/header.h"

#include "sunfleck/error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace sunfleck::engine {
namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> kPlyTypes = {{
    {"char", PlyType::int8},
    {"uchar", PlyType::uint8},
    {"short", PlyType::int16},
    {"ushort", PlyType::uint16},
    {"int", PlyType::int32},
    {"uint", PlyType::uint32},
    {"float", PlyType::float32},
    {"double", PlyType::float64},
    {"int8", PlyType::int8},
    {"uint8", PlyType::uint8},
    {"int16", PlyType::int16},
    {"uint16", PlyType::uint16},
    {"int32", PlyType::int32},
    {"uint32", PlyType::uint32},
    {"float32", PlyType::float32},
    {"float64", PlyType::float64},
}};

bool is_integer(PlyType type) {
    return type != PlyType::float32 && type != PlyType::float64;
}

struct Word {
    std::string_view text;
    int column = 1;
};

class HeaderParser {
public:
    HeaderParser(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {
        const std::size_t end = std::min(bytes.find_first_of("\n\r"), bytes.size());
        if (end + 1 < bytes.size() && bytes[end] == '\r' && bytes[end + 1] != '\n')
            line_end_ = '\r';
    }

    PlyHeader parse() {
        if (!next_line() || words_.size() != 1 || words_[0].text != "ply")
            fail(0, "this is no PLY file", "begin it with a line \"ply\"");
        for (bool in_header = true; in_header;) {
            if (!next_line())
                fail(0, "the file ends inside its header", "write the file again, it is cut");
            if (!words_.empty()) in_header = read_statement();
        }
        if (!has_format_) fail(0, "the header names no format", "add \"format ascii 1.0\"");
        check_vertex();
        check_face();
        header_.size = at_;
        return std::move(header_);
    }

private:
    /// @return whether more of the header follows.
    bool read_statement() {
        const std::string_view keyword = words_[0].text;
        if (keyword == "end_header") return false;
        if (keyword == "format") {
            read_format();
        } else if (keyword == "element") {
            read_element();
        } else if (keyword == "property") {
            read_property();
        } else if (keyword != "comment" && keyword != "obj_info") {
            fail(0, "unknown statement " + quoted(0),
                 "use format, comment, element, property or end_header");
        }
        return true;
    }

    void read_format() {
        need_words(3, "format ascii 1.0");
        constexpr std::array<std::string_view, 3> kFormats = {"ascii", "binary_little_endian",
                                                              "binary_big_endian"};
        const auto* found = std::find(kFormats.begin(), kFormats.end(), words_[1].text);
        if (found == kFormats.end())
            fail(1, "unknown format " + quoted(1),
                 "use ascii, binary_little_endian or binary_big_endian");
        if (words_[2].text != "1.0") fail(2, "unknown version " + quoted(2), "use 1.0");
        if (has_format_) fail(0, "the format is given twice", "delete one");
        header_.format = static_cast<PlyFormat>(found - kFormats.begin());
        has_format_ = true;
    }

    void read_element() {
        need_words(3, "element vertex 8");
        PlyElement element{std::string(words_[1].text), 0, {}};
        const std::string_view count = words_[2].text;
        const auto result =
            std::from_chars(count.data(), count.data() + count.size(), element.count);
        if (result.ec != std::errc() || result.ptr != count.data() + count.size())
            fail(2, quoted(2) + " is no count", "write a whole number, zero or more");
        if (header_.find(element.name) != nullptr)
            fail(1, "element " + quoted(1) + " is declared twice", "delete one");
        header_.elements.push_back(std::move(element));
        element_lines_.push_back(line_);
    }

    void read_property() {
        if (header_.elements.empty())
            fail(0, "a property before any element", "declare an element first");
        const bool list = words_.size() > 1 && words_[1].text == "list";
        need_words(list ? 5 : 3,
                   list ? "property list uchar int vertex_indices" : "property float x");
        PlyProperty property;
        if (list) {
            property.count_type = type_of(2);
            if (!is_integer(*property.count_type))
                fail(2, "a list's length is of type " + quoted(2), "use an integer type");
        }
        const std::size_t last = list ? 4 : 2;
        property.type = type_of(last - 1);
        property.name = words_[last].text;
        auto& known = header_.elements.back().properties;
        if (std::any_of(known.begin(), known.end(),
                        [&](const PlyProperty& p) { return p.name == property.name; }))
            fail(last, "property " + quoted(last) + " is declared twice", "delete one");
        if (header_.elements.back().name == "face" && is_vertex_list(property) &&
            (!list || !is_integer(property.type)))
            fail(last, quoted(last) + " is no list of integers",
                 "use \"property list uchar int vertex_indices\"");
        if (list && header_.elements.back().name == "vertex" && property.name.size() == 1 &&
            property.name[0] >= 'x' && property.name[0] <= 'z')
            fail(last, quoted(last) + " is a list", "use \"property float " + property.name + "\"");
        known.push_back(std::move(property));
    }

    PlyType type_of(std::size_t word) {
        const auto* found = std::find_if(kPlyTypes.begin(), kPlyTypes.end(), [&](const auto& row) {
            return row.first == words_[word].text;
        });
        if (found == kPlyTypes.end())
            fail(word, "unknown type " + quoted(word),
                 "use char, uchar, short, ushort, int, uint, float or double");
        return found->second;
    }

    void check_vertex() {
        const PlyElement& vertex = needed_element("vertex");
        for (const std::string_view name : {"x", "y", "z"})
            if (std::none_of(vertex.properties.begin(), vertex.properties.end(),
                             [&](const PlyProperty& p) { return p.name == name; }))
                fail_at_element(vertex, "vertices have no property \"" + std::string(name) + "\"",
                                "give them x, y and z");
    }

    void check_face() {
        const PlyElement& face = needed_element("face");
        const auto lists =
            std::count_if(face.properties.begin(), face.properties.end(), is_vertex_list);
        if (lists != 1)
            fail_at_element(face,
                            lists == 0 ? "faces have no list \"vertex_indices\""
                                       : "faces have two lists of vertices",
                            "give them one list \"vertex_indices\"");
    }

    const PlyElement& needed_element(const std::string& name) {
        const PlyElement* element = header_.find(name);
        if (const PlyElement* strips = header_.find("tristrips"); strips && name == "face")
            fail_at_element(*strips, "its faces are strips of triangles, which are not read",
                            "export single triangles");
        if (element == nullptr)
            fail(0, "the file has no element \"" + name + "\"", "export a triangle mesh");
        if (element->count == 0)
            fail_at_element(*element, "the file has no " + name, "export a triangle mesh");
        return *element;
    }

    /// Accepts the next line apart. @return false at the end of the bytes.
    bool next_line() {
        words_.clear();
        ++line_;
        const std::size_t end = bytes_.find(line_end_, at_);
        if (end == std::string_view::npos) return false;
        const std::string_view text = bytes_.substr(at_, end - at_);
        at_ = end + 1;
        constexpr std::string_view kBlank = " \t\r\n";
        for (std::size_t i = text.find_first_not_of(kBlank); i != std::string_view::npos;) {
            const std::size_t stop = std::min(text.find_first_of(kBlank, i), text.size());
            words_.push_back({text.substr(i, stop - i), static_cast<int>(i) + 1});
            i = text.find_first_not_of(kBlank, stop);
        }
        return true;
    }

    void need_words(std::size_t count, const std::string& example) {
        if (words_.size() == count) return;
        const std::string what = words_.size() < count ? "is cut short" : "has too many words";
        fail(0, quoted(0) + " " + what, "write it as in \"" + example + "\"");
    }

    /// A word as it stands in the file; long ones are cut, bytes that do not print become '?'.
    std::string quoted(std::size_t word) const {
        std::string text(words_[word].text.substr(0, 40));
        for (char& c : text)
            if (c < 32 || c > 126) c = '?';
        return '"' + text + '"';
    }

    [[noreturn]] void fail(std::size_t word, const std::string& what, const std::string& mend) {
        throw Error({name_, line_, word < words_.size() ? words_[word].column : 1}, what, mend);
    }

    [[noreturn]] void fail_at_element(const PlyElement& element, const std::string& what,
                                      const std::string& mend) {
        const auto i = static_cast<std::size_t>(&element - header_.elements.data());
        throw Error({name_, element_lines_[i], 1}, what, mend);
    }

    std::string_view bytes_;
    const std::string& name_;
    char line_end_ = '\n';  // of all lines, as of the first: LF, or CR alone
    std::size_t at_ = 0;
    int line_ = 0;
    std::vector<Word> words_;
    bool has_format_ = false;
    PlyHeader header_;
    std::vector<int> element_lines_;
};

}  // namespace

const PlyElement* PlyHeader::find(std::string_view name) const {
    const auto found = std::find_if(elements.begin(), elements.end(),
                                    [&](const PlyElement& e) { return e.name == name; });
    return found == elements.end() ? nullptr : &*found;
}

PlyHeader parse_ply_header(std::string_view bytes, const std::string& name) {
    return HeaderParser(bytes, name).parse();
}

}  // namespace sunfleck::engine
