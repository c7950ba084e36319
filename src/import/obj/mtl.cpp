// Statements of MTL, one a line.
#include "import/obj/mtl.h"

#include "core/file_content.h"
#include "core/printable.h"
#include "core/small_letters.h"
#include "core/text_cursor.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sunfleck::engine {
namespace {

using std::string_view_literals::operator""sv;

constexpr std::array kColourWords = {"ka"sv, "kd"sv, "ks"sv, "ke"sv, "tf"sv};
constexpr std::array kNumberWords = {"ns"sv,        "ni"sv,    "d"sv,     "tr"sv, "illum"sv,
                                     "sharpness"sv, "pr"sv,    "pm"sv,    "ps"sv, "pc"sv,
                                     "pcr"sv,       "aniso"sv, "anisor"sv};
constexpr std::array kMapWords = {"bump"sv, "norm"sv, "disp"sv, "decal"sv, "refl"sv};

template <std::size_t N>
bool is_among(const std::array<std::string_view, N>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

class MtlReader {
public:
    MtlReader(std::string_view text, const std::string& name) : cursor_(text, name) {}

    MtlLibrary read() {
        for (; !cursor_.at_end(); cursor_.next_line()) {
            const std::string_view written = cursor_.word();
            begin_ = cursor_.offset() - written.size();
            if (!written.empty()) read_statement(small_letters(std::string(written)));
        }
        return std::move(library_);
    }

private:
    void read_statement(const std::string& word) {
        if (word == "newmtl") {
            MtlMaterial material;
            material.where = place();
            material.name = cursor_.rest_of_line();
            library_.materials.push_back(std::move(material));
        } else if (library_.materials.empty()) {
            remark("stands before any newmtl, and is left out", word);
        } else if (is_among(kColourWords, word)) {
            read_colour(word);
        } else if (is_among(kNumberWords, word)) {
            read_number(word);
        } else if (word.starts_with("map_") || is_among(kMapWords, word)) {
            read_map(word);
        } else {
            remark("is no statement of MTL, and is left out", word);
        }
    }

    SourceLocation place() const { return cursor_.location(begin_); }
    MtlMaterial& material() { return library_.materials.back(); }
    void remark(const std::string& what, const std::string& word) {
        library_.remarks.push_back({place(), in_quotes(word, 40) + " " + what});
    }

    double finite() {
        const double value = cursor_.number("a number");
        if (!std::isfinite(value))
            cursor_.fail(begin_, "a number that is not finite", "give a finite one");
        return value;
    }

    /// One number is a grey.
    void read_colour(const std::string& word) {
        const std::size_t before = cursor_.offset();
        if (!cursor_.find_number()) {
            const std::string_view form = cursor_.word();
            if (form == "spectral" || form == "xyz")
                return remark("by spectral or xyz is left out", word);
            cursor_.fail(begin_, in_quotes(word) + " without a colour", "give red, green and blue");
        }
        cursor_.move_to(before);
        Vec3d colour(std::max(finite(), 0.0));
        if (!cursor_.at_line_end())
            for (int c = 1; c < 3; ++c) colour[c] = std::max(finite(), 0.0);
        material().colours[word] = colour;
    }

    void read_number(const std::string& word) {
        const std::size_t before = cursor_.offset();
        if (cursor_.word() != "-halo") cursor_.move_to(before);
        material().numbers[word] = finite();
    }

    /// Reads up to three numbers of an option; the third is left out, those not given stay.
    void read_pair(Vec2d& pair) {
        for (int c = 0; c < 3; ++c) {
            const auto value = cursor_.find_number();
            if (!value) return;
            if (c < 2 && std::isfinite(*value)) pair[c] = *value;
        }
    }

    /// Reads an option if the next word is one. @return whether it was.
    bool read_option(MtlMap& map, const std::string& word) {
        const std::size_t before = cursor_.offset();
        const std::string option = small_letters(std::string(cursor_.word()));
        if (option == "-o") {
            read_pair(map.offset);
        } else if (option == "-s") {
            read_pair(map.scale);
        } else if (option == "-t") {
            Vec2d turbulence(0);
            read_pair(turbulence);
            if (turbulence != Vec2d(0)) remark("has turbulence (-t), which is left out", word);
        } else if (option == "-mm") {
            const double base = finite();
            const double gain = finite();
            if (base != 0 || gain != 1) remark("has base and gain (-mm), which are left out", word);
        } else if (option == "-bm") {
            map.bump = finite();
        } else if (option == "-clamp") {
            map.clamps = cursor_.word() == "on";
        } else if (option == "-imfchan") {
            const std::string_view channel = cursor_.word();
            map.channel = channel.empty() ? '\0' : channel[0];
        } else if (option == "-boost" || option == "-texres") {
            finite();
        } else if (option == "-blendu" || option == "-blendv" || option == "-cc" ||
                   option == "-type") {
            cursor_.word();
        } else {
            cursor_.move_to(before);
            return false;
        }
        return true;
    }

    /// Takes what is left of the line but options at its end, where some writers have them.
    std::string name_of_map(MtlMap& map, const std::string& word) {
        cursor_.at_line_end();  // skips blanks
        const std::size_t begin = cursor_.offset();
        const std::string_view rest = cursor_.rest_of_line();

        static constexpr std::array kTrailing = {" -bm "sv, " -clamp "sv, " -o "sv, " -s "sv,
                                                 " -imfchan "sv};
        std::size_t end = rest.size();
        for (const std::string_view option : kTrailing) end = std::min(end, rest.find(option));
        if (end < rest.size()) {
            cursor_.move_to(begin + end);
            while (read_option(map, word)) {
            }
        }
        return std::string(rest.substr(0, end));
    }

    void read_map(const std::string& word) {
        MtlMap map;
        map.where = place();
        while (read_option(map, word)) {
        }
        map.file = name_of_map(map, word);
        if (map.file.empty()) return remark("names no picture, and is left out", word);
        material().maps[word] = std::move(map);
    }

    TextCursor cursor_;
    MtlLibrary library_;
    std::size_t begin_ = 0;  // of the statement
};

template <class Map>
const typename Map::mapped_type* found_in(const Map& map, std::string_view word) {
    const auto found = map.find(word);
    return found == map.end() ? nullptr : &found->second;
}

}  // namespace

std::optional<double> MtlMaterial::number(std::string_view word) const {
    const double* const found = found_in(numbers, word);
    return found == nullptr ? std::nullopt : std::optional(*found);
}

std::optional<Vec3d> MtlMaterial::colour(std::string_view word) const {
    const Vec3d* const found = found_in(colours, word);
    return found == nullptr ? std::nullopt : std::optional(*found);
}

const MtlMap* MtlMaterial::map(std::string_view word) const {
    return found_in(maps, word);
}

MtlLibrary parse_mtl(std::string_view bytes, const std::string& name) {
    const std::string_view text = without_mark(bytes);
    const auto content = content_of(text);
    if (content && !text.empty() && content->what.find("MTL") == std::string_view::npos)
        refuse_other_content(bytes, name, "a library of materials (MTL)");
    MtlLibrary library = MtlReader(text, name).read();
    library.is_of_blender = text.starts_with("# Blender");
    return library;
}

}  // namespace sunfleck::engine
