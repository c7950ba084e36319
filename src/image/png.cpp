// PNG images by libpng.
//
// libpng reports errors by longjmp: the two functions that call it hold no object with a
// destructor.
#include "image/png.h"

#include "image/atomic_file.h"
#include "image/formats.h"
#include "image/image_memory.h"
#include "image/read_file.h"
#include "sunfleck/error.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstddef>
#include <cstring>
#include <span>
#include <string_view>

namespace sunfleck::engine {
namespace {

constexpr std::uint32_t kMostPixelsAcross = 1U << 17U;
constexpr std::uint64_t kBytesPerByte = 1100;  // deflate expands a byte to at most 1032
constexpr std::uint64_t kFreeBytes = 1U << 16U;

/// State of one decoding, and the fault that ended it.
struct PngJob {
    std::string_view input;
    std::size_t used = 0;
    std::vector<std::byte> output;
    std::string fault;
    PngImage image;
    std::vector<png_byte> row;
    bool is_srgb = false;  // what is written says so
};

int colour_type(int channels) {
    if (channels == 1) return PNG_COLOR_TYPE_GRAY;
    return channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB;
}

[[noreturn]] void on_fault(png_structp png, png_const_charp text) {
    static_cast<PngJob*>(png_get_error_ptr(png))->fault = text;
    png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void on_read(png_structp png, png_bytep bytes, std::size_t count) {
    auto& job = *static_cast<PngJob*>(png_get_io_ptr(png));
    if (job.input.size() - job.used < count) png_error(png, "the file is truncated");
    std::memcpy(bytes, job.input.data() + job.used, count);
    job.used += count;
}

void on_write(png_structp png, png_bytep bytes, std::size_t count) {
    auto& job = *static_cast<PngJob*>(png_get_io_ptr(png));
    const auto all = std::as_bytes(std::span(bytes, count));
    job.output.insert(job.output.end(), all.begin(), all.end());
}

void on_flush(png_structp) {}

/// Checks the header and sets the transformations that give 8 or 16 bits per channel. Neither this
/// nor read_rows() is inlined into decode(), where their locals would live across setjmp().
[[gnu::noinline]] void prepare(png_structp png, png_infop info, PngJob& job) {
    png_set_user_limits(png, kMostPixelsAcross, kMostPixelsAcross);
    png_read_info(png, info);
    png_set_expand(png);  // palettes and few bits become 8 bits, transparency becomes alpha
    const int passes = png_set_interlace_handling(png);
    png_read_update_info(png, info);
    job.image.width = static_cast<int>(png_get_image_width(png, info));
    job.image.height = static_cast<int>(png_get_image_height(png, info));
    job.image.channels = png_get_channels(png, info);
    job.image.bits = png_get_bit_depth(png, info);
    const std::uint64_t bytes =
        std::uint64_t{png_get_rowbytes(png, info)} * static_cast<std::uint64_t>(job.image.height);
    if (bytes > job.input.size() * kBytesPerByte + kFreeBytes)
        png_error(png, "its header claims more pixels than the file can hold");
    // The rows with values of 16 bits, and the texels, are in memory together.
    job.fault = fault_of_size(4 * bytes);
    if (!job.fault.empty()) png_longjmp(png, 1);
    if (passes != 1 && passes != 7) png_error(png, "unknown interlacing");
    job.row.resize(bytes);  // the whole image: interlaced rows are written several times
}

[[gnu::noinline]] void read_rows(png_structp png, png_infop info, PngJob& job) {
    const std::size_t row_bytes = png_get_rowbytes(png, info);
    const int passes = png_get_interlace_type(png, info) == PNG_INTERLACE_NONE ? 1 : 7;
    for (int pass = 0; pass < passes; ++pass)
        for (std::size_t y = 0; y < static_cast<std::size_t>(job.image.height); ++y)
            png_read_row(png, job.row.data() + y * row_bytes, nullptr);
    png_read_end(png, nullptr);
}

void decode(PngJob& job) {
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &job, on_fault, on_warning);
    png_infop info = png_create_info_struct(png);
    // NOLINTNEXTLINE(cert-err52-cpp,modernize-avoid-*): the library's only way to report
    if (setjmp(png_jmpbuf(png)) == 0) {
        png_set_read_fn(png, &job, on_read);
        prepare(png, info, job);
        read_rows(png, info, job);
    }
    png_destroy_read_struct(&png, &info, nullptr);
}

void encode(PngJob& job) {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &job, on_fault, on_warning);
    png_infop info = png_create_info_struct(png);
    const auto width = static_cast<png_uint_32>(job.image.width);
    const auto height = static_cast<png_uint_32>(job.image.height);
    const auto step = static_cast<std::size_t>(job.image.channels * job.image.bits / 8);
    // NOLINTNEXTLINE(cert-err52-cpp,modernize-avoid-*): the library's only way to report
    if (setjmp(png_jmpbuf(png)) == 0) {
        png_set_write_fn(png, &job, on_write, on_flush);
        png_set_IHDR(png, info, width, height, job.image.bits, colour_type(job.image.channels),
                     PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        if (job.is_srgb) png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
        png_write_info(png, info);
        for (std::size_t y = 0; y < height; ++y)
            png_write_row(png, job.row.data() + y * width * step);
        png_write_end(png, info);
    }
    png_destroy_write_struct(&png, &info);
}

/// Returns the bytes of values in [0,1], each rounded to the nearest level; of 16 bits the high
/// byte comes first.
std::vector<png_byte> levels_of(const std::vector<float>& values, int bits) {
    const std::size_t step = bits == 16 ? 2 : 1;
    std::vector<png_byte> bytes(values.size() * step);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const long level = std::lround((bits == 16 ? 65535 : 255) * values[i]);
        if (step == 2) bytes[2 * i] = static_cast<png_byte>(level >> 8);
        bytes[step * i + step - 1] = static_cast<png_byte>(level & 255);
    }
    return bytes;
}

}  // namespace

