// What a run carries: one table of its fields, which everything that handles fields iterates.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/grid/grid.h"

namespace whorl {

struct Scene;

/// Whose schemes move a field.
enum class AdvectedBy { Nothing, Scalars, Velocity };

/// How brush and emitters put a scalar into the fluid.
struct Source {
    enum class Stroke {
        Raise,  ///< up to the stroke's amount, fading from its line; what is denser stays
        Blend,  ///< towards the stroke's amount, by a share that fades from its line
    };
    Stroke stroke = Stroke::Raise;
    double brush = 0;                          ///< amount of a new scene's brush
    double emitter = 0;                        ///< amount of a new emitter
    double least = 0, most = 100;              ///< what an amount may be
    double slider_least = 0, slider_most = 1;  ///< what a slider offers
};

/// How colours show a field.
struct FieldDisplay {
    enum class Middle { None, Zero, Ambient };
    std::string_view label;  ///< of the view
    std::string_view unit;
    std::string_view help;
    std::string_view map;          ///< key of the colour map
    Middle middle = Middle::None;  ///< of the colours; None grows from 0
    int rank = 25;                 ///< its place in menus: they go by rank
};

struct FieldInfo {
    std::string_view key;    ///< in files and on command lines
    std::string_view title;  ///< as it begins a sentence
    std::string_view symbol;
    std::string_view unit;
    Site site = Site::Centre;
    AdvectedBy advected_by = AdvectedBy::Scalars;
    /// Of fluid at rest: at the start, and where a wall is opened. Null for 0.
    double (*ambient)(const Scene&) = nullptr;
    /// Whether its total is kept account of: what was put in and taken out.  [T 5.5]
    bool counted = false;
    std::optional<Source> source{};         ///< for scalars: how brush and emitters act on it
    std::optional<FieldDisplay> display{};  ///< for fields at centres: its view
};

/// A field, by its place in the table.
class FieldId {
  public:
    constexpr FieldId() = default;
    /// @pre index < fields().size()
    constexpr explicit FieldId(std::size_t index) : index_(static_cast<std::uint8_t>(index)) {}
    constexpr std::size_t index() const { return index_; }
    const FieldInfo& info() const;
    constexpr bool operator==(const FieldId&) const = default;

  private:
    std::uint8_t index_ = 0;
};

/// The fields of the smoke model, which are always there.  [T sec. 2; F sec. 2]
namespace field {
inline constexpr FieldId density{0}, temperature{1}, u{2}, v{3}, pressure{4};
inline constexpr std::size_t solved = 5;  ///< how many they are
}  // namespace field

/// All fields: those above, then further scalars. This is the digest's order.
std::span<const FieldInfo> fields();

/// @throws InputError that names the nearest keys
FieldId find_field(std::string_view key);
/// The same among the fields that the flow moves.
FieldId find_advected(std::string_view key);
/// Those, in the table's order.
std::vector<FieldId> advected_fields();

/// Adds a scalar at cell centres, before the first Scene is made.
/// @throws std::invalid_argument where the key is taken, or it is no scalar
FieldId add_scalar(const FieldInfo& scalar);

/// The scalars, density first, in the table's order.
std::size_t scalar_count();
FieldId scalar(std::size_t k);
/// The place of a field among the scalars. @pre it is one
std::size_t scalar_index(FieldId id);

/// Calls `work(id)` for every field that `chosen(info)` holds for.
template <class Chosen, class Work>
void for_fields(Chosen&& chosen, Work&& work) {
    for (std::size_t k = 0; k < fields().size(); ++k) {
        if (chosen(fields()[k])) work(FieldId(k));
    }
}

/// Calls `work(id)` for every field that the flow moves.
template <class Work>
void for_advected(Work&& work) {
    for_fields([](const FieldInfo& info) { return info.advected_by != AdvectedBy::Nothing; }, work);
}

/// Calls `work(id)` for every scalar that brush and emitters put in.
template <class Work>
void for_sources(Work&& work) {
    for_fields([](const FieldInfo& info) { return info.source.has_value(); }, work);
}

/// An amount of each scalar that brush and emitters put in; 0 where none is given.
class Amounts {
  public:
    struct Entry {
        FieldId field;
        double value;
    };
    Amounts() = default;
    Amounts(std::initializer_list<Entry> entries) {
        for (const Entry& entry : entries) set(entry.field, entry.value);
    }
    double operator[](FieldId id) const { return id.index() < values_.size() ? values_[id.index()] : 0; }
    void set(FieldId id, double value) { at(id) = value; }
    /// References hold while the amounts do.
    double& at(FieldId id) {
        if (values_.empty()) values_.resize(fields().size(), 0.0);
        return values_[id.index()];
    }
    bool operator==(const Amounts& other) const;

  private:
    std::vector<double> values_;
};

/// The amounts of a new scene's brush, and of a new emitter.
Amounts brush_amounts();
Amounts emitter_amounts();

}  // namespace whorl
