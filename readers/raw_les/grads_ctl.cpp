// grads_ctl.cpp: parses a descriptor line by line.
#include "readers/raw_les/grads_ctl.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "readers/les/text.h"

namespace les {
namespace {

// Limits that no model comes near; they keep sizes from overflowing.
constexpr std::size_t kMaxCells = 1U << 20U;  // along one axis
constexpr std::size_t kMaxTimes = 1'000'000;
constexpr std::size_t kMaxVariables = 10'000;

using Words = std::vector<std::string_view>;

/// Parser of one descriptor. Each function starts at line `line_`, whose words it is given, and
/// leaves `line_` at the last line that it used.
class Parser {
  public:
    explicit Parser(std::string_view text) : lines_(splitLines(text)) {}
    Ctl parse();

  private:
    void parseLine(const std::string& keyword, std::string_view line, const Words& words);
    void parseAxis(CtlAxis& axis, const char* name, const Words& words);
    void parseTimes(const Words& words);
    void parseOptions(const Words& words);
    void parseVariables(const Words& words);
    CtlVariable parseVariable(std::string_view line) const;
    void parseUnits(std::string_view line);
    void requireComplete() const;
    /// The next step after an entry that is not supported.
    std::string adviceOn(std::string_view keyword) const;
    /// The number after a keyword, from 1 to `most`.
    std::size_t count(const Words& words, std::size_t most, const char* of) const;
    [[noreturn]] void fail(const std::string& what, const std::string& expected,
                           const std::string& hint = {}) const;

