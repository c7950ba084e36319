// Files of all formats, made here byte by byte or by the formats' own libraries.
#pragma once

#include "image/image.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <jpeglib.h>
#include <png.h>
#include <webp/encode.h>

#include <bit>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <string>

namespace sunfleck::engine::testing_support {

using Bytes = std::vector<std::uint8_t>;

inline std::string text_of(const Bytes& bytes) {
    return {bytes.begin(), bytes.end()};
}

/// @param type  PNG_COLOR_TYPE_*. @param rows  packed as PNG has them (16 bits: high byte first).
inline std::string png_file(const Vec2i& size, int bits, int type, const Bytes& rows,
                            const std::vector<png_color>& palette = {}) {
    std::string file;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &file,
        [](png_structp p, png_bytep bytes, std::size_t count) {
            static_cast<std::string*>(png_get_io_ptr(p))->append(bytes, bytes + count);
        },
        nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(size.x), static_cast<png_uint_32>(size.y),
                 bits, type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (!palette.empty()) png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
    png_write_info(png, info);
    const std::size_t row = rows.size() / static_cast<std::size_t>(size.y);
    for (int y = 0; y < size.y; ++y)
        png_write_row(png, rows.data() + row * static_cast<std::size_t>(y));
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return file;
}

/// @param channels  1, 3, or 4 inks.
/// @param inks  how inks are stored: JCS_CMYK or JCS_YCCK. @param adobe  with Adobe's marker.
inline std::string jpeg_file(const Vec2i& size, int channels, Bytes texels, int quality = 95,
                             J_COLOR_SPACE inks = JCS_CMYK, bool adobe = true) {
    jpeg_compress_struct info;
    jpeg_error_mgr manager;
    info.err = jpeg_std_error(&manager);
    jpeg_create_compress(&info);
    unsigned char* bytes = nullptr;
    unsigned long count = 0;
    jpeg_mem_dest(&info, &bytes, &count);
    info.image_width = static_cast<JDIMENSION>(size.x);
    info.image_height = static_cast<JDIMENSION>(size.y);
    info.input_components = channels;
    info.in_color_space = channels == 1 ? JCS_GRAYSCALE : channels == 3 ? JCS_RGB : JCS_CMYK;
    jpeg_set_defaults(&info);
    if (channels == 4) {
        jpeg_set_colorspace(&info, inks);
        info.write_Adobe_marker = adobe ? TRUE : FALSE;
    }
    jpeg_set_quality(&info, quality, TRUE);
    jpeg_start_compress(&info, TRUE);
    for (int y = 0; y < size.y; ++y) {
        JSAMPROW row = texels.data() + static_cast<std::size_t>(y * size.x * channels);
        jpeg_write_scanlines(&info, &row, 1);
    }
    jpeg_finish_compress(&info);
    std::string file(bytes, bytes + count);
    jpeg_destroy_compress(&info);
    std::free(bytes);
    return file;
}

/// @param channels  3 or 4.
inline std::string webp_file(const Vec2i& size, int channels, const Bytes& texels) {
    std::uint8_t* bytes = nullptr;
    const auto encode = channels == 4 ? WebPEncodeLosslessRGBA : WebPEncodeLosslessRGB;
    const std::size_t count = encode(texels.data(), size.x, size.y, size.x * channels, &bytes);
    std::string file(bytes, bytes + count);
    WebPFree(bytes);
    return file;
}

/// @param type  of the header: 1, 2, 3, or 9, 10, 11 packed. @param rest  what follows it.
inline std::string tga_file(const Vec2i& size, int type, int bits, int descriptor,
                            const Bytes& rest, int palette = 0, int palette_bits = 0) {
    const auto byte = [](int v) { return static_cast<std::uint8_t>(v); };
    Bytes head = {0,
                  byte(palette > 0 ? 1 : 0),
                  byte(type),
                  0,
                  0,
                  byte(palette),
                  0,
                  byte(palette_bits),
                  0,
                  0,
                  0,
                  0,
                  byte(size.x & 255),
                  byte(size.x >> 8),
                  byte(size.y & 255),
                  byte(size.y >> 8),
                  byte(bits),
                  byte(descriptor)};
    head.insert(head.end(), rest.begin(), rest.end());
    return text_of(head);
}

inline std::string hdr_file(const Vec2i& size, const Bytes& rows) {
    return "#?RADIANCE\n# made up\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=1\n\n-Y " +
           std::to_string(size.y) + " +X " + std::to_string(size.x) + "\n" + text_of(rows);
}

/// @param values  rows from the bottom.
inline std::string pfm_file(const std::string& head, const std::vector<float>& values,
                            bool small_end_first) {
    std::string file = head;
    for (const float value : values) {
        const auto bits = std::bit_cast<std::uint32_t>(value);
        for (unsigned i = 0; i < 4; ++i)
            file += static_cast<char>(bits >> 8U * (small_end_first ? i : 3 - i) & 255U);
    }
    return file;
}

class StringStream : public Imf::OStream {
public:
    StringStream() : Imf::OStream("memory") {}
    void write(const char* bytes, int count) override {
        const auto size = static_cast<std::size_t>(count);
        if (file.size() < position_ + size) file.resize(position_ + size);
        std::memcpy(file.data() + position_, bytes, size);
        position_ += size;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }
    std::string file;

private:
    std::uint64_t position_ = 0;
};

/// @param values  one list a channel.
template <class Value>
std::string exr_file(const Vec2i& size, const std::vector<std::string>& names,
                     std::vector<std::vector<Value>> values) {
    const auto type = std::is_same_v<Value, half> ? Imf::HALF : Imf::FLOAT;
    Imf::Header header(size.x, size.y);
    Imf::FrameBuffer buffer;
    for (std::size_t c = 0; c < names.size(); ++c) {
        header.channels().insert(names[c], Imf::Channel(type));
        buffer.insert(names[c], Imf::Slice::Make(type, values[c].data(), header.dataWindow()));
    }
    StringStream stream;
    {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(buffer);
        file.writePixels(size.y);
    }
    return stream.file;
}

}  // namespace sunfleck::engine::testing_support
