// Warnings: features of a scene that are not supported as asked, each reported once.
#pragma once

#include "sunfleck/error.h"

#include <algorithm>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// A list in order of first appearance. A repeated text increases a count. Not thread-safe.
class Warnings {
public:
    struct Entry {
        SourceLocation where;  // of the first occurrence
        std::string text;
        int count = 1;

        /// Returns one line: location, text, and the count if above one.
        std::string line() const {
            const std::string times = count > 1 ? " (" + std::to_string(count) + " times)" : "";
            return where.text() + ": warning: " + text + times;
        }
    };

    void add(const SourceLocation& where, const std::string& text) {
        const auto known = std::find_if(entries_.begin(), entries_.end(),
                                        [&](const Entry& e) { return e.text == text; });
        if (known == entries_.end())
            entries_.push_back({where, text});
        else
            ++known->count;
    }

    const std::vector<Entry>& entries() const { return entries_; }

private:
    std::vector<Entry> entries_;
};

}  // namespace sunfleck::engine