void write_png(const std::string& path, const Picture& picture, const OutputTransform& transform,
               int bits) {
    PngJob job;
    job.image.width = picture.width;
    job.image.height = picture.height;
    job.image.channels = 3;
    job.image.bits = bits;
    job.is_srgb = true;
    job.row = levels_of(screen_values(picture, transform, path), bits);
    encode(job);
    if (!job.fault.empty())
        throw Error({path}, "cannot be written as PNG: " + job.fault, "write it as .exr");
    write_file(path, job.output);
}

std::string png_bytes(const Vec2i& size, int channels, std::span<const std::uint8_t> values) {
    PngJob job;
    job.image.width = size.x;
    job.image.height = size.y;
    job.image.channels = channels;
    job.row.assign(values.begin(), values.end());
    encode(job);
    if (!job.fault.empty())
        throw Error({"picture"}, "cannot be written as PNG: " + job.fault, "make it smaller");
    std::string bytes(job.output.size(), '\0');
    std::memcpy(bytes.data(), job.output.data(), bytes.size());
    return bytes;
}

PngImage read_png(const std::string& path) {
    return parse_png(read_file(path), path);
}

PngImage parse_png(std::string_view bytes, const std::string& name) {
    PngJob job;
    job.input = bytes;
    decode(job);
    if (!job.fault.empty())
        throw Error({name}, "cannot be read as PNG: " + job.fault,
                    "write the picture again as PNG");
    const std::size_t step = job.image.bits == 16 ? 2 : 1;
    job.image.values.resize(job.row.size() / step);
    for (std::size_t i = 0; i < job.image.values.size(); ++i)
        job.image.values[i] = static_cast<std::uint16_t>(
            step == 1 ? job.row[i] : (job.row[2 * i] << 8U) | job.row[2 * i + 1]);
    return std::move(job.image);
}

Image parse_png_image(std::string_view bytes, const std::string& name, const Encoding& encoding) {
    const PngImage png = parse_png(bytes, name);
    const Vec2i resolution(png.width, png.height);
    if (png.bits == 8) {
        std::vector<std::uint8_t> texels(png.values.size());
        std::transform(png.values.begin(), png.values.end(), texels.begin(),
                       [](std::uint16_t v) { return static_cast<std::uint8_t>(v); });
        return {resolution, png.channels, std::move(texels), encoding};
    }
    std::vector<float> texels(png.values.size());
    std::transform(png.values.begin(), png.values.end(), texels.begin(),
                   [&](std::uint16_t v) { return encoding.decode(static_cast<float>(v) / 65535); });
    return {resolution, png.channels, std::move(texels)};
}

}  // namespace sunfleck::engine
