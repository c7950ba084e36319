// Values of flags, read from a user's text: durations, sizes, ranges. Each throws Error that names
// the flag.
#pragma once

#include "aovs/channels.h"
#include "film/relight.h"
#include "stages/settings.h"

#include <array>
#include <cstdint>
#include <string>

namespace sunfleck::engine {

/// "60s", "5m", "2h", "90" (seconds). @throws Error naming the flag.
double read_duration(const std::string& text, const std::string& flag);
/// "2%" or "0.02". @throws Error naming the flag.
double read_share(const std::string& text, const std::string& flag);
/// "4G", "512MiB": bytes, in powers of 1024. @throws Error naming the flag.
std::uint64_t read_bytes(const std::string& text, const std::string& flag);
/// A number in (0, most). @throws Error naming the flag.
double read_positive(const std::string& text, const std::string& flag, int most);
/// "42": 0 to 2^64 - 1. @throws Error naming the flag.
std::uint64_t read_seed(const std::string& text, const std::string& flag);
/// "640x480". @throws Error naming the flag.
Vec2i read_size(const std::string& text, const std::string& flag);
/// NAME=FACTOR or NAME=R,G,B. @throws Error naming the text.
LightGroupFactor read_factor(const std::string& text);
/// "a,b,c,d". @throws Error naming the flag.
std::array<int, 4> read_crop(const std::string& text, const std::string& flag);
/// "0,0.5,0,1": four fractions in [0, 1]. @throws Error naming the flag.
std::array<double, 4> read_crop_window(const std::string& text, const std::string& flag);
/// "caustic,depth"; empty: none. @throws Error naming the flag.
AovSet read_aovs(const std::string& text, const std::string& flag);
/// "a:b", into first and end pass. @throws Error naming the flag.
void read_pass_range(const std::string& text, const std::string& flag, StopSettings& stop);

}  // namespace sunfleck::engine
