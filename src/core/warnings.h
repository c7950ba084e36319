// Warnings: what a scene asks for and does not get, each said once, with what was done instead.
#pragma once

#include "sunfleck/error.h"

#include <algorithm>
#include <string>
#include <vector>

namespace sunfleck::engine {

/// A list in the order of first appearance. A second warning of the same text adds to a count.
/// For one thread at a time.
class Warnings {
public:
    struct Entry {
        SourceLocation where;  // of the first
        std::string text;
        int count = 1;

        /// One line: place, text, and how often when more than once.
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
