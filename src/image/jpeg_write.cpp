// Writes JPEG by libjpeg.
//
// libjpeg reports errors by longjmp: the function that calls it holds no object with a destructor.
#include "image/atomic_file.h"
#include "image/jpeg.h"
#include "sunfleck/error.h"

#include <jpeglib.h>

#include <array>
#include <cmath>
#include <csetjmp>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <span>
#include <vector>

namespace sunfleck::engine {
namespace {

constexpr int kFullColourQuality = 90;

/// State of one encoding. `manager` comes first, because the library passes its address.
struct JpegOutput {
    jpeg_error_mgr manager;
    std::jmp_buf way_out;
    std::array<char, JMSG_LENGTH_MAX> fault;
    std::vector<std::uint8_t> rgb;
    Vec2i size;
    int quality;
    unsigned char* bytes;  // of malloc()
    unsigned long count;
};

[[noreturn]] void on_write_fault(j_common_ptr info) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the library's only interface
    auto& job = *reinterpret_cast<JpegOutput*>(info->err);
    (*info->err->format_message)(info, job.fault.data());
    job.bytes = nullptr;  // the library may have released them
    std::longjmp(job.way_out, 1);
}

void set_up(jpeg_compress_struct& info, const JpegOutput& job) {
    info.image_width = static_cast<JDIMENSION>(job.size.x);
    info.image_height = static_cast<JDIMENSION>(job.size.y);
    info.input_components = 3;
    info.in_color_space = JCS_RGB;
    jpeg_set_defaults(&info);
    jpeg_set_quality(&info, job.quality, TRUE);
    info.dct_method = JDCT_ISLOW;  // the same integers on every processor
    info.optimize_coding = TRUE;
    const int sampling = job.quality >= kFullColourQuality ? 1 : 2;  // of light, per colour
    info.comp_info[0].h_samp_factor = sampling;
    info.comp_info[0].v_samp_factor = sampling;
}

void encode_jpeg(JpegOutput& job) {
    jpeg_compress_struct info;
    info.err = jpeg_std_error(&job.manager);
    job.manager.error_exit = on_write_fault;
    // NOLINTNEXTLINE(cert-err52-cpp,modernize-avoid-*): the library's only way to report
    if (setjmp(job.way_out) == 0) {
        jpeg_create_compress(&info);
        jpeg_mem_dest(&info, &job.bytes, &job.count);
        set_up(info, job);
        jpeg_start_compress(&info, TRUE);
        const std::size_t width = std::size_t{info.image_width} * 3;
        while (info.next_scanline < info.image_height) {
            JSAMPROW row = job.rgb.data() + info.next_scanline * width;
            jpeg_write_scanlines(&info, &row, 1);
        }
        jpeg_finish_compress(&info);
    }
    jpeg_destroy_compress(&info);
}

}  // namespace

void write_jpeg(const std::string& path, const Picture& picture, const OutputTransform& transform,
                int quality) {
    JpegOutput job{};
    job.size = {picture.width, picture.height};
    job.quality = quality;
    for (const float value : screen_values(picture, transform, path))
        job.rgb.push_back(static_cast<std::uint8_t>(std::lround(255 * value)));
    encode_jpeg(job);
    const std::unique_ptr<unsigned char, decltype(&std::free)> owned(job.bytes, &std::free);
    if (job.fault[0] != '\0')
        throw Error({path}, std::string("cannot be written as JPEG: ") + job.fault.data(),
                    "write it as .png");
    write_file(path, std::as_bytes(std::span(job.bytes, job.count)));
}

}  // namespace sunfleck::engine
