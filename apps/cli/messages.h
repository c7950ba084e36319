// What the program says on standard error, and the check that what it printed has been written.
#pragma once

#include <functional>
#include <string_view>

namespace sunfleck::engine {

/// Call this first. A standard stream that is closed stays closed: no file that the
/// program opens takes its number, and with it what was meant for the stream. A pipe whose reader
/// has ended makes writing fail, in place of ending the program.
void keep_streams();

/// Writes a line on standard error, in one piece. A line that cannot be written is lost, and the
/// program goes on. Signal handlers may call it.
void say(std::string_view line);

/// Draws a line on the terminal that the next one, or the next say(), replaces. The cursor stays at
/// its first column: so one erasure clears the line also where a narrower terminal has folded it.
/// @param line  shorter than the terminal is wide; empty: none is left there.
void draw_live_line(std::string_view line);

/// Runs task(), which may print on standard output. @throws std::runtime_error if any of that was
/// lost.
void print_all(const std::function<void()>& task);

}  // namespace sunfleck::engine
