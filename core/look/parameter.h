// parameter.h: the rows that declare every tunable once, and values in and out by them.
//
// Widgets, tooltips, reset, undo, presets, sessions, `--set`, options of the command line, what is
// recomputed and the parameter reference all come from the rows. Values are in SI units; panels
// multiply by `displayScale`.
#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/look/look.h"
#include "core/look/sampling.h"

namespace neph {

/// The value of every parameter.
struct ParameterSet {
    Look look;
    Sampling sampling;
    bool operator==(const ParameterSet&) const = default;
};

/// What must be recomputed when a parameter changes; each stage implies those after it. `data`: the
/// volume is read again.
enum class Stage : int { data, medium, light, eye, resolve };

enum class ParameterKind : int { toggle, integer, number, choice, colour };
using ParameterValue = std::variant<bool, int, float, glm::vec3>;  // a choice is an int

/// What a parameter goes with: one of the parts of a look that presets can be taken over by, or the
/// sampling.
enum class ParameterPart : int { fields, light, view, sampling };

/// What linked fields do when one of them is edited: keep their own value, take over the same
/// value, or change by the same factor.
enum class LinkPolicy : int { own, value, factor };

struct ParameterRange {
    double lo = 0.0;
    double hi = 1.0;
    bool log = false;  ///< sliders are logarithmic; zero, if allowed, sits at the left stop
};

struct Choice {
    std::string_view id;     ///< spelling in JSON and --set
    std::string_view label;  ///< spelling on screen
    std::string_view help;   ///< one line
};

/// An option of the command line that stands for `--set id=`; its value is typed as the screen
/// shows it, in `displayUnit`.
struct OptionAlias {
    std::string_view name;   ///< "--quality"; empty: none
    std::string_view takes;  ///< "NUMBER"
    std::string help;
};

/// A mode of the whole look that leaves a parameter without effect; panels show both.
struct Overrule {
    bool (*when)(const Look&) = nullptr;  ///< null: never
    std::string_view because;             ///< "Phase is Uniform"
};

/// Reads and writes one value of a Look or of a Sampling.
template <typename Owner>
struct ParameterAccess {
    std::function<ParameterValue(const Owner&)> get;
    std::function<void(Owner&, const ParameterValue&)>
        set;  ///< the value must be of the row's kind
};

struct Parameter {
    std::string id;
    std::string formerId;  ///< by which files and commands may still name it; empty: none
    std::string label;
    std::string group;  ///< heading in the panel and the reference page
    std::string unit;   ///< of the value; "1" for a pure number, empty for toggles and choices
    std::string help;   ///< one line: meaning, equation, source
    ParameterKind kind = ParameterKind::number;
    ParameterRange range;
    std::vector<Choice> choices;
    Stage invalidates = Stage::medium;
    std::string displayUnit;    ///< unit on screen, "µm"; empty where `unit` is "1" or empty
    double displayScale = 1.0;  ///< screen value = value × displayScale
    OptionAlias alias;

    ParameterPart part = ParameterPart::view;
    std::optional<Species> species;
    LinkPolicy link = LinkPolicy::own;  ///< between fields

    unsigned engines = kAllEngines;         ///< with which it acts, bits
    std::function<bool(const Look&)> acts;  ///< where it acts besides; null: everywhere
    Overrule overruled;

    std::variant<ParameterAccess<Look>, ParameterAccess<Sampling>> access;
};

/// The parameters of a look and those of the sampling, and all of them, in the order of the panels.
std::span<const Parameter> lookTable();
std::span<const Parameter> samplingTable();
std::span<const Parameter> parameterTable();

/// nullptr when there is none of that id.
const Parameter* findParameter(std::string_view id);

/// The row of that id; throws Error naming the nearest known id.
const Parameter& parameter(std::string_view id);

/// The row that an option of the command line stands for, "--quality"; there must be one.
const Parameter& parameterOfOption(std::string_view option);

/// Of a Look alone for rows of `lookTable()`; other rows are a bug.
ParameterValue valueOf(const Look& look, const Parameter& row);
ParameterValue valueOf(const ParameterSet& values, const Parameter& row);
ParameterValue defaultOf(const Parameter& row);

/// Stores a value; throws Error naming id, value and range or choices when it does not fit. `where`
/// opens the message.
void setValue(Look& look, const Parameter& row, const ParameterValue& value,
              std::string_view where = {});
void setValue(ParameterSet& values, const Parameter& row, const ParameterValue& value,
              std::string_view where = {});

/// What a parameter takes, in words: "a number from 0 to 90 deg", "one of physical, equal".
std::string rangeText(const Parameter& row);

/// Text of a value as `--set` reads it: 0.5, true, translucent, or r,g,b.
std::string formatValue(const Parameter& row, const ParameterValue& value);
/// Reads such text; throws Error.
ParameterValue parseValue(const Parameter& row, std::string_view text, std::string_view where = {});
/// The same, but numbers are those of the screen, without the unit: 10 for 10 µm. Throws Error.
ParameterValue parseScreenValue(const Parameter& row, std::string_view text,
                                std::string_view where = {});

/// Applies one `id=value`; throws Error.
void applyAssignment(ParameterSet& values, std::string_view assignment);

/// "view.quality=1 view.seed=0": the rows' values as assignments.
std::string formatAssignments(std::span<const Parameter> rows, const ParameterSet& values);

/// What follows a number on screen: " µm", "°", or nothing.
std::string unitSuffix(const Parameter& row);
/// Text of a value as the screen shows it: 10 µm, on, Translucent.
std::string screenText(const Parameter& row, const ParameterValue& value);

/// Whether a row acts at present: a parameter of a phase function acts where its kind reads it, a
/// constant radius where none comes from the model, a row of one engine while that engine draws.
bool applies(const Parameter& row, const Look& look);

/// Which mode leaves a row without effect: "Phase is Uniform"; empty where none does.
std::string_view overruledBy(const Parameter& row, const Look& look);

/// The earliest stage that differs; none when they are equal.
std::optional<Stage> firstDifference(const Look& a, const Look& b);
std::optional<Stage> firstDifference(const ParameterSet& a, const ParameterSet& b);

/// The known id that is nearest in spelling, for messages; empty when nothing is near.
std::string nearestParameterId(std::string_view id);

}  // namespace neph
