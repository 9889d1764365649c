// Lists of schemes: what every menu, command line, file, test and benchmark iterates, and the one dispatch.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "core/base/scheme_info.h"

namespace whorl {

/// A closed list of scheme types, each with a static `info`. The first one is the default.
template <class... Schemes>
struct SchemeList {
    static constexpr std::array<SchemeInfo, sizeof...(Schemes)> infos{Schemes::info...};

    /// One scheme of this list, chosen at run time.
    class Id {
      public:
        constexpr Id() = default;
        /// @pre index < infos.size()
        static constexpr Id at(std::size_t index) {
            Id id;
            id.index_ = static_cast<std::uint8_t>(index);
            return id;
        }
        constexpr std::size_t index() const { return index_; }
        constexpr const SchemeInfo& info() const { return infos[index_]; }
        constexpr std::string_view key() const { return info().key; }
        constexpr bool operator==(const Id&) const = default;

      private:
        std::uint8_t index_ = 0;
    };

    template <class Scheme>
    static constexpr Id of() {
        static_assert((std::is_same_v<Scheme, Schemes> || ...), "not a scheme of this list");
        constexpr bool same[] = {std::is_same_v<Scheme, Schemes>...};
        std::size_t index = 0;
        while (!same[index]) ++index;
        return Id::at(index);
    }

    static constexpr std::optional<Id> find(std::string_view key) {
        for (std::size_t k = 0; k < infos.size(); ++k) {
            if (infos[k].key == key) return Id::at(k);
        }
        return std::nullopt;
    }

    /// Calls `f(std::type_identity<Scheme>{})` for the chosen scheme.
    template <class F>
    static decltype(auto) dispatch(Id id, F&& f) {
        return call<0>(id, std::forward<F>(f));
    }

  private:
    template <std::size_t K>
    using Nth = std::tuple_element_t<K, std::tuple<Schemes...>>;

    template <std::size_t K, class F>
    static decltype(auto) call(Id id, F&& f) {
        if constexpr (K + 1 < sizeof...(Schemes)) {
            if (id.index() != K) return call<K + 1>(id, std::forward<F>(f));
        }
        return f(std::type_identity<Nth<K>>{});
    }
};

}  // namespace whorl