    std::vector<std::string_view> lines_;
    std::size_t line_ = 0;
    Ctl ctl_;
};

void Parser::fail(const std::string& what, const std::string& expected,
                  const std::string& hint) const {
    throw Error{fmt::format("line {}: {}", std::min(line_, lines_.size() - 1) + 1, what),
                inQuotes(line_ < lines_.size() ? lines_[line_] : "the end of the file"), expected,
                hint};
}

std::size_t Parser::count(const Words& words, std::size_t most, const char* of) const {
    const auto value = words.size() > 1 ? parseInteger(words[1]) : std::nullopt;
    if (!value || *value < 1 || static_cast<std::uint64_t>(*value) > most) {
        fail(fmt::format("{} needs a count", of), fmt::format("1 to {}", most));
    }
    return static_cast<std::size_t>(*value);
}

void Parser::parseAxis(CtlAxis& axis, const char* name, const Words& words) {
    axis = {};
    axis.count = count(words, kMaxCells, name);
    const std::string kind = words.size() > 2 ? toLower(words[2]) : std::string();
    if (kind == "linear") {
        const auto start = words.size() > 3 ? parseNumber(words[3]) : std::nullopt;
        const auto step = words.size() > 4 ? parseNumber(words[4]) : std::nullopt;
        if (!start || !step) fail(fmt::format("{} linear needs two numbers", name), "start, step");
        axis.start = *start;
        axis.step = *step;
        return;
    }
    if (kind != "levels") fail(fmt::format("{} is of an unknown kind", name), "linear or levels");
    // The list of levels may continue on the following lines.
    Words rest(words.begin() + 3, words.end());
    while (true) {
        for (const std::string_view word : rest) {
            const auto value = parseNumber(word);
            if (!value || axis.levels.size() == axis.count) {
                fail(fmt::format("{} has {} of {} levels", name, axis.levels.size(), axis.count),
                     fmt::format("{} numbers", axis.count));
            }
            axis.levels.push_back(*value);
        }
        if (axis.levels.size() == axis.count) return;
        if (++line_ >= lines_.size()) {
            fail(fmt::format("{} has {} of {} levels", name, axis.levels.size(), axis.count),
                 fmt::format("{} numbers", axis.count));
        }
        rest = splitWords(lines_[line_]);
    }
}

void Parser::parseTimes(const Words& words) {
    const std::size_t times = count(words, kMaxTimes, "tdef");
    if (words.size() < 5 || toLower(words[2]) != "linear") {
        fail("tdef is incomplete", "tdef <number> linear <start> <step>");
    }
    ctl_.t = parseTimeAxis(times, words[3], words[4]);
}

void Parser::parseOptions(const Words& words) {
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string option = toLower(words[i]);
        if (option == "template") {
            ctl_.isTemplate = true;
        } else if (option == "sequential") {
            ctl_.sequential = true;
        } else if (option == "yrev") {
            ctl_.yrev = true;
        } else if (option == "zrev") {
            ctl_.zrev = true;
        } else if (option == "byteswapped") {
            ctl_.byteOrder = ByteOrder::other;
        } else if (option == "big_endian") {
            ctl_.byteOrder = ByteOrder::big;
        } else if (option == "little_endian") {
            ctl_.byteOrder = ByteOrder::little;
        } else if (option != "pascals") {
            fail(fmt::format("option {} is not supported", inQuotes(option)),
                 "template, sequential, yrev, zrev, byteswapped, big_endian, little_endian");
        }
    }
}

CtlVariable Parser::parseVariable(std::string_view line) const {
    const Words words = splitWords(line);
    if (words.size() < 3) {
        fail("a variable is incomplete", "name, levels, units, description",
             "the number after vars is the number of lines up to endvars");
    }
    CtlVariable variable;
    variable.name = words[0].substr(0, words[0].find("=>"));
    if (variable.name.empty()) fail("a variable has no name", "name, levels, units, description");
    const auto levels = parseInteger(words[1].substr(0, words[1].find(',')));
    if (!levels || *levels < 0 || static_cast<std::uint64_t>(*levels) > kMaxCells) {
        fail(fmt::format("variable {} needs a number of levels", variable.name),
             "0 for a single plane, or 1 or more");
    }
    variable.levels = static_cast<std::size_t>(*levels);
    if (words[2].starts_with("-1")) {
        fail(fmt::format("variable {} has a storage layout that is not supported", variable.name),
             "units 99: floats, plane by plane");
    }
    // The rest of the line is the description, by convention with the unit in brackets at its end.
    const char* afterUnits = words[2].data() + words[2].size();
    std::string_view text =
        trimmed(line.substr(static_cast<std::size_t>(afterUnits - line.data())));
    for (const auto& [open, close] : {std::pair{'(', ')'}, std::pair{'[', ']'}}) {
        const std::size_t start = text.rfind(open);
        if (start == std::string_view::npos || !text.ends_with(close)) continue;
        variable.unit = trimmed(text.substr(start + 1, text.size() - start - 2));
        text = trimmed(text.substr(0, start));
        break;
    }
    variable.description = text;
    return variable;
}

void Parser::parseVariables(const Words& words) {
    const std::size_t number = count(words, kMaxVariables, "vars");
    while (++line_ < lines_.size()) {
        const std::string_view line = trimmed(lines_[line_]);
        if (toLower(line).starts_with("endvars")) break;
        if (line.empty() || line.starts_with('*') || line.starts_with('@')) continue;
        ctl_.variables.push_back(parseVariable(line));
    }
    if (line_ >= lines_.size()) fail("endvars is missing", "endvars after the last variable");
    if (ctl_.variables.size() != number) {
        fail(fmt::format("vars states {} variables, but {} are listed", number,
                         ctl_.variables.size()),
             "the same number");
    }
}

/// Finds "units of x,y,z are km", which CM1 writes into the title. GrADS itself has no such entry.
void Parser::parseUnits(std::string_view line) {
    constexpr std::string_view kPhrase = "units of x,y,z are ";
    const std::string text = toLower(line);
    const std::size_t start = text.find(kPhrase);
    if (start == std::string::npos) return;
    const std::size_t from = start + kPhrase.size();
    const std::string unit =
        text.substr(from, text.find_first_not_of("abcdefghijklmnopqrstuvwxyz", from) - from);
    if (unit == "km" || unit == "kilometers" || unit == "kilometres") {
        ctl_.metresPerUnit = 1000.0;
    } else if (unit == "m" || unit == "meters" || unit == "metres") {
        ctl_.metresPerUnit = 1.0;
    } else {
        fail("the unit of x, y, z is not known", "km or m");
    }
}

std::string Parser::adviceOn(std::string_view keyword) const {
    const bool wrf = std::ranges::any_of(
        lines_, [](std::string_view line) { return line.find("WRF") != std::string_view::npos; });
    if (wrf) return kOpenWrfout;
    if (keyword == "dtype") {
        return "its data file has a format of its own: open a NetCDF file itself, and convert GRIB "
               "to a brick (docs/raw-les.md)";
    }
    if (keyword == "pdef") {
        return "its grid is given in degrees: describe the numbers with a nephoscope-brick "
               "sidecar, "
               "which has spacings in metres (docs/raw-les.md)";
    }
    return "write the fields again without it, or describe them with a nephoscope-brick sidecar "
           "(docs/raw-les.md)";
}

void Parser::parseLine(const std::string& keyword, std::string_view line, const Words& words) {
    // Entries that change how data are laid out: ignoring one would give wrong values.
    constexpr std::array<std::string_view, 14> kUnsupported{
        "dtype", "index",  "pdef",        "edef",         "fileheader", "xyheader", "theader",
        "chsub", "unpack", "headerbytes", "trailerbytes", "stnmap",     "xvar",     "yvar"};
    if (keyword == "dset") {
        ctl_.dset = trimmed(line.substr(std::min<std::size_t>(5, line.size())));
    } else if (keyword == "title") {
        ctl_.title = trimmed(line.substr(std::min<std::size_t>(6, line.size())));
    } else if (keyword == "undef") {
        const auto value = words.size() > 1 ? parseNumber(words[1]) : std::nullopt;
        if (!value) fail("undef needs a number", "undef -999999.9");
        ctl_.undef = *value;
    } else if (keyword == "options") {
        parseOptions(words);
    } else if (keyword == "xdef") {
        parseAxis(ctl_.x, "xdef", words);
    } else if (keyword == "ydef") {
        parseAxis(ctl_.y, "ydef", words);
    } else if (keyword == "zdef") {
        parseAxis(ctl_.z, "zdef", words);
    } else if (keyword == "tdef") {
        parseTimes(words);
    } else if (keyword == "vars") {
        parseVariables(words);
    } else if (std::ranges::find(kUnsupported, keyword) != kUnsupported.end()) {
        fail(fmt::format("{} is not supported", keyword),
             "plain binary data on an even or stretched grid in metres", adviceOn(keyword));
    } else if (keyword != "cachesize" && keyword != "vectorpairs" && keyword != "zvar" &&
               keyword != "endvars") {
        fail("is not a line of a GrADS descriptor", "dset, title, undef, options, xdef …",
             "comments start with *");
    }
}

void Parser::requireComplete() const {
    const auto missing = [](const char* name) {
        throw Error{fmt::format("{} is missing", name),
                    {},
                    "dset, xdef, ydef, zdef, tdef and vars",
                    "check that the descriptor is complete"};
    };
    if (ctl_.dset.empty()) missing("dset");
    if (ctl_.x.count == 0) missing("xdef");
    if (ctl_.y.count == 0) missing("ydef");
    if (ctl_.z.count == 0) missing("zdef");
    if (ctl_.t.count == 0) missing("tdef");
    if (ctl_.variables.empty()) missing("vars");
    for (const CtlVariable& variable : ctl_.variables) {
        if (variable.levels <= ctl_.z.count) continue;
        throw Error{fmt::format("variable {} has more levels than zdef", variable.name),
                    fmt::format("{}", variable.levels),
                    fmt::format("at most {}", ctl_.z.count),
                    {}};
    }
}

Ctl Parser::parse() {
    for (; line_ < lines_.size(); ++line_) {
        const std::string_view line = trimmed(lines_[line_]);
        parseUnits(line);
        if (line.empty() || line.starts_with('*') || line.starts_with('@')) continue;
        const Words words = splitWords(line);
        parseLine(toLower(words[0]), line, words);
    }
    requireComplete();
    return std::move(ctl_);
}

}  // namespace

bool isSwapped(ByteOrder order) {
    if (order == ByteOrder::other) return true;
    if (order == ByteOrder::unstated) return false;
    return (order == ByteOrder::big) != (std::endian::native == std::endian::big);
}

std::uint64_t Ctl::planes() const {
    std::uint64_t sum = 0;
    for (const CtlVariable& variable : variables) sum += variable.planes();
    return sum;
}

Ctl parseCtl(std::string_view text) {
    if (text.empty()) throw Error{"is empty", {}, "a GrADS descriptor", {}};
    return Parser(text).parse();
}

bool looksLikeCtl(std::string_view text) {
    bool dset = false;
    for (const std::string_view line : splitLines(text)) {
        const std::string start = toLower(trimmed(line).substr(0, 5));
        if (start.starts_with("dset ") || start == "dset\t") dset = true;
        if (dset && (start.starts_with("xdef ") || start == "xdef\t")) return true;
    }
    return false;
}

}  // namespace les
