// One entry of a list, chosen at run time.
#pragma once

#include <cstdint>
#include <string_view>

#include "core/base/registry.h"

namespace whorl {

/// An entry of `Entry::list()` by its index, which holds within a program; files hold keys. At first the
/// list's first entry.
template <class Entry>
class Id {
  public:
    constexpr Id() = default;
    /// @throws InputError if the list has no such entry
    Id(const Entry& entry) : Id(key_of(entry)) {}  // NOLINT(google-explicit-constructor): it is that entry
    /// @throws InputError that names the nearest keys
    explicit Id(std::string_view key) : Id(at(Entry::list().index(Entry::list().find(key)))) {}
    /// @pre index < Entry::list().all().size()
    static constexpr Id at(std::size_t index) {
        Id id;
        id.index_ = static_cast<std::uint16_t>(index);
        return id;
    }

    constexpr std::size_t index() const { return index_; }
    const Entry& entry() const { return *Entry::list().all()[index_]; }
    const Entry* operator->() const { return &entry(); }
    const auto& info() const { return entry().info; }
    std::string_view key() const { return info().key; }
    constexpr bool operator==(const Id&) const = default;

  private:
    std::uint16_t index_ = 0;
};

}  // namespace whorl
