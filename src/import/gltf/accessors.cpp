// Conversion of stored numbers, element by element.
#include "import/gltf/accessors.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>

namespace sunfleck::engine {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF stores little-endian numbers");

using Replaced = std::map<const void*, std::string>;

/// The type of a stored number.
enum class Stored { int8 = 5120, uint8, int16, uint16, uint32 = 5125, float32 };

std::size_t size_of(Stored type) {
    if (type == Stored::int8 || type == Stored::uint8) return 1;
    return type == Stored::int16 || type == Stored::uint16 ? 2 : 4;
}

Stored stored_type(const JsonPlace& place) {
    const std::uint64_t code = place.whole();
    if (code < 5120 || code > 5126 || code == 5124)
        place.refuse("is no component type", "write 5120 to 5123, 5125 or 5126");
    return static_cast<Stored>(code);
}

template <class T>
T read_as(const char* from) {
    T value;
    std::memcpy(&value, from, sizeof(T));
    return value;
}

/// Returns a stored number. @param normalized  integers become -1 to 1.
double number_at(const char* from, Stored type, bool normalized) {
    const auto whole = [&](auto value) {
        using Integer = decltype(value);
        const auto x = static_cast<double>(value);
        if (!normalized) return x;
        return std::max(-1.0, x / static_cast<double>(std::numeric_limits<Integer>::max()));
    };
    switch (type) {
        case Stored::int8:
            return whole(read_as<std::int8_t>(from));
        case Stored::uint8:
            return whole(read_as<std::uint8_t>(from));
        case Stored::int16:
            return whole(read_as<std::int16_t>(from));
        case Stored::uint16:
            return whole(read_as<std::uint16_t>(from));
        case Stored::uint32:
            return whole(read_as<std::uint32_t>(from));
        case Stored::float32:
            return static_cast<double>(read_as<float>(from));
    }
    return 0;
}

/// An array of elements in a buffer view.
struct Elements {
    std::string_view bytes;
    std::size_t stride = 0;
    std::size_t size = 0;  // numbers of an element
    Stored type = Stored::float32;
    bool normalized = false;

    double at(std::size_t element, std::size_t number) const {
        return number_at(&bytes[element * stride + number * size_of(type)], type, normalized);
    }
};

/// Returns elements of a buffer view that lie within it.
/// @param holder  has "bufferView", and perhaps "byteOffset".
Elements elements_of(const GltfDocument& document, const JsonPlace& holder, std::size_t count,
                     Elements elements) {
    const JsonPlace view = document.element("bufferViews", holder.at("bufferView"));
    const std::string_view bytes = document.bytes_of(view);
    const std::size_t element = elements.size * size_of(elements.type);
    const std::uint64_t stride = view.whole("byteStride", element);
    const std::uint64_t begin = holder.whole("byteOffset", 0);
    const bool has_room = begin <= bytes.size() && element <= bytes.size() - begin;
    if (stride == 0) view.refuse("has a byteStride of 0", "export the file again");
    if (count > 0 && (!has_room || (count - 1) > (bytes.size() - begin - element) / stride))
        holder.refuse("has more elements than its buffer view", "export the file again");
    elements.bytes = bytes.substr(count > 0 ? static_cast<std::size_t>(begin) : 0);
    elements.stride = static_cast<std::size_t>(stride);
    return elements;
}

std::size_t numbers_of_type(std::string_view type) {
    if (type == "SCALAR") return 1;
    if (type == "VEC2") return 2;
    if (type == "VEC3") return 3;
    if (type == "VEC4" || type == "MAT2") return 4;
    if (type == "MAT3") return 9;
    return type == "MAT4" ? 16 : 0;
}

std::size_t count_of(const JsonPlace& accessor) {
    const JsonPlace count = accessor.at("count");
    const std::uint64_t n = count.whole();
    if (n > std::numeric_limits<std::uint32_t>::max())
        count.refuse("is more than 2^32 elements", "divide the mesh");
    return static_cast<std::size_t>(n);
}

/// Replaces the elements that a sparse accessor lists.
template <class Element, class Convert>
void replace_sparse(const GltfDocument& document, const JsonPlace& sparse, Elements form,
                    const Convert& convert, std::vector<Element>& values) {
    const std::size_t count = count_of(sparse);
    const JsonPlace indices = sparse.at("indices");
    const Elements places = elements_of(
        document, indices, count, {{}, 0, 1, stored_type(indices.at("componentType")), false});
    const Elements given = elements_of(document, sparse.at("values"), count, form);
    for (std::size_t i = 0; i < count; ++i) {
        const double place = places.at(i, 0);
        if (!(place >= 0 && place < static_cast<double>(values.size())))
            indices.refuse("names an element beyond the end", "export the file again");
        values[static_cast<std::size_t>(place)] = convert(given, i);
    }
}

/// Returns all elements. @param size  numbers of an element.
/// @param convert  of an Elements and an index.
/// @param replaced  bytes in place of those of the buffer views, by accessors.
template <class Element, class Convert>
std::vector<Element> all_of(const GltfDocument& document, const Replaced& replaced,
                            const JsonPlace& accessor, std::size_t size, const Convert& convert) {
    const JsonPlace type = accessor.at("type");
    if (numbers_of_type(type.text()) != size)
        type.refuse("is \"" + type.text() + "\", of another size than its use here",
                    "export the file again");
    const std::size_t count = count_of(accessor);
    const Elements form{
        {}, 0, size, stored_type(accessor.at("componentType")), accessor.flag("normalized", false)};
    const auto sparse = accessor.find("sparse");
    std::vector<Element> values;
    const auto other = replaced.find(accessor.identity());
    if (other != replaced.end()) {
        Elements elements = form;
        elements.bytes = other->second;
        elements.stride = size * size_of(form.type);
        for (std::size_t i = 0; i < count; ++i) values.push_back(convert(elements, i));
    } else if (accessor.find("bufferView")) {
        const Elements elements = elements_of(document, accessor, count, form);
        values.reserve(count);
        for (std::size_t i = 0; i < count; ++i) values.push_back(convert(elements, i));
    } else {
        // Zeros; no more of them than the file could fill.
        constexpr std::size_t kMostZeros = std::size_t{1} << 26U;
        if (count > kMostZeros) accessor.refuse("has no buffer view", "export the file again");
        const std::string zero(size * size_of(form.type), '\0');
        Elements elements = form;
        elements.bytes = zero;
        values.assign(count, convert(elements, 0));
    }
    if (sparse) replace_sparse(document, *sparse, form, convert, values);
    return values;
}

/// Returns the conversion to arrays of finite floats.
template <std::size_t Size>
auto to_floats(const JsonPlace& accessor) {
    return [accessor](const Elements& elements, std::size_t i) {
        std::array<float, Size> values{};
        for (std::size_t n = 0; n < Size; ++n) {
            values[n] = static_cast<float>(elements.at(i, n));
            if (!std::isfinite(values[n]))
                accessor.refuse("element " + std::to_string(i) + " is not finite",
                                "export the file again");
        }
        return values;
    };
}

template <std::size_t Size>
auto to_integers(const JsonPlace& accessor) {
    return [accessor](const Elements& elements, std::size_t i) {
        std::array<std::uint32_t, Size> values{};
        for (std::size_t n = 0; n < Size; ++n) {
            const double value = elements.at(i, n);
            if (!(value >= 0 && value <= 0xFFFFFFFFU && value == std::floor(value)))
                accessor.refuse("element " + std::to_string(i) + " is no index",
                                "export the file again");
            values[n] = static_cast<std::uint32_t>(value);
        }
        return values;
    };
}

}  // namespace

