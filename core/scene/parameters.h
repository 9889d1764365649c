// The one table of tunables: sliders, `--set key=value`, TOML keys and the docs are made from it.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace whorl {

/// A tunable of a scene. Values travel as doubles: a truth as 0 or 1, a choice as its index.
struct Parameter {
    enum class Kind { Number, Integer, Switch, Choice };
    enum class Group { Domain, Time, Schemes, Particles, Forces, Pressure, Brush };

    std::string key;
    std::string label;
    std::string unit;
    std::string help;
    std::string source;  ///< equation or section
    Group group = Group::Domain;
    Kind kind = Kind::Number;
    double min = 0, max = 1;                ///< what is valid
    double slider_min = 0, slider_max = 1;  ///< what a slider offers
    bool logarithmic = false;
    std::vector<SchemeInfo> choices;

    std::function<double(const Scene&)> get;
    /// @pre the value is valid: parse and check do that
    std::function<void(Scene&, double)> set;

    double default_value() const { return get(Scene{}); }
    /// The value as files and command lines write it.
    std::string text(double value) const;
    /// @throws InputError naming the parameter and what is valid
    double parse(std::string_view text) const;
    void check(double value) const;
};

/// All parameters, in the order of the panels.
const std::vector<Parameter>& parameters();

/// @throws InputError that names the nearest keys
const Parameter& parameter(std::string_view key);

/// Sets `key` to `text`.  @throws InputError
void set_parameter(Scene& scene, std::string_view key, std::string_view text);

/// Sets from `key=value`.  @throws InputError
void set_parameter(Scene& scene, std::string_view assignment);

}  // namespace whorl
