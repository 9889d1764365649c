// A list of things to choose from by key: schemes, measures, views, tools …
#pragma once

#include <algorithm>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/suggest.h"

namespace whorl {

/// The key of an entry: its info's, or its own.
template <class Entry>
std::string_view key_of(const Entry& entry) {
    if constexpr (requires { entry.info.key; }) {
        return entry.info.key;
    } else {
        return entry.key;
    }
}

/// Entries in the order of menus; the first is the default. They live as long as the program.
/// Changed only before the first scene is made, by one thread.
template <class Entry>
class Registry {
  public:
    /// @param what  one of them in messages: "measure"
    Registry(std::string_view what, std::initializer_list<const Entry*> entries) : what_(what) {
        for (const Entry* entry : entries) add(*entry);
    }

    std::span<const Entry* const> all() const { return entries_; }

    /// The entry of a key, or of one that it had in older files; null where there is none.
    const Entry* seek(std::string_view key) const {
        const auto found = std::find_if(entries_.begin(), entries_.end(),
                                        [&](const Entry* entry) { return has_key(*entry, key); });
        return found == entries_.end() ? nullptr : *found;
    }
    /// @throws InputError that names the nearest keys
    const Entry& find(std::string_view key) const {
        if (const Entry* entry = seek(key)) return *entry;
        std::vector<std::string_view> keys;
        for (const Entry* entry : entries_) keys.push_back(key_of(*entry));
        throw InputError("unknown " + what_ + " \"" + std::string(key) + "\"; " + suggestion(key, keys));
    }
    /// The place of an entry in the list.
    std::size_t index(const Entry& entry) const {
        return static_cast<std::size_t>(std::find(entries_.begin(), entries_.end(), &entry) -
                                        entries_.begin());
    }

    /// @throws InputError if a key is taken
    void add(const Entry& entry) {
        if (seek(key_of(entry)) != nullptr)
            throw InputError("there is a " + what_ + " \"" + std::string(key_of(entry)) + "\" already");
        entries_.push_back(&entry);
    }
    /// For tests: takes an added entry out again.
    void remove(const Entry& entry) { std::erase(entries_, &entry); }

  private:
    static bool has_key(const Entry& entry, std::string_view key) {
        if constexpr (requires { entry.aliases; }) {
            if (std::find(entry.aliases.begin(), entry.aliases.end(), key) != entry.aliases.end())
                return true;
        }
        return key_of(entry) == key;
    }

    std::string what_;
    std::vector<const Entry*> entries_;
};

}  // namespace whorl
