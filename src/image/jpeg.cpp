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

namespace sunfleck {
namespace {

/// A coefficient costs at least a bit, and stands for 64 pixels of one channel.
constexpr std::uint64_t kPixelsPerByte = 512;
constexpr std::uint64_t kFreePixels = 1U << 12U;
/// Each goes over the whole picture, and may be some bytes long. Usual are ten.
constexpr int kMostScans = 500;

/// What one call of libjpeg works on. `manager` comes first: the library hands out its address.
struct Job {
    jpeg_error_mgr manager;
    jpeg_progress_mgr progress;
    std::jmp_buf way_out;
    std::array<char, JMSG_LENGTH_MAX> fault;
    const ByteSource* source;
    std::string_view bytes;
    Vec2i resolution;
    int channels;
    std::vector<std::uint8_t> texels;
};

[[noreturn]] void on_fault(j_common_ptr info) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the library's only interface
    auto& job = *reinterpret_cast<Job*>(info->err);
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
    auto& job = *reinterpret_cast<Job*>(info->err);
    // NOLINTEND(cppcoreguidelines-pro-type-reinterpret-cast)
    if (decompress.input_scan_number <= kMostScans) return;
    std::snprintf(job.fault.data(), job.fault.size(), "it has more than %d scans", kMostScans);
    std::longjmp(job.way_out, 1);
}

void read_rows(jpeg_decompress_struct& info, Job& job) {
    jpeg_start_decompress(&info);
    const std::size_t width = std::size_t{info.image_width} * static_cast<unsigned>(job.channels);
    while (info.output_scanline < info.output_height) {
        JSAMPROW row = job.texels.data() + info.output_scanline * width;
        jpeg_read_scanlines(&info, &row, 1);
    }
}

void decode(Job& job) {
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
        const bool is_grey = info.num_components == 1;
        info.out_color_space = is_grey ? JCS_GRAYSCALE : JCS_RGB;
        job.channels = is_grey ? 1 : 3;
        job.resolution = {static_cast<int>(info.image_width), static_cast<int>(info.image_height)};
        const std::uint64_t pixels = std::uint64_t{info.image_width} * info.image_height;
        if (pixels > job.bytes.size() * kPixelsPerByte + kFreePixels) {
            std::snprintf(job.fault.data(), job.fault.size(), "%s",
                          "it claims more pixels than its size can hold");
        } else {
            job.texels.resize(pixels * static_cast<std::uint64_t>(job.channels));
            read_rows(info, job);
        }
    }
    jpeg_destroy_decompress(&info);
}

}  // namespace

Image parse_jpeg(std::string_view bytes, const std::string& name) {
    const ByteSource source(bytes, name, "JPEG");
    Job job{};
    job.bytes = bytes;
    decode(job);
    if (job.fault[0] != '\0') source.refuse(job.fault.data());
    return {job.resolution, job.channels, std::move(job.texels)};
}

}  // namespace sunfleck
