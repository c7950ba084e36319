// JPEG files by way of libjpeg.
//
// libjpeg leaves by longjmp: the function that calls it holds nothing with a destructor.
#include "image/byte_source.h"
#include "image/formats.h"

#include <jerror.h>
#include <jpeglib.h>

#include <array>
#include <csetjmp>
#include <cstddef>
#include <cstdio>

namespace sunfleck::engine {
namespace {

/// A coefficient costs at least a bit, and stands for 64 pixels of one channel.
constexpr std::uint64_t kPixelsPerByte = 512;
constexpr std::uint64_t kFreePixels = 1U << 12U;
/// Each goes over the whole picture, and may be some bytes long. Usual are ten.
constexpr int kMostScans = 500;

/// What one call of libjpeg works on. `manager` comes first: the library hands out its address.
struct JpegJob {
    jpeg_error_mgr manager;
    jpeg_progress_mgr progress;
    std::jmp_buf way_out;
    std::array<char, JMSG_LENGTH_MAX> fault;
    const ByteSource* source;
    std::string_view bytes;
    Vec2i resolution;
    std::size_t components;  // that the library gives: 1 grey, 3 RGB, 4 CMYK
    bool inks_are_inverted;  // 255 is no ink, as Adobe's programs have it
    std::vector<std::uint8_t> texels;
};

[[noreturn]] void on_fault(j_common_ptr info) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the library's only interface
    auto& job = *reinterpret_cast<JpegJob*>(info->err);
    (*info->err->format_message)(info, job.fault.data());
    std::longjmp(job.way_out, 1);
}

/// Warnings of a file that goes on are passed over, but for one that ended too early.
void on_warning(j_common_ptr info, int level) {
    if (level < 0 && info->err->msg_code == JWRN_JPEG_EOF) on_fault(info);
}

/// Called now and then while the library is at work.
void on_progress(j_common_ptr info) {
    // NOLINTBEGIN(cppcoreguidelines-pro-type-reinterpret-cast): the library's only interface
    const auto& decompress = *reinterpret_cast<j_decompress_ptr>(info);
    auto& job = *reinterpret_cast<JpegJob*>(info->err);
    // NOLINTEND(cppcoreguidelines-pro-type-reinterpret-cast)
    if (decompress.input_scan_number <= kMostScans) return;
    std::snprintf(job.fault.data(), job.fault.size(), "it has more than %d scans", kMostScans);
    std::longjmp(job.way_out, 1);
}

/// Is there memory for that many bytes? If not, the fault says so.
bool fits(std::uint64_t bytes, JpegJob& job) {
    const std::string fault = fault_of_size(bytes);
    std::snprintf(job.fault.data(), job.fault.size(), "%s", fault.c_str());
    return fault.empty();
}

/// Each ink takes away its colour, black all three: what is left of R, G and B. (A colour profile
/// is not applied.)
std::vector<std::uint8_t> rgb_of_inks(const std::vector<std::uint8_t>& inks, bool inverted) {
    std::vector<std::uint8_t> rgb(inks.size() / 4 * 3);
    const auto paper = [&](std::size_t i) { return inverted ? inks[i] : 255U - inks[i]; };
    for (std::size_t i = 0; i < inks.size() / 4; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            rgb[3 * i + c] =
                static_cast<std::uint8_t>((paper(4 * i + c) * paper(4 * i + 3) + 127) / 255);
    return rgb;
}

void read_rows(jpeg_decompress_struct& info, JpegJob& job) {
    jpeg_start_decompress(&info);
    const std::size_t width = std::size_t{info.image_width} * job.components;
    while (info.output_scanline < info.output_height) {
        JSAMPROW row = job.texels.data() + info.output_scanline * width;
        jpeg_read_scanlines(&info, &row, 1);
    }
}

void decode(JpegJob& job) {
    jpeg_decompress_struct info;
    info.err = jpeg_std_error(&job.manager);
    job.manager.error_exit = on_fault;
    job.manager.emit_message = on_warning;
    // NOLINTNEXTLINE(cert-err52-cpp,modernize-avoid-*): the library's only way to report
    if (setjmp(job.way_out) == 0) {
        jpeg_create_decompress(&info);
        job.progress.progress_monitor = on_progress;
        info.progress = &job.progress;
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): characters as bytes
        const auto* bytes = reinterpret_cast<const unsigned char*>(job.bytes.data());
        jpeg_mem_src(&info, bytes, job.bytes.size());
        jpeg_read_header(&info, TRUE);
        const bool has_inks =
            info.jpeg_color_space == JCS_CMYK || info.jpeg_color_space == JCS_YCCK;
        const bool is_grey = info.num_components == 1;
        info.out_color_space = is_grey ? JCS_GRAYSCALE : has_inks ? JCS_CMYK : JCS_RGB;
        job.components = is_grey ? 1 : has_inks ? 4 : 3;
        job.inks_are_inverted = info.saw_Adobe_marker != 0;
        job.resolution = {static_cast<int>(info.image_width), static_cast<int>(info.image_height)};
        const std::uint64_t pixels = std::uint64_t{info.image_width} * info.image_height;
        if (pixels > job.bytes.size() * kPixelsPerByte + kFreePixels) {
            std::snprintf(job.fault.data(), job.fault.size(), "%s",
                          "it claims more pixels than its size can hold");
        } else if (fits(pixels * job.components, job)) {
            job.texels.resize(pixels * job.components);
            read_rows(info, job);
        }
    }
    jpeg_destroy_decompress(&info);
}

}  // namespace

Image parse_jpeg(std::string_view bytes, const std::string& name) {
    const ByteSource source(bytes, name, "JPEG");
    JpegJob job{};
    job.bytes = bytes;
    decode(job);
    if (job.fault[0] != '\0') source.refuse(job.fault.data());
    if (job.components == 4)
        return {job.resolution, 3, rgb_of_inks(job.texels, job.inks_are_inverted)};
    return {job.resolution, static_cast<int>(job.components), std::move(job.texels)};
}

}  // namespace sunfleck::engine
