// Checkpoints, word by word.
#include "render/checkpoint.h"

#include "core/input_file.h"
#include "film/film_file.h"
#include "sunfleck/error.h"

#include <bit>
#include <type_traits>

namespace sunfleck::engine {
namespace {

constexpr std::uint64_t kMagic = 0x0A'74'70'6B'63'6E'75'73;     // "sunckpt\n"
constexpr std::uint64_t kVersion = 10;                          // films of version 10
constexpr std::uint64_t kMostPasses = std::uint64_t{1} << 30U;  // as --passes
constexpr WordFileKind kCheckpointFile{kMagic, "checkpoint",
                                       "use another copy, or render anew without --resume"};

/// The archive (see StoredSample::visit) that writes.
class Put {
public:
    explicit Put(WordWriter& out) : out_(out) {}

    template <class... Values>
    void operator()(const Values&... values) {
        (put(values), ...);
    }

private:
    template <class T>
    void put(const T& value) {
        if constexpr (std::is_same_v<T, double>)
            out_.put(std::bit_cast<std::uint64_t>(value));
        else if constexpr (std::is_same_v<T, bool>)
            out_.put(std::uint64_t{value ? 1U : 0U});
        else
            out_.put(value);
    }
    template <class T>
    void put(const std::vector<T>& list) {
        out_.put(list.size());
        for (const T& value : list) put(value);
    }

    WordWriter& out_;
};

/// The archive that reads.
class Take {
public:
    explicit Take(WordReader& in) : in_(in) {}

    template <class... Values>
    void operator()(Values&... values) {
        (take(values), ...);
    }

private:
    void take(std::uint64_t& value) { value = in_.word(); }
    void take(double& value) { value = std::bit_cast<double>(in_.word()); }
    void take(bool& value) { value = in_.word_up_to(1) != 0; }
    void take(FixedPoint& value) { value = in_.sum(); }
    template <class T>
    void take(std::vector<T>& list) {
        list.resize(in_.word_up_to(in_.left() / (sizeof(T) / 8)));
        for (T& value : list) take(value);
    }

    WordReader& in_;
};

/// Hands a photon sampler's state to an archive.
/// @param state  SamplerState, constant for an archive that writes.
template <class Variant, class Archive>
void visit_sampler_state(Variant& state, Archive& archive) {
    std::visit(
        [&]<class State>(State& s) {
            if constexpr (!std::is_same_v<std::remove_const_t<State>, NoState>)
                std::remove_const_t<State>::visit(s, archive);
        },
        state);
}

/// The alternative of that index, to be filled by an archive.
template <std::size_t Index = std::variant_size_v<SamplerState> - 1>
SamplerState alternative_at(std::uint64_t index) {
    if constexpr (Index == 0) {
        return NoState();
    } else {
        if (index != Index) return alternative_at<Index - 1>(index);
        return std::variant_alternative_t<Index, SamplerState>(PhotonSettings(), 0.5, 0);
    }
}

/// The numbers of a state that are no sums.
struct Numbers {
    PassTimes seconds;
    double total_seconds = 0;
    double cpu_seconds = 0;
    double radius_factor = 1;

