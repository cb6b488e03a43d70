// hostile_lies.cpp: descriptions and reads that are valid except for one lie.
#include <sys/mman.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <thread>

#include "tests/readers/hostile/hostile.h"

namespace hostile {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

template <typename T>
NephHeader header() {
    return {NEPH_READER_ABI_VERSION, sizeof(T)};
}

/// What a read should return: heights for variable 1, otherwise the index of the cell.
float validValue(const NephReadRequest& request, std::int32_t x, std::int32_t y, std::int32_t z) {
    if (request.variable == 1) return 100.0f * static_cast<float>(z);
    return static_cast<float>(x + 4 * (y + 4 * z));
}

void fill(NephReadRequest& request) {
    float* to = request.values;
    for (std::int32_t z = request.lower[2]; z < request.upper[2]; ++z) {
        for (std::int32_t y = request.lower[1]; y < request.upper[1]; ++y) {
            for (std::int32_t x = request.lower[0]; x < request.upper[0]; ++x) {
                *to++ = validValue(request, x, y, z);
            }
        }
    }
    request.values_written = request.value_count;
}

}  // namespace

const char* unterminatedText() {
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    auto* text = static_cast<char*>(
        mmap(nullptr, 2 * page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
    std::memset(text, 'x', page);
    mprotect(text + page, page, PROT_NONE);
    return text;
}

void FalseDescription::setValid() {
    time_ = {header<NephTime>(), "noon", 0.0, {}};
    variable_ = {header<NephVariable>(), "q",       "", "kg kg-1", "", NEPH_ROLE_MIXING_RATIO,
                 NEPH_SPECIES_CLOUD,     {4, 4, 4}, ""};
    heights_ = {header<NephVariable>(), "h",       "", "m", "", NEPH_ROLE_INTERFACE_HEIGHT,
                NEPH_SPECIES_NONE,      {1, 1, 5}, ""};
    attribute_ = {header<NephAttribute>(), "name", "value"};
    times_ = {&time_};
    variables_ = {&variable_, &heights_};
    attributes_ = {&attribute_};
    notes_ = {"a note"};
    NephDescription& d = description_;
    d = {};
    d.header = header<NephDescription>();
    d.model = "Hostile 1";
    d.scheme = "";
    d.size[0] = d.size[1] = d.size[2] = 4;
    d.spacing_m[0] = d.spacing_m[1] = 100.0;
    d.time_count = 1;
    d.times = times_.data();
    d.variable_count = 2;
    d.variables = variables_.data();
    d.note_count = 1;
    d.notes = notes_.data();
    d.attribute_count = 1;
    d.attributes = attributes_.data();
}

void FalseDescription::falsifyGrid(const std::string& lie, int callNumber) {
    NephDescription& d = description_;
    if (lie == "nanSpacing") d.spacing_m[0] = kNan;
    if (lie == "infiniteSpacing") d.spacing_m[1] = std::numeric_limits<double>::infinity();
    if (lie == "nanDroplets") d.cloud_droplets_per_m3 = kNan;
    if (lie == "nanTime") time_.seconds = kNan;
    if (lie == "negativeSize") d.size[1] = -4;
    if (lie == "noSize") d.size[2] = 0;
    if (lie == "hugeSize") d.size[0] = d.size[1] = d.size[2] = 2'000'000'000;
    if (lie == "negativeVariable") variable_.size[0] = -1;
    if (lie == "otherGrid") variable_.size[0] = 3;
    if (lie == "changing" && callNumber > 1) d.size[0] = d.size[1] = 1000 * callNumber;
    if (lie == "strangeRole") variable_.role = heights_.species = 12345;
    if (lie == "strangeScheme") d.microphysics = -7;
}

void FalseDescription::falsifyLists(const std::string& lie) {
    NephDescription& d = description_;
    if (lie == "noTimes") d.time_count = 0;
    if (lie == "manyTimes") d.time_count = 4'000'000'000U;
    if (lie == "nullTimes") d.times = nullptr;
    if (lie == "nullTime") times_[0] = nullptr;
    if (lie == "manyVariables") d.variable_count = 900'000;
    if (lie == "wildVariable") variables_[0] = reinterpret_cast<const NephVariable*>(&d + 4096);
    if (lie == "twice") variables_[1] = &variable_;
    if (lie == "nullName") variable_.name = nullptr;
    if (lie == "endlessName") variable_.name = unterminatedText();
    if (lie == "endlessNote") notes_[0] = unterminatedText();
    if (lie == "nullTexts") {
        d.model = d.scheme = time_.label = variable_.units = variable_.standard_name =
            variable_.description = attribute_.value = attribute_.name = notes_[0] = nullptr;
    }
    if (lie == "oldAbi") variable_.header.abi_version = 0;
    if (lie == "smallStruct") d.header.struct_size = 4;
}

const NephDescription* FalseDescription::describe(const std::string& lie, int callNumber) {
    setValid();
    falsifyGrid(lie, callNumber);
    falsifyLists(lie);
    return &description_;
}

NephStatus read(const std::string& lie, NephReadRequest& request) {
    const std::uint64_t count = request.value_count;
    if (lie == "nothing") {
        request.values_written = count;
        return NEPH_OK;
    }
    if (lie == "spinAndTick") {
        for (int i = 0;; ++i) request.progress(request.progress_context, kNan);
    }
    if (lie == "sleepAndTick") {
        while (request.progress(request.progress_context, 0.5) != 0) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        return NEPH_CANCELLED;
    }
    fill(request);
    if (lie == "short") request.values_written = count - 1;
    if (lie == "long") request.values_written = count + 1;
    if (lie == "uncounted") request.values_written = 0;
    if (lie == "beyond") request.values[count] = 1.0f;
    if (lie == "farBeyond") {
        for (std::size_t i = 0; i < (std::size_t{1} << 40U); ++i) request.values[count + i] = 1.0f;
    }
    if (lie == "before") request.values[-1] = 1.0f;
    if (lie == "wayBefore") std::memset(request.values - 1024, 0xff, 4096);
    if (lie == "cancelled") return NEPH_CANCELLED;
    if (lie == "failed") return NEPH_FAILED;
    if (lie == "badStatus") return -5;
    return NEPH_OK;
}

}  // namespace hostile
