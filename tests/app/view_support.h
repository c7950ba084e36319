// A render under way with a page, as a viewer meets it.
#pragma once

#include "app/program.h"
#include "live/http.h"

#include <chrono>
#include <sstream>
#include <string>
#include <thread>

namespace sunfleck::engine::testing_support {

class ViewTest : public ProgramTest {
protected:
    /// Words of a render that is over soon, but for `more`.
    static Words words(const Words& more) {
        Words all{"render", "room.pbrt", "--photons-per-pass", "2000", "--resolution", "32x32"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }

    /// The address that a render under way has said, on a line of its own.
    Address address() const {
        using namespace std::chrono_literals;
        for (int i = 0; i < 6000; ++i, std::this_thread::sleep_for(10ms)) {
            std::istringstream lines(read_text(path("stderr~")));
            for (std::string line; std::getline(lines, line);)
                if (line.starts_with("http://") && !lines.eof()) return Address(line);
        }
        ADD_FAILURE() << "no address";
        return Address("");
    }
};

}  // namespace sunfleck::engine::testing_support
