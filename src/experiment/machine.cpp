// Linux tells the processor's name in /proc/cpuinfo.
#include "experiment/machine.h"

#include "core/parallel.h"

#include <fmt/format.h>

#include <fstream>

namespace sunfleck::engine {

std::string machine_text() {
    std::ifstream file("/proc/cpuinfo");
    std::string name = "unknown processor";
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("model name")) continue;
        name = line.substr(std::min(line.find(": ") + 2, line.size()));
        break;
    }
    return fmt::format("{}, {} threads.", name, thread_count());
}

}  // namespace sunfleck::engine
