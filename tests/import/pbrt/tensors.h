// Writes files of named float arrays, as measured materials come in.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace sunfleck::engine::test {

class TensorFile {
public:
    /// The extents are written as they are said, whether or not they fit the values.
    void add(const std::string& name, const std::vector<std::uint64_t>& extents,
             const std::vector<float>& values) {
        fields_.push_back({name, extents, values});
    }
    void drop(const std::string& name) {
        std::erase_if(fields_, [&](const Field& f) { return f.name == name; });
    }

    std::string bytes() const {
        std::string head("tensor_file\0\1\0", 14);
        std::size_t place = head.size() + 4;
        for (const Field& f : fields_) place += 13 + f.name.size() + 8 * f.extents.size();
        append<std::uint32_t>(head, static_cast<std::uint32_t>(fields_.size()));
        std::string body;
        for (const Field& f : fields_) {
            append<std::uint16_t>(head, static_cast<std::uint16_t>(f.name.size()));
            head += f.name;
            append<std::uint16_t>(head, static_cast<std::uint16_t>(f.extents.size()));
            append<std::uint8_t>(head, 10);
            append<std::uint64_t>(head, place + body.size());
            for (const std::uint64_t extent : f.extents) append<std::uint64_t>(head, extent);
            for (const float v : f.values) append(body, std::bit_cast<std::uint32_t>(v));
        }
        return head + body;
    }

private:
    struct Field {
        std::string name;
        std::vector<std::uint64_t> extents;
        std::vector<float> values;
    };

    template <class T>
    static void append(std::string& to, T value) {
        for (std::size_t i = 0; i < sizeof(T); ++i)
            to += static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * i) & 0xFFU);
    }

    std::vector<Field> fields_;
};

}  // namespace sunfleck::engine::test
