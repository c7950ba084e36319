// Reads OpenEXR files from memory by way of the OpenEXR library.
#include "core/file_content.h"
#include "core/printable.h"
#include "image/exr.h"
#include "image/exr_colours.h"
#include "image/exr_file.h"
#include "image/formats.h"
#include "image/read_file.h"
#include "math/colour.h"
#include "sunfleck/error.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <cstdint>
#include <exception>

namespace sunfleck::engine {
namespace {

/// The first part of a file, with a plausible size.
class FirstPart {
public:
    FirstPart(std::string_view bytes, const std::string& name)
        : bytes_(bytes, name),
          input_(bytes_, 0),
          resolution_(exr_resolution(input_.header(), name)),
          rows_(input_.header(), resolution_) {
        check_exr_values(pixels() * exr_channel_count(input_.header()), bytes_, name);
    }

    const Imf::Header& header() const { return input_.header(); }
    const Imf::ChannelList& channels() const { return input_.header().channels(); }
    const Vec2i& resolution() const { return resolution_; }
    std::size_t pixels() const {
        return static_cast<std::size_t>(resolution_.x) * static_cast<std::size_t>(resolution_.y);
    }

    template <class Value>
    void place(const char* channel, Value* first, std::size_t step) {
        rows_.place(channel, first, step);
    }
    void read() { rows_.read(input_); }

private:
    ExrBytes bytes_;
    Imf::InputFile input_;
    Vec2i resolution_;
    ExrRows rows_;
};

/// Returns a picture without channels, with the texts of a header.
Picture empty_picture(const Imf::Header& header, const Vec2i& resolution) {
    Picture picture{resolution.x, resolution.y, {}, {}};
    picture.pixel_aspect = header.pixelAspectRatio();
    for (auto a = header.begin(); a != header.end(); ++a) {
        const std::string name = a.name();
        if (name == "name" || name == "type") continue;  // of the part, not of the picture
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&a.attribute()))
            picture.metadata[name] = text->value();
    }
    return picture;
}

Picture read_only_part(std::string_view bytes, const std::string& name) {
    FirstPart file(bytes, name);
    Picture picture = empty_picture(file.header(), file.resolution());
    for (auto c = file.channels().begin(); c != file.channels().end(); ++c) picture.add(c.name());
    for (Channel& channel : picture.channels)
        file.place(channel.name.c_str(), channel.values.data(), 1);
    file.read();
    return picture;
}

/// Checks that the parts have one size and that their values can be in the file.
Vec2i common_resolution(const Imf::MultiPartInputFile& file, const ExrBytes& bytes,
                        const std::string& name) {
    const Vec2i first = exr_resolution(file.header(0), name);
    std::uint64_t channels = 0;
    for (int part = 0; part < file.parts(); ++part) {
        if (exr_resolution(file.header(part), name) != first)
            refuse_exr(name, "has parts of several sizes");
        channels += exr_channel_count(file.header(part));
    }
    check_exr_values(
        static_cast<std::uint64_t>(first.x) * static_cast<std::uint64_t>(first.y) * channels, bytes,
        name);
    return first;
}

/// Adds the channels of one part.
void read_part(Imf::MultiPartInputFile& file, int number, Picture& picture,
               const std::string& name) {
    const Imf::Header& header = file.header(number);
    const std::size_t before = picture.channels.size();
    ExrRows rows(header, {picture.width, picture.height});
    std::vector<std::string> in_file;
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c) {
        std::string channel = c.name();
        in_file.push_back(channel);
        if (picture.find(channel) != nullptr) channel = header.name() + "." + channel;
        if (picture.find(channel) != nullptr)
            refuse_exr(name, "has channel \"" + printable(channel, 60) + "\" twice");
        picture.add(channel);
    }
    for (std::size_t i = 0; i < in_file.size(); ++i)
        rows.place(in_file[i].c_str(), picture.channels[before + i].values.data(), 1);
    Imf::InputPart part(file, number);
    rows.read(part);
}

