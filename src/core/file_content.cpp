// The table of first bytes, and texts that are told by more than these.
#include "core/file_content.h"

#include "core/small_letters.h"
#include "sunfleck/error.h"

#include <algorithm>
#include <array>

namespace sunfleck::engine {
namespace {

using std::string_view_literals::operator""sv;

constexpr auto kUnpack = "unpack it first"sv;
constexpr auto kUtf8 = "save it as UTF-8"sv;
constexpr auto kAgain = "get the file again"sv;

struct Mark {
    std::size_t at;
    std::string_view bytes;
    FileContent content;
};

constexpr auto kMarks = std::to_array<Mark>({
    {0,
     "version https://git-lfs.github.com/"sv,
     {"a pointer of Git LFS, not the file itself", "fetch the file: git lfs pull"}},
    {0,
     "version https://hawser.github.com/"sv,
     {"a pointer of Git LFS, not the file itself", "fetch the file: git lfs pull"}},
    {0, "outs:\n"sv, {"a pointer of DVC, not the file itself", "fetch the file: dvc pull"}},
    {0,
     "/annex/objects/"sv,
     {"a pointer of git-annex, not the file itself", "fetch the file: git annex get"}},

    {0, "\x1F\x8B"sv, {"compressed by gzip", kUnpack}},
    {0, "PK\x03\x04"sv, {"a ZIP archive", kUnpack}},
    {0, "PK\x05\x06"sv, {"an empty ZIP archive", kAgain}},
    {0,
     "\xFD"
     "7zXZ\0"sv,
     {"compressed by xz", kUnpack}},
    {0, "\x28\xB5\x2F\xFD"sv, {"compressed by zstd", kUnpack}},
    {4, "1AY&SY"sv, {"compressed by bzip2", kUnpack}},
    {0, "7z\xBC\xAF\x27\x1C"sv, {"a 7z archive", kUnpack}},
    {0, "Rar!\x1A\x07"sv, {"a RAR archive", kUnpack}},
    {0, "\x04\x22\x4D\x18"sv, {"compressed by lz4", kUnpack}},
    {0, "\x1F\x9D"sv, {"compressed by compress", kUnpack}},
    {257, "ustar"sv, {"a tar archive", kUnpack}},

    {0, "\0\0\xFE\xFF"sv, {"UTF-32 text", kUtf8}},
    {0, "\xFF\xFE\0\0"sv, {"UTF-32 text", kUtf8}},
    {0, "\xFF\xFE"sv, {"UTF-16 text", kUtf8}},
    {0, "\xFE\xFF"sv, {"UTF-16 text", kUtf8}},

    {0, "\x89PNG\r\n"sv, {"a PNG picture", ""}},
    {0, "\x89PNG"sv, {"a PNG picture whose line ends were changed on its way", kAgain}},
    {0, "\xFF\xD8\xFF"sv, {"a JPEG picture", ""}},
    {0, "\x76\x2F\x31\x01"sv, {"an OpenEXR picture", ""}},
    {0, "#?RADIANCE"sv, {"a Radiance HDR picture", ""}},
    {0, "#?RGBE"sv, {"a Radiance HDR picture", ""}},
    {0, "PF\n"sv, {"a PFM picture", ""}},
    {0, "Pf\n"sv, {"a PFM picture", ""}},
    {0, "II*\0"sv, {"a TIFF picture", ""}},
    {0, "MM\0*"sv, {"a TIFF picture", ""}},
    {0, "II+\0"sv, {"a TIFF picture", ""}},
    {0, "MM\0+"sv, {"a TIFF picture", ""}},
    {0, "GIF8"sv, {"a GIF picture", ""}},
    {6, "\0\0\0\0"sv, {"a BMP picture", ""}},  // behind "BM": content_of() looks for it
    {8, "WEBP"sv, {"a WebP picture", ""}},
    {0, "8BPS"sv, {"a Photoshop picture", ""}},
    {0, "DDS "sv, {"a DDS picture", ""}},
    {0, "\xABKTX "sv, {"a KTX picture", ""}},
    {0, "qoif"sv, {"a QOI picture", ""}},
    {0, "P6"sv, {"a PPM picture", ""}},
    {0, "P5"sv, {"a PGM picture", ""}},
    {0, "P3"sv, {"a PPM picture", ""}},
    {0, "P2"sv, {"a PGM picture", ""}},
    {0, "SDPX"sv, {"a DPX picture", ""}},
    {0, "XPDS"sv, {"a DPX picture", ""}},
    {4, "jP  \r\n"sv, {"a JPEG 2000 picture", ""}},
    {0, "\xFF\x4F\xFF\x51"sv, {"a JPEG 2000 picture", ""}},
    {4, "JXL \r\n"sv, {"a JPEG XL picture", ""}},
    {0, "\xFF\x0A"sv, {"a JPEG XL picture", ""}},
    {4, "ftypavif"sv, {"an AVIF picture", ""}},
    {4, "ftypavis"sv, {"an AVIF picture", ""}},
    {4, "ftyphei"sv, {"a HEIF picture", ""}},
    {4, "ftypmif1"sv, {"a HEIF picture", ""}},
    {4, "ftypmsf1"sv, {"a HEIF picture", ""}},
    {4, "ftyp"sv, {"a video", ""}},
    {0, "\0\0\1\0"sv, {"a Windows icon", ""}},

    {0, "ply\n"sv, {"a PLY mesh", ""}},
    {0, "ply\r"sv, {"a PLY mesh", ""}},
    {0, "mtllib "sv, {"a Wavefront OBJ mesh", ""}},
    {0, "newmtl "sv, {"a Wavefront MTL text", ""}},
    {0, "solid "sv, {"an STL mesh", ""}},
    {0, "OFF\n"sv, {"an OFF mesh", ""}},
    {0, "Kaydara FBX"sv, {"an FBX scene", ""}},
    {0, "BLENDER"sv, {"a Blender scene", ""}},
    {0, "glTF"sv, {"a glTF scene", ""}},
    {0, "#usda"sv, {"a USD scene", ""}},
    {0, "PXR-USDC"sv, {"a USD scene", ""}},
    {0, "Ogawa"sv, {"an Alembic scene", ""}},
    {0, " BDV"sv, {"an OpenVDB volume", ""}},
    {0, "NanoVDB"sv, {"a NanoVDB volume", ""}},
    {0, "tensor_file\0"sv, {"a file of measurements (.bsdf)", ""}},
    {0, "IESNA"sv, {"an IES light profile", ""}},
    {0, "sunfilm\n"sv, {"a film of Sunfleck", ""}},
    {0, "sunckpt\n"sv, {"a checkpoint of Sunfleck", ""}},
    {0,
     "\0\5\x16\7"sv,
     {"what macOS keeps beside a file (AppleDouble)", "give the file without ._ in its name"}},
    {0, "%PDF"sv, {"a PDF document", ""}},
    {0,
     "\x7F"
     "ELF"sv,
     {"a program", ""}},
});

/// What stands before these bytes, where they alone say too little.
bool begins_as_it_should(const Mark& mark, std::string_view bytes) {
    if (mark.bytes == "WEBP") return bytes.starts_with("RIFF");
    if (mark.bytes == "1AY&SY") return bytes.starts_with("BZh");
    if (mark.at == 6) return bytes.starts_with("BM");
    if (mark.bytes.size() == 2 && mark.bytes[0] == 'P')
        return bytes.size() > 2 && std::string_view(" \t\r\n").find(bytes[2]) != std::string::npos;
    return true;
}

/// ASCII as UTF-16 without its mark: every second byte is zero.
bool is_bare_utf16(std::string_view bytes) {
    constexpr std::size_t kLooked = 16;
    if (bytes.size() < kLooked) return false;
    for (const std::size_t zero : {std::size_t{0}, std::size_t{1}}) {
        bool all = true;
        for (std::size_t i = 0; i < kLooked; ++i)
            all = all && ((i % 2 == zero) == (bytes[i] == '\0'));
        if (all) return true;
    }
    return false;
}

/// Texts with angle brackets or braces, of which no file of a scene is made.
std::optional<FileContent> markup_of(std::string_view bytes) {
    const std::string_view text = without_mark(bytes);
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return std::nullopt;
    const std::string head = small_letters(std::string(text.substr(begin, 512)));
    constexpr std::string_view kPage = "download the file itself: the page only links to it";
    for (const std::string_view tag : {"<!doctype html", "<html", "<head", "<body"})
        if (head.starts_with(tag)) return FileContent{"a web page", kPage};
    if (head.starts_with("{")) return FileContent{"a JSON text", ""};
    if (!head.starts_with("<")) return std::nullopt;
    for (const auto& [tag, content] : {std::pair("<html", FileContent{"a web page", kPage}),
                                       std::pair("<scene", FileContent{"a Mitsuba scene", ""}),
                                       std::pair("<collada", FileContent{"a COLLADA scene", ""}),
                                       std::pair("<svg", FileContent{"an SVG picture", ""})})
        if (head.find(tag) != std::string::npos) return content;
    if (head.starts_with("<?xml")) return FileContent{"an XML text", ""};
    return std::nullopt;
}

}  // namespace

std::optional<FileContent> content_of(std::string_view bytes) {
    if (bytes.empty()) return FileContent{"empty", kAgain};
    const auto* const mark = std::find_if(kMarks.begin(), kMarks.end(), [&](const Mark& m) {
        return bytes.size() >= m.at && bytes.substr(m.at).starts_with(m.bytes) &&
               begins_as_it_should(m, bytes);
    });
    if (mark != kMarks.end()) return mark->content;
    if (is_bare_utf16(bytes)) return FileContent{"UTF-16 text", kUtf8};
    return markup_of(bytes);
}

void refuse_other_content(std::string_view bytes, const std::string& name,
                          const std::string& wanted) {
    const auto content = content_of(bytes);
    if (!content) return;
    throw Error({name}, "is " + std::string(content->what) + ", where " + wanted + " is read",
                content->mend.empty() ? "give " + wanted : std::string(content->mend));
}

}  // namespace sunfleck::engine
