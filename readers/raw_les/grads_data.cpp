// grads_data.cpp: finds the data files, verifies their sizes, and determines the times they hold.
#include "readers/raw_les/grads_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace les {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxNamed = 8;  // missing files that a note lists by name

/// Whether one MPI rank wrote `name` as its part of `whole`: cm1out_000003_s.dat is a tile of
/// cm1out_s.dat.
bool isTileOf(std::string_view name, std::string_view whole) {
    const std::size_t cut = whole.find('_');
    if (cut == std::string_view::npos || !name.starts_with(whole.substr(0, cut + 1))) return false;
    const std::string_view rest = name.substr(cut + 1);
    const std::size_t digits = rest.find_first_not_of("0123456789");
    return digits != std::string_view::npos && digits > 0 && rest[digits] == '_' &&
           rest.substr(digits + 1) == whole.substr(cut + 1);
}

}  // namespace

std::string dataPath(const Ctl& ctl, const fs::path& folder, std::size_t time) {
    std::string name = ctl.dset;
    if (ctl.isTemplate) name = expandTemplate(name, ctl.t, time);
    if (name.starts_with('^')) name.erase(0, 1);
    return (folder / name).string();  // operator/ leaves an absolute name unchanged
}

GradsData::GradsData(const Ctl& ctl, const fs::path& folder) : ctl_(ctl), folder_(folder) {
    plane_.size = {ctl.x.count, ctl.y.count, 1};
    plane_.swapped = les::isSwapped(ctl.byteOrder);
    plane_.records = ctl.sequential;
    plane_.missing = ctl.undef;
    if (__builtin_mul_overflow(ctl.planes(), plane_.planeStride(), &timeBytes_)) {
        throw Error{"describes more data than any disk holds",
                    fmt::format("{} planes of {} x {}", ctl.planes(), ctl.x.count, ctl.y.count),
                    {},
                    {}};
    }
    if (ctl.isTemplate) {
        findSeries();
    } else {
        findOne();
    }
    if (ctl.sequential) settleRecords();
}

/// Record lengths show the byte order, which a descriptor may leave open.
void GradsData::settleRecords() {
    const RawField first = fieldAt(0, 0);
    const auto length = firstRecordOf(first.path, first.planeBytes());
    if (length && length->swapped != plane_.swapped && ctl_.byteOrder == ByteOrder::unstated) {
        swap();
        notes.emplace_back(
            "The descriptor does not state the byte order; the record lengths show that it is not "
            "this machine's.");
    }
    checkFirstRecord(fieldAt(0, 0));
}

RawField GradsData::fieldAt(std::size_t i, std::uint64_t firstPlane) const {
    RawField field = plane_;
    field.path = dataPath(ctl_, folder_, times[i]);
    field.firstByte = firstPlane * plane_.planeStride();
    if (!ctl_.isTemplate) field.firstByte += times[i] * timeBytes_;
    return field;
}

std::vector<std::string> GradsData::paths() const {
    std::vector<std::string> found;
    for (const std::size_t time : times) {
        found.push_back(dataPath(ctl_, folder_, time));
        if (!ctl_.isTemplate) break;
    }
    return found;
}

/// All times in one file. A running model may have written more complete times than its descriptor
/// states yet; those are ignored with a note.
void GradsData::findOne() {
    const std::string path = dataPath(ctl_, folder_, 0);
    const auto found = fileSize(path);
    if (!found) failMissing();
    if (auto error = certainError(path, *found, ctl_.t.count)) throw *error;
    const std::string name = fs::path(path).filename().string();
    const std::uint64_t held = *found / timeBytes_;
    const bool whole = *found % timeBytes_ == 0;
    const bool all = held >= ctl_.t.count;
    if (held == 0) throw sizeError(path, *found, ctl_.t.count);
    times.resize(static_cast<std::size_t>(std::min<std::uint64_t>(held, ctl_.t.count)));
    std::iota(times.begin(), times.end(), std::size_t{0});
    if (!whole || !all) sizeFault = sizeError(path, *found, ctl_.t.count);
    if (!all) {
        notes.push_back(
            fmt::format("{} ends {} time {} of {}{}: only the times before it are read.", name,
                        whole ? "before" : "within", held + 1, ctl_.t.count,
                        changedLately(path) ? ", because it is being written" : ""));
    } else if (*found > times.size() * timeBytes_) {
        notes.push_back(
            fmt::format("{} contains {} times, but its descriptor states {}: the others are left "
                        "out.",
                        name, whole ? fmt::format("{}", held) : fmt::format("more than {}", held),
                        ctl_.t.count));
    }
}

