// parameter_format.h: how values of parameters are spelled in files: an object {id: value}.
//
// A number is a number, a toggle true or false, a choice its id in quotes, a colour three numbers;
// ids, ranges and choices are those of the rows. Text goes in and out, so that headers stay free of
// JSON.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/look/old_metres.h"
#include "core/look/parameter.h"

namespace neph {

/// The object of all of `rows` on one line, in their order; reads back bit for bit.
std::string formatParameters(std::span<const Parameter> rows, const ParameterSet& values);

/// What an object of parameters named.
struct ParsedParameters {
    std::vector<const Parameter*> named;
    FieldSet inMetres = 0;  ///< whose noise scale an older version wrote: see old_metres.h
};

/// Reads an object of some of `rows` into `values` and returns which it named; `where` opens the
/// messages. Unknown keys are reported in `warnings`, each with the nearest known one. Throws Error
/// naming key, value and range.
ParsedParameters parseParameters(std::string_view json, std::span<const Parameter> rows,
                                 std::string_view where, ParameterSet& values,
                                 std::vector<std::string>& warnings);

}  // namespace neph