void Accessors::replace(const JsonPlace& index, std::string bytes, std::size_t size) {
    const JsonPlace accessor = at(index);
    const bool fits = numbers_of_type(accessor.at("type").text()) == size &&
                      bytes.size() == count_of(accessor) * size *
                                          size_of(stored_type(accessor.at("componentType")));
    if (!fits) accessor.refuse("does not fit what is unpacked for it", "export the file again");
    replaced_[accessor.identity()] = std::move(bytes);
}

std::vector<float> Accessors::scalars(const JsonPlace& index) const {
    const auto one = to_floats<1>(at(index));
    return all_of<float>(document_, replaced_, at(index), 1,
                         [&](const Elements& e, std::size_t i) { return one(e, i)[0]; });
}

std::vector<Vec2> Accessors::pairs(const JsonPlace& index) const {
    const auto two = to_floats<2>(at(index));
    return all_of<Vec2>(document_, replaced_, at(index), 2, [&](const Elements& e, std::size_t i) {
        const auto v = two(e, i);
        return Vec2(v[0], v[1]);
    });
}

std::vector<Vec3> Accessors::triples(const JsonPlace& index) const {
    const auto three = to_floats<3>(at(index));
    return all_of<Vec3>(document_, replaced_, at(index), 3, [&](const Elements& e, std::size_t i) {
        const auto v = three(e, i);
        return Vec3(v[0], v[1], v[2]);
    });
}

std::vector<Vec3> Accessors::directions(const JsonPlace& index) const {
    return all_of<Vec3>(document_, replaced_, at(index), 3, [](const Elements& e, std::size_t i) {
        const Vec3d v(e.at(i, 0), e.at(i, 1), e.at(i, 2));
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) ? Vec3(v) : Vec3(0);
    });
}

std::vector<std::array<float, 4>> Accessors::quadruples(const JsonPlace& index) const {
    return all_of<std::array<float, 4>>(document_, replaced_, at(index), 4,
                                        to_floats<4>(at(index)));
}

std::vector<std::array<float, 16>> Accessors::matrices(const JsonPlace& index) const {
    return all_of<std::array<float, 16>>(document_, replaced_, at(index), 16,
                                         to_floats<16>(at(index)));
}

std::vector<std::uint32_t> Accessors::indices(const JsonPlace& index) const {
    const auto one = to_integers<1>(at(index));
    return all_of<std::uint32_t>(document_, replaced_, at(index), 1,
                                 [&](const Elements& e, std::size_t i) { return one(e, i)[0]; });
}

std::uint32_t Accessors::largest_index(const JsonPlace& index) const {
    const std::size_t bytes = size_of(stored_type(at(index).at("componentType")));
    return std::numeric_limits<std::uint32_t>::max() >> (32 - 8 * bytes);
}

std::vector<std::array<std::uint32_t, 4>> Accessors::index_quadruples(
    const JsonPlace& index) const {
    return all_of<std::array<std::uint32_t, 4>>(document_, replaced_, at(index), 4,
                                                to_integers<4>(at(index)));
}

}  // namespace sunfleck::engine