/// One file per time. Times without a file, and those whose file is not whole while others are, are
/// left out with a note.
void GradsData::findSeries() {
    std::vector<std::string> missing, broken;
    std::optional<Error> fault;
    for (std::size_t i = 0; i < ctl_.t.count; ++i) {
        const std::string path = dataPath(ctl_, folder_, i);
        const std::string name = fs::path(path).filename().string();
        const auto found = fileSize(path);
        if (found == timeBytes_) {
            times.push_back(i);
        } else if (!found) {
            if (missing.size() < kMaxNamed) missing.push_back(name);
        } else {
            if (!fault) fault = sizeError(path, *found, 1);
            if (broken.size() < kMaxNamed) {
                broken.push_back(name + (changedLately(path) ? " (being written)" : ""));
            }
        }
    }
    if (times.empty() && fault) throw *fault;
    if (times.empty()) failMissing();
    const std::size_t lost = ctl_.t.count - times.size();
    const auto note = [&](const std::vector<std::string>& names, const char* why) {
        if (names.empty()) return;
        notes.push_back(fmt::format("{} of {} times are left out, because {}: {}{}.", lost,
                                    ctl_.t.count, why, joined(names),
                                    lost > missing.size() + broken.size() ? " …" : ""));
    };
    if (missing.empty() != broken.empty()) {
        note(missing, "their files are missing");
        note(broken, "their files have another size than the descriptor states");
    } else {
        missing.insert(missing.end(), broken.begin(), broken.end());
        note(missing, "their files are missing or have another size");
    }
}

Error GradsData::sizeError(const std::string& path, std::uint64_t found,
                           std::uint64_t count) const {
    if (auto error = certainError(path, found, count)) return *error;
    std::uint64_t expected = 0;
    const bool overflow = __builtin_mul_overflow(timeBytes_, count, &expected);
    const bool longer = !overflow && found > expected;
    Error error{
        fmt::format("is {} than its descriptor states", longer ? "longer" : "shorter"),
        fmt::format("{} bytes", found),
        fmt::format("{} bytes: {} time(s), {} planes of {} x {} floats{}",
                    overflow ? "far more" : fmt::format("{}", expected), count, ctl_.planes(),
                    ctl_.x.count, ctl_.y.count, ctl_.sequential ? " with record lengths" : ""),
        longer ? "check that the .ctl belongs to this run: xdef, ydef, tdef and the list of "
                 "variables"
               : "the run or the copy that wrote this file was interrupted, or the .ctl belongs to "
                 "another run"};
    describeSize(path, error);
    return error;
}

std::optional<Error> GradsData::certainError(const std::string& path, std::uint64_t found,
                                             std::uint64_t count) const {
    if (found == timeBytes_ * count) return {};
    if (const auto name = tile()) return tileError(*name);
    const std::uint64_t plane = plane_.planeBytes();
    const std::uint64_t planes = ctl_.planes() * count;  // fits: timeBytes_ was computed
    if (ctl_.sequential && found == planes * plane) {
        return Error{"has no Fortran record lengths, which its descriptor states",
                     fmt::format("{} bytes, {} planes", found, planes),
                     fmt::format("{} bytes", planes * (plane + 8)),
                     "remove sequential from the options in the .ctl", path};
    }
    if (ctl_.sequential) return {};
    const std::uint64_t first = plane * ctl_.variables.front().planes();
    const auto length = firstRecordOf(path, plane);
    const bool swapped = length && length->swapped != plane_.swapped;
    if (found == planes * (plane + 8) && length) {
        return Error{"has Fortran record lengths, which its descriptor does not state",
                     fmt::format("{} bytes, {} planes", found, planes),
                     fmt::format("{} bytes", planes * plane),
                     fmt::format("add the line 'options sequential{}' to the .ctl",
                                 swapped ? " byteswapped" : ""),
                     path};
    }
    if (found == planes * plane + 8 * ctl_.variables.size() * count && firstRecordOf(path, first)) {
        return Error{"has one Fortran record for each variable",
                     fmt::format("{} bytes, the first record has {}", found, first),
                     fmt::format("{} bytes without records", planes * plane),
                     "write it with access='direct' or 'stream', or one record for each level with "
                     "options sequential",
                     path};
    }
    return {};
}

std::optional<std::string> GradsData::tile() const {
    std::error_code error;
    const std::string whole = fs::path(dataPath(ctl_, folder_, 0)).filename().string();
    for (const auto& entry : fs::directory_iterator(folder_, error)) {
        const std::string name = entry.path().filename().string();
        if (isTileOf(name, whole)) return name;
    }
    return {};
}

Error GradsData::tileError(const std::string& name) const {
    return {"the run wrote one file per MPI rank, and such tiles cannot be read", name,
            fs::path(dataPath(ctl_, folder_, 0)).filename().string() + ", the whole grid",
            "join the tiles first, or run CM1 with output_filetype 1 or 2"};
}

void GradsData::failMissing() const {
    if (const auto name = tile()) throw tileError(*name);
    throw Error{"its data file is missing",
                {},
                dataPath(ctl_, folder_, 0),
                "keep the descriptor in the folder of its data; dset ^name is relative to it"};
}

}  // namespace les
