// grads_data.cpp: finds the data files, verifies their sizes, and determines the times they hold.
#include "readers/raw_les/grads_data.h"

#include <fmt/format.h>

#include <numeric>

namespace raw {
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
    plane_.swapped = isSwapped(ctl.byteOrder);
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
    if (ctl.sequential) checkFirstRecord(fieldAt(0, 0));
}

RawField GradsData::fieldAt(std::size_t i, std::uint64_t firstPlane) const {
    RawField field = plane_;
    field.path = dataPath(ctl_, folder_, times[i]);
    field.firstByte = firstPlane * plane_.planeStride();
    if (!ctl_.isTemplate) field.firstByte += times[i] * timeBytes_;
    return field;
}

/// All times in one file. A running model may have written more complete times than its descriptor
/// states yet; those are ignored with a note.
void GradsData::findOne() {
    const std::string path = dataPath(ctl_, folder_, 0);
    const auto found = fileSize(path);
    if (!found) failMissing();
    const std::uint64_t held = *found / timeBytes_;
    if (*found % timeBytes_ != 0 || held <= ctl_.t.count) {
        requireSize(path, *found, ctl_.t.count);
    } else {
        notes.push_back(
            fmt::format("{} contains {} times, but its descriptor states {}: the others are left "
                        "out.",
                        fs::path(path).filename().string(), held, ctl_.t.count));
    }
    times.resize(ctl_.t.count);
    std::iota(times.begin(), times.end(), std::size_t{0});
}

/// One file per time. Times without a file are left out with a note.
void GradsData::findSeries() {
    std::vector<std::string> missing;
    for (std::size_t i = 0; i < ctl_.t.count; ++i) {
        const std::string path = dataPath(ctl_, folder_, i);
        const auto found = fileSize(path);
        if (found) {
            requireSize(path, *found, 1);
            times.push_back(i);
        } else if (missing.size() < kMaxNamed) {
            missing.push_back(fs::path(path).filename().string());
        }
    }
    if (times.empty()) failMissing();
    if (missing.empty()) return;
    notes.push_back(
        fmt::format("{} of {} times are left out, because their files are missing: {}{}.",
                    ctl_.t.count - times.size(), ctl_.t.count, joined(missing),
                    ctl_.t.count - times.size() > missing.size() ? " …" : ""));
}

void GradsData::requireSize(const std::string& path, std::uint64_t found,
                            std::uint64_t count) const {
    std::uint64_t expected = 0;
    const bool overflow = __builtin_mul_overflow(timeBytes_, count, &expected);
    if (!overflow && found == expected) return;
    if (const auto name = tile()) failWithTile(*name);
    const bool longer = !overflow && found > expected;
    throw Error{
        fmt::format("is {} than its descriptor states", longer ? "longer" : "shorter"),
        fmt::format("{} bytes", found),
        fmt::format("{} bytes: {} time(s), {} planes of {} x {} floats{}",
                    overflow ? "far more" : fmt::format("{}", expected), count, ctl_.planes(),
                    ctl_.x.count, ctl_.y.count, ctl_.sequential ? " with record lengths" : ""),
        longer ? "the file may still be being written, or the .ctl may belong to another run"
               : "the run or the copy that wrote this file was interrupted, or the .ctl belongs to "
                 "another run",
        path};
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

void GradsData::failWithTile(const std::string& name) const {
    throw Error{"the run wrote one file per MPI rank, and such tiles cannot be read", name,
                fs::path(dataPath(ctl_, folder_, 0)).filename().string() + ", the whole grid",
                "join the tiles first, or run CM1 with output_filetype 1 or 2"};
}

void GradsData::failMissing() const {
    if (const auto name = tile()) failWithTile(*name);
    throw Error{"its data file is missing",
                {},
                dataPath(ctl_, folder_, 0),
                "keep the descriptor in the folder of its data; dset ^name is relative to it"};
}

}  // namespace raw