/// Reads all parts. The channels are in the order of their names, as those of a single part are.
Picture read_all_parts(std::string_view bytes, const std::string& name) {
    ExrBytes stream(bytes, name);
    if (!stream.has_parts()) return read_only_part(bytes, name);
    Imf::MultiPartInputFile file(stream, 0);
    Picture picture = empty_picture(file.header(0), common_resolution(file, stream, name));
    for (int part = 0; part < file.parts(); ++part) read_part(file, part, picture, name);
    std::sort(picture.channels.begin(), picture.channels.end(),
              [](const Channel& a, const Channel& b) { return a.name < b.name; });
    return picture;
}

template <class Value>
Image read_colours(FirstPart& file, const std::vector<std::string>& names) {
    const std::size_t count = names.size();
    std::vector<Value> texels(file.pixels() * count);
    for (std::size_t c = 0; c < count; ++c) file.place(names[c].c_str(), texels.data() + c, count);
    file.read();
    return {file.resolution(), static_cast<int>(count), std::move(texels)};
}

/// Converts texels of CIE XYZ to linear sRGB.
Image rgb_of(const Image& xyz) {
    std::vector<float> texels = std::get<std::vector<float>>(xyz.texels());
    for (std::size_t i = 0; i < texels.size(); i += 3) {
        const Triple rgb =
            rgb_of_xyz({double{texels[i]}, double{texels[i + 1]}, double{texels[i + 2]}});
        for (std::size_t c = 0; c < 3; ++c) texels[i + c] = static_cast<float>(rgb.at(c));
    }
    return {xyz.resolution(), 3, std::move(texels)};
}

/// Returns whether the file declares primaries other than Rec. 709; files without any have those.
bool has_other_primaries(const Imf::Header& header) {
    if (!Imf::hasChromaticities(header)) return false;
    constexpr float kAlike = 0.003F;
    const Imf::Chromaticities given = Imf::chromaticities(header);
    const Imf::Chromaticities usual;
    const auto differ = [](const Imath::V2f& a, const Imath::V2f& b) {
        return !a.equalWithAbsError(b, kAlike);
    };
    return differ(given.red, usual.red) || differ(given.green, usual.green) ||
           differ(given.blue, usual.blue) || differ(given.white, usual.white);
}

Image read_image(std::string_view bytes, const std::string& name) {
    FirstPart file(bytes, name);
    std::vector<std::string> all;
    for (auto c = file.channels().begin(); c != file.channels().end(); ++c)
        all.emplace_back(c.name());
    const ExrColours colours = exr_colours(all, name);
    const std::vector<std::string>& names = colours.channels;
    const bool all_half = !colours.are_xyz && std::all_of(names.begin(), names.end(), [&](auto& n) {
        return file.channels().findChannel(n)->type == Imf::HALF;
    });
    Image image = all_half ? read_colours<half>(file, names) : read_colours<float>(file, names);
    if (colours.are_xyz) image = rgb_of(image);
    if (names.size() >= 3 && !colours.are_xyz && has_other_primaries(file.header()))
        image.set_other_primaries();
    image.set_remark(colours.remark);
    return image;
}

/// Runs a task and converts exceptions of the library to Error.
template <class Task>
auto guarded(const std::string& name, const Task& task) {
    try {
        return task();
    } catch (const Error&) {
        throw;
    } catch (const std::exception& fault) {
        refuse_exr(name, "cannot be read as EXR: " + printable(fault.what(), 400));
    }
}

}  // namespace

Picture parse_exr(std::string_view bytes, const std::string& name) {
    if (!bytes.starts_with("\x76\x2F\x31\x01")) refuse_other_content(bytes, name, "an EXR picture");
    return guarded(name, [&] { return read_all_parts(bytes, name); });
}

Picture read_exr(const std::string& path) {
    return parse_exr(read_file(path), path);
}

Image parse_exr_image(std::string_view bytes, const std::string& name) {
    return guarded(name, [&] { return read_image(bytes, name); });
}

}  // namespace sunfleck::engine
