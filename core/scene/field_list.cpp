#include "core/scene/field_list.h"

#include <algorithm>
#include <stdexcept>

#include "core/base/error.h"
#include "core/base/suggest.h"
#include "core/scene/scene.h"

namespace whorl {
namespace {

using Middle = FieldDisplay::Middle;

std::vector<FieldInfo>& table() {
    static std::vector<FieldInfo> all{
        {.key = "density",
         .title = "Density",
         .symbol = "ρ",
         .unit = "",
         .counted = true,
         .source = Source{.stroke = Source::Stroke::Raise, .brush = 0.5, .emitter = 0.5},
         .display =
             FieldDisplay{"Smoke density", "ρ", "How much smoke there is.", "magma", Middle::None, 10}},
        {.key = "temperature",
         .title = "Temperature",
         .symbol = "T",
         .unit = "degrees",
         .ambient = [](const Scene& s) { return s.ambient; },
         .source = Source{.stroke = Source::Stroke::Blend,
                          .brush = 30,
                          .emitter = 50,
                          .least = -1000,
                          .most = 1000,
                          .slider_least = -50,
                          .slider_most = 100},
         .display =
             FieldDisplay{"Temperature", "degrees", "Cold is blue, warm is red, still air is in the middle.",
                          "blue-red", Middle::Ambient, 20}},
        {.key = "u",
         .title = "x velocity",
         .symbol = "u",
         .unit = "length/time",
         .site = Site::FaceX,
         .advected_by = AdvectedBy::Velocity},
        {.key = "v",
         .title = "y velocity",
         .symbol = "v",
         .unit = "length/time",
         .site = Site::FaceY,
         .advected_by = AdvectedBy::Velocity},
        {.key = "pressure",
         .title = "Pressure",
         .symbol = "p",
         .unit = "density · length²/time²",
         .advected_by = AdvectedBy::Nothing,
         .display =
             FieldDisplay{"Pressure", "p", "Of the last projection.", "blue-dark-red", Middle::Zero, 50}},
    };
    return all;
}

Amounts amounts(double Source::*of) {
    Amounts all;
    for_sources([&](FieldId id) { all.set(id, *id.info().source.*of); });
    return all;
}

template <class Chosen>
FieldId find_among(Chosen&& chosen, std::string_view key) {
    std::vector<std::string_view> keys;
    std::optional<FieldId> found;
    for_fields(chosen, [&](FieldId id) {
        if (id.info().key == key) found = id;
        keys.push_back(id.info().key);
    });
    if (found) return *found;
    throw InputError("no field is called \"" + std::string(key) + "\"; " + suggestion(key, keys));
}

}  // namespace

const FieldInfo& FieldId::info() const {
    return table()[index_];
}

std::span<const FieldInfo> fields() {
    return table();
}

FieldId find_field(std::string_view key) {
    return find_among([](const FieldInfo&) { return true; }, key);
}

FieldId find_advected(std::string_view key) {
    return find_among([](const FieldInfo& info) { return info.advected_by != AdvectedBy::Nothing; }, key);
}

std::vector<FieldId> advected_fields() {
    std::vector<FieldId> all;
    for_advected([&](FieldId id) { all.push_back(id); });
    return all;
}

FieldId add_scalar(const FieldInfo& added) {
    const auto all = fields();
    if (std::any_of(all.begin(), all.end(), [&](const FieldInfo& f) { return f.key == added.key; }))
        throw std::invalid_argument("a field is called \"" + std::string(added.key) + "\" already");
    if (added.site != Site::Centre || added.advected_by != AdvectedBy::Scalars)
        throw std::invalid_argument("a scalar sits at cell centres and moves by the scalars' schemes");
    table().push_back(added);
    return FieldId(table().size() - 1);
}

std::size_t scalar_count() {
    return 2 + table().size() - field::solved;
}

FieldId scalar(std::size_t k) {
    return FieldId(k < 2 ? k : k - 2 + field::solved);
}

std::size_t scalar_index(FieldId id) {
    return id.index() < 2 ? id.index() : id.index() - field::solved + 2;
}

bool Amounts::operator==(const Amounts& other) const {
    const std::size_t most = std::max(values_.size(), other.values_.size());
    for (std::size_t k = 0; k < most; ++k) {
        if ((*this)[FieldId(k)] != other[FieldId(k)]) return false;
    }
    return true;
}

Amounts brush_amounts() {
    return amounts(&Source::brush);
}

Amounts emitter_amounts() {
    return amounts(&Source::emitter);
}

}  // namespace whorl