    template <class Self, class Archive>
    static void visit(Self& n, Archive& archive) {
        auto& s = n.seconds;
        archive(n.radius_factor, s.build, s.camera, s.index, s.photon, s.learn, n.total_seconds,
                n.cpu_seconds);
    }
};

bool is_sound(const RenderState& state) {
    const PassTimes& s = state.seconds;
    for (const double number : {state.radius_factor, s.build, s.camera, s.index, s.photon, s.learn,
                                state.total_seconds, state.cpu_seconds})
        if (!(number >= 0 && number < 1e15)) return false;
    const auto& ranges = state.film.passes().ranges();
    if (ranges.size() != 1 || ranges[0].end > kMostPasses) return false;
    const FilmKey& key = state.film.key();
    const bool has_state = !std::holds_alternative<NoState>(state.sampler);
    return has_state == key.sequential &&
           is_sound(state.sampler, key.pixels(), state.film.pass_count());
}

std::vector<SceneFileHash> take_files(WordReader& in) {
    std::vector<SceneFileHash> files;
    const std::uint64_t count = in.word_up_to(in.left() / 2);
    for (std::uint64_t i = 0; i < count; ++i) {
        std::string name = in.text();
        files.push_back({std::move(name), in.word()});
    }
    return files;
}

[[noreturn]] void refuse(const std::string& name, const std::string& difference) {
    throw Error({name}, "is of another render: " + difference,
                "resume it as it was begun, or render anew without --resume");
}

[[noreturn]] void refuse(const std::string& name, const std::string& what,
                         const std::string& in_file, const std::string& asked) {
    refuse(name, what + " differs: " + in_file + " in the file, " + asked + " asked for");
}

void check_same(const std::string& name, const std::string& what, const std::string& in_file,
                const std::string& asked) {
    if (in_file != asked) refuse(name, what, in_file, asked);
}

/// The first file that is another one, for the user to read.
std::string changed_file(const std::vector<SceneFileHash>& before,
                         const std::vector<SceneFileHash>& now) {
    if (before.size() != now.size())
        return "its scene is of " + std::to_string(before.size()) + " files, that asked for of " +
               std::to_string(now.size());
    for (std::size_t i = 0; i < now.size(); ++i)
        if (before[i].hash != now[i].hash) return "scene file " + now[i].name + " is not as it was";
    return "scene differs";
}

}  // namespace

void write_checkpoint(const std::string& path, const Origin& origin, const RenderState& state) {
    WordWriter out(path);
    Put put(out);
    out.put(kMagic);
    out.put(kVersion);
    out.put(origin.program);
    out.put(origin.isa);
    out.put(origin.files.size());
    for (const SceneFileHash& file : origin.files) put(file.name, file.hash);
    const Numbers numbers{state.seconds, state.total_seconds, state.cpu_seconds,
                          state.radius_factor};
    Numbers::visit(numbers, put);
    out.put(std::uint64_t{state.sampler.index()});
    visit_sampler_state(state.sampler, put);
    put_film(out, state.film);
    out.finish();
}

Checkpoint read_checkpoint(std::istream& stream, std::uint64_t size, const std::string& name) {
    WordReader in(stream, size, name, kCheckpointFile);
    Take take(in);
    in.check_head(kMagic, kVersion);
    Origin origin{in.text(), in.text(), take_files(in)};
    Numbers n;
    Numbers::visit(n, take);
    SamplerState sampler = alternative_at(in.word_up_to(std::variant_size_v<SamplerState> - 1));
    visit_sampler_state(sampler, take);
    Film film = take_film(in);
    in.finish();
    Checkpoint checkpoint{std::move(origin),
                          {std::move(film), n.seconds, n.total_seconds, n.cpu_seconds,
                           n.radius_factor, std::move(sampler)}};
    if (!is_sound(checkpoint.state)) in.damaged();
    return checkpoint;
}

Checkpoint read_checkpoint(const std::string& path) {
    OpenFile file = open_input_file(path, {path});
    return read_checkpoint(file.stream, file.size, path);
}

void check_same_render(const std::string& name, const Checkpoint& checkpoint, const Origin& origin,
                       const FilmKey& key, const StopSettings& stop) {
    const Origin& before = checkpoint.origin;
    const Film& film = checkpoint.state.film;
    check_same(name, "version of the program", before.program, origin.program);
    check_same(name, "isa", before.isa, origin.isa);
    if (film.key().scene_hash != key.scene_hash)
        refuse(name, changed_file(before.files, origin.files));
    if (const auto differs = difference(film.key(), key))
        refuse(name, differs->what, differs->here, differs->there);
    const PassRange& passes = film.passes().ranges().at(0);
    check_same(name, "first pass", std::to_string(passes.begin), std::to_string(stop.first_pass));
    if (stop.end_pass && passes.end > *stop.end_pass)
        throw Error({name},
                    "holds passes up to " + std::to_string(passes.end) + ", and " +
                        std::to_string(*stop.end_pass) + " are asked for",
                    "ask for " + std::to_string(passes.end) + " or more");
}

}  // namespace sunfleck::engine
