// Reads named arrays, and believes no number before it has compared it with the file's size.
#include "import/pbrt/tensor_file.h"

#include "import/pbrt/words.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>

namespace sunfleck::engine {
namespace {

constexpr std::string_view kMagic("tensor_file\0\1\0", 14);
constexpr std::uint32_t kMostFields = 1000;
constexpr std::uint16_t kMostDimensions = 8;
constexpr std::uint8_t kFloat = 10;

class Bytes {
public:
    Bytes(const std::string& bytes, const SourceLocation& from) : bytes_(bytes), from_(from) {}

    [[noreturn]] void fail(const std::string& fault) const {
        throw Error(from_, "the file of measurements " + fault,
                    "use a .bsdf file with spectra, as measured by Dupuy and Jakob");
    }

    std::string_view take(std::size_t count) {
        if (count > bytes_.size() - place_) fail("ends too early");
        const std::string_view taken(bytes_.data() + place_, count);
        place_ += count;
        return taken;
    }

    /// Unsigned, little-endian.
    template <class T>
    T number() {
        T value = 0;
        const std::string_view taken = take(sizeof(T));
        for (std::size_t i = sizeof(T); i-- > 0;)
            value =
                static_cast<T>((std::uint64_t{value} << 8U) | static_cast<unsigned char>(taken[i]));
        return value;
    }

    void go_to(std::uint64_t place) {
        if (place > bytes_.size()) fail("ends too early");
        place_ = place;
    }
    std::size_t place() const { return place_; }
    std::size_t size() const { return bytes_.size(); }

private:
    const std::string& bytes_;
    const SourceLocation& from_;
    std::size_t place_ = 0;
};

struct Field {
    std::string name;
    std::uint8_t type = 0;
    std::uint64_t place = 0;
    std::vector<std::size_t> extents;
};

Field next_field(Bytes& bytes) {
    Field field;
    field.name = bytes.take(bytes.number<std::uint16_t>());
    const auto dimensions = bytes.number<std::uint16_t>();
    if (dimensions > kMostDimensions) bytes.fail("has a field of more than 8 dimensions");
    field.type = bytes.number<std::uint8_t>();
    field.place = bytes.number<std::uint64_t>();
    for (int i = 0; i < dimensions; ++i) field.extents.push_back(bytes.number<std::uint64_t>());
    return field;
}

Tensor tensor_of(const Field& field, Bytes& bytes) {
    const std::string named = "field " + in_quotes(field.name);
    if (field.type != kFloat) bytes.fail("has a " + named + " that is not of floats");
    std::size_t count = 1;
    for (const std::size_t extent : field.extents) {
        if (extent == 0 || extent > bytes.size() / count)
            bytes.fail("has a " + named + " that does not fit into it");
        count *= extent;
    }
    bytes.go_to(field.place);
    if (count > (bytes.size() - bytes.place()) / 4) bytes.fail("ends too early");
    Tensor tensor{field.extents, {}};
    tensor.values.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        tensor.values.push_back(std::bit_cast<float>(bytes.number<std::uint32_t>()));
        if (!std::isfinite(tensor.values.back()))
            bytes.fail("has a " + named + " with a number that is not finite");
    }
    return tensor;
}

}  // namespace

std::map<std::string, Tensor> read_tensors(const std::string& bytes,
                                           const std::map<std::string, std::size_t>& wanted,
                                           const SourceLocation& from) {
    Bytes reader(bytes, from);
    if (bytes.substr(0, kMagic.size()) != kMagic) reader.fail("does not begin as one");
    reader.take(kMagic.size());
    const auto fields = reader.number<std::uint32_t>();
    if (fields > kMostFields) reader.fail("has more than 1000 fields");
    std::map<std::string, Tensor> tensors;
    for (std::uint32_t i = 0; i < fields; ++i) {
        const Field field = next_field(reader);
        const auto want = wanted.find(field.name);
        if (want == wanted.end() || tensors.contains(field.name)) continue;
        if (field.extents.size() != want->second)
            reader.fail("has a field " + in_quotes(field.name) + " of another shape");
        const std::size_t next = reader.place();
        tensors[field.name] = tensor_of(field, reader);
        reader.go_to(next);
    }
    for (const auto& [name, dimensions] : wanted)
        if (!tensors.contains(name)) reader.fail("has no field " + in_quotes(name));
    return tensors;
}

}  // namespace sunfleck::engine
