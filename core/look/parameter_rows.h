// parameter_rows.h: builds rows of the parameter table from member pointers.
//
// A group of rows is about one struct that lies within a Look or a Sampling; a *place* leads from
// there to the struct. The kind of a row and the type of its member must fit, or it does not
// compile: a number is a float, an integer an int, a toggle a bool, a choice an enumeration.
#pragma once
#include <initializer_list>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/look/parameter.h"

namespace neph {

/// The whole of a Look or a Sampling.
template <typename Whole>
struct WholeOf {
    using Owner = Whole;
    auto& operator()(auto& owner) const { return owner; }
};

/// One field of a Look.
struct FieldOf {
    using Owner = Look;
    Species species;
    auto& operator()(auto& look) const { return look.of(species); }
};

/// A member of the struct at another place.
template <typename Outer, typename Member>
struct MemberOf {
    using Owner = typename Outer::Owner;
    Outer outer;
    Member member;
    auto& operator()(auto& owner) const { return outer(owner).*member; }
};

/// Reads and writes the value at a place; choices go in and out as integers.
template <typename Place>
ParameterAccess<typename Place::Owner> accessTo(const Place& place) {
    using Owner = typename Place::Owner;
    using Value = std::remove_cvref_t<decltype(place(std::declval<Owner&>()))>;
    using Stored = std::conditional_t<std::is_enum_v<Value>, int, Value>;
    return {[place](const Owner& owner) { return static_cast<Stored>(place(owner)); },
            [place](Owner& owner, const ParameterValue& value) {
                place(owner) = static_cast<Value>(std::get<Stored>(value));
            }};
}

/// What the rows of a group share.
struct RowGroup {
    std::string name;    ///< heading
    std::string prefix;  ///< opens the ids
    ParameterPart part = ParameterPart::view;
    std::optional<Species> species = {};
    LinkPolicy link = LinkPolicy::own;
};

/// A unit as it is written on screen; nothing for a pure number.
std::string_view unitOnScreen(std::string_view unit);

/// Appends rows of the struct at a place to a table. A row that is returned can be completed until
/// the next one is added.
template <typename Place>
class Rows {
  public:
    using Owner = typename Place::Owner;
    using Struct = std::remove_reference_t<decltype(std::declval<Place>()(std::declval<Owner&>()))>;

    Rows(std::vector<Parameter>& table, RowGroup group, Place place = {})
        : table_(table), group_(std::move(group)), place_(place) {}

    const Place& place() const { return place_; }

    Parameter& toggle(const std::string& id, std::string_view label, bool Struct::*member,
                      Stage stage, std::string_view help) {
        return add(ParameterKind::toggle, id, label, member, stage, help);
    }
    Parameter& integer(const std::string& id, std::string_view label, std::string_view unit,
                       int Struct::*member, ParameterRange range, Stage stage,
                       std::string_view help) {
        return measured(add(ParameterKind::integer, id, label, member, stage, help), unit, range);
    }
    Parameter& number(const std::string& id, std::string_view label, std::string_view unit,
                      float Struct::*member, ParameterRange range, Stage stage,
                      std::string_view help) {
        return measured(add(ParameterKind::number, id, label, member, stage, help), unit, range);
    }
    Parameter& colour(const std::string& id, std::string_view label, glm::vec3 Struct::*member,
                      Stage stage, std::string_view help) {
        return measured(add(ParameterKind::colour, id, label, member, stage, help), "1",
                        {0.0, 1.0});
    }
    /// `choices` in the order of the enumeration.
    template <typename Enum>
    requires std::is_enum_v<Enum> Parameter& choice(const std::string& id, std::string_view label,
                                                    Enum Struct::*member, Stage stage,
                                                    std::vector<Choice> choices,
                                                    std::string_view help) {
        Parameter& row = add(ParameterKind::choice, id, label, member, stage, help);
        row.choices = std::move(choices);
        return row;
    }

    /// Rows of the same group about a struct within this one.
    template <typename Inner>
    Rows<MemberOf<Place, Inner Struct::*>> within(Inner Struct::*member) const {
        return {table_, group_, {place_, member}};
    }

  private:
    template <typename Value>
    Parameter& add(ParameterKind kind, const std::string& id, std::string_view label,
                   Value Struct::*member, Stage stage, std::string_view help) {
        Parameter& row = table_.emplace_back();
        row.id = group_.prefix + id;
        row.label = label;
        row.group = group_.name;
        row.help = help;
        row.kind = kind;
        row.invalidates = stage;
        row.part = group_.part;
        row.species = group_.species;
        row.link = group_.link;
        row.access = accessTo(MemberOf<Place, Value Struct::*>{place_, member});
        return row;
    }
    static Parameter& measured(Parameter& row, std::string_view unit, ParameterRange range) {
        row.unit = unit;
        row.displayUnit = unitOnScreen(unit);
        row.range = range;
        return row;
    }

    std::vector<Parameter>& table_;
    RowGroup group_;
    Place place_;
};

/// Rows of a look, in look_table.cpp and look_table_fields.cpp, and of the sampling.
using LookRows = Rows<WholeOf<Look>>;
using FieldRows = Rows<FieldOf>;
using SamplingRows = Rows<WholeOf<Sampling>>;

}  // namespace neph
