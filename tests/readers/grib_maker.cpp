// grib_maker.cpp: from ecCodes' sample of GRIB2, key by key.
#include "tests/readers/grib_maker.h"

#include <eccodes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>

#include "tests/readers/grib_packer_maker.h"

namespace {

void require(int code, const std::string& doing) {
    if (code != 0) throw std::runtime_error(doing + ": " + codes_get_error_message(code));
}

struct Delete {
    void operator()(codes_handle* handle) const { codes_handle_delete(handle); }
};
using Handle = std::unique_ptr<codes_handle, Delete>;

void put(const Handle& handle, const char* key, long value) {
    require(codes_set_long(handle.get(), key, value), key);
}

void put(const Handle& handle, const char* key, double value) {
    require(codes_set_double(handle.get(), key, value), key);
}

void put(const Handle& handle, const char* key, const std::string& value) {
    std::size_t length = value.size();
    require(codes_set_string(handle.get(), key, value.c_str(), &length), key);
}

/// Discipline, category and number of WMO's tables 4.2-0-0, 4.2-0-1, 4.2-0-2, 4.2-0-3, 4.2-0-6.
const std::map<std::string, std::array<long, 3>> kParameters{
    {"HGT", {0, 3, 5}},   {"PRES", {0, 3, 0}},    {"TMP", {0, 0, 0}},     {"SPFH", {0, 1, 0}},
    {"RH", {0, 1, 1}},    {"DPT", {0, 0, 6}},     {"CLMR", {0, 1, 22}},   {"CIMIXR", {0, 1, 82}},
    {"ICMR", {0, 1, 23}}, {"RWMR", {0, 1, 24}},   {"SNMR", {0, 1, 25}},   {"GRLE", {0, 1, 32}},
    {"CLWC", {0, 1, 83}}, {"NCONCD", {0, 6, 28}}, {"NCCICE", {0, 6, 29}}, {"SPNCR", {0, 1, 100}},
    {"UGRD", {0, 2, 2}},  {"DZDT", {0, 2, 9}},    {"POT", {0, 0, 2}}};

void putAngles(const Handle& handle, const GribSpec& spec) {
    const bool degrees = spec.grid == "regular_ll" || spec.grid == "rotated_ll";
    const double step = 0.03;
    const double south = degrees ? 35.0 : 38.5, west = degrees ? 262.0 : 262.5;
    if (degrees) {
        const double north = south + step * (spec.ny - 1), east = west + step * (spec.nx - 1);
        // The rotated equator runs through the middle of the domain.
        const double up = spec.grid == "rotated_ll" ? south : 0.0;
        const double across = spec.grid == "rotated_ll" ? west : 0.0;
        put(handle, "latitudeOfFirstGridPointInDegrees", (spec.northward ? south : north) - up);
        put(handle, "latitudeOfLastGridPointInDegrees", (spec.northward ? north : south) - up);
        put(handle, "longitudeOfFirstGridPointInDegrees", (spec.westward ? east : west) - across);
        put(handle, "longitudeOfLastGridPointInDegrees", (spec.westward ? west : east) - across);
        put(handle, "iDirectionIncrementInDegrees", step);
        put(handle, "jDirectionIncrementInDegrees", step);
        if (spec.grid == "rotated_ll") {
            put(handle, "latitudeOfSouthernPoleInDegrees", south - 90.0);
            put(handle, "longitudeOfSouthernPoleInDegrees", west);
            put(handle, "angleOfRotationInDegrees", 0.0);
        }
        return;
    }
    put(handle, "latitudeOfFirstGridPointInDegrees", 36.0);
    put(handle, "longitudeOfFirstGridPointInDegrees", 260.0);
    put(handle, "LaDInDegrees", south);
    if (spec.grid == "mercator") {
        put(handle, "DiInMetres", 3000.0);
        put(handle, "DjInMetres", 3000.0);
        put(handle, "latitudeOfLastGridPointInDegrees", 37.0);
        put(handle, "longitudeOfLastGridPointInDegrees", 261.0);
        return;
    }
    put(handle, spec.grid == "lambert" ? "LoVInDegrees" : "orientationOfTheGridInDegrees", west);
    put(handle, "DxInMetres", 3000.0);
    put(handle, "DyInMetres", 3000.0);
    if (spec.grid != "lambert") return;
    put(handle, "Latin1InDegrees", 38.5);
    put(handle, "Latin2InDegrees", 38.5);
}

/// A message with everything but the parameter, the level and values.
Handle frameOf(const GribSpec& spec) {
    Handle handle(codes_grib_handle_new_from_samples(nullptr, "GRIB2"));
    if (!handle) throw std::runtime_error("ecCodes has no sample GRIB2");
    put(handle, "tablesVersion", 28L);
    put(handle, "centre", static_cast<long>(spec.centre));
    put(handle, "generatingProcessIdentifier", static_cast<long>(spec.process));
    put(handle, "dataDate", 20210814L);
    put(handle, "dataTime", 1800L);
    put(handle, "gridType", spec.grid);
    put(handle, "shapeOfTheEarth", 6L);
    put(handle, "Ni", static_cast<long>(spec.nx));
    put(handle, "Nj", static_cast<long>(spec.ny));
    putAngles(handle, spec);
    put(handle, "iScansNegatively", spec.westward ? 1L : 0L);
    put(handle, "jScansPositively", spec.northward ? 1L : 0L);
    put(handle, "jPointsAreConsecutive", spec.alongY ? 1L : 0L);
    put(handle, "alternativeRowScanning", spec.alternating ? 1L : 0L);
    return handle;
}

std::size_t numberAt(const GribMessage& bytes, std::size_t at) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8U | bytes[at + i];
    return value;
}

/// Writes the total length into section 0.
void setLength(GribMessage& message) {
    for (std::size_t i = 0; i < 8; ++i) {
        message[8 + i] = static_cast<std::uint8_t>(message.size() >> (56 - 8 * i));
    }
}

class Maker {
  public:
    explicit Maker(const GribSpec& spec) : spec_(spec), frame_(frameOf(spec)) {
        for (const char* name :
             {"HGT", "PRES", "TMP", "SPFH", "CLMR", "CIMIXR", "RWMR", "SNMR", "GRLE"}) {
            if (spec.isobaric && name == std::string("PRES")) continue;
            fields_[name] = [name](int, int, int z, int) {
                return GribSpec::defaultValue(name, z);
            };
        }
        for (const auto& [name, function] : spec.fields) fields_[name] = function;
        for (const std::string& name : spec.omit) fields_.erase(name);
    }

    /// Calls `take` with every message.
    void make(const std::function<void(const GribMessage&)>& take) {
        for (std::size_t t = 0; t < spec_.hours.size(); ++t) {
            const int time = static_cast<int>(t);
            put(frame_, "forecastTime", static_cast<long>(spec_.hours[t]));
            put(frame_, "typeOfFirstFixedSurface", 1L);
            for (const auto& [name, function] : spec_.ground) add(name, function, 0, time);
            hand(take);
            for (int z = 0; z < spec_.nz; ++z) {
                setLevel(z);
                for (const auto& [name, function] : fields_) {
                    if (!spec_.lacks || !spec_.lacks(name, z, time)) add(name, function, z, time);
                }
                hand(take);
            }
        }
    }

  private:
    void setLevel(int z) {
        if (spec_.isobaric) {
            put(frame_, "typeOfFirstFixedSurface", 100L);
            put(frame_, "scaleFactorOfFirstFixedSurface", 0L);
            put(frame_, "scaledValueOfFirstFixedSurface", 100000L - 10000L * z);
            return;
        }
        put(frame_, "typeOfFirstFixedSurface", 105L);
        put(frame_, "scaleFactorOfFirstFixedSurface", 0L);
        put(frame_, "scaledValueOfFirstFixedSurface",
            static_cast<long>(spec_.downward ? spec_.nz - z : z + 1));
    }

    void add(const std::string& name, const GribFunction& function, int z, int t) {
        const auto& parameter = kParameters.at(name);
        put(frame_, "discipline", parameter[0]);
        put(frame_, "parameterCategory", parameter[1]);
        put(frame_, "parameterNumber", parameter[2]);
        std::vector<std::optional<double>> values;
        for (const auto& cell : gribOrder(spec_)) {
            const bool gap = spec_.missing && spec_.missing(name, cell[0], cell[1], z);
            values.push_back(gap ? std::optional<double>() : function(cell[0], cell[1], z, t));
        }
        messages_.push_back(packed(values));
    }

    /// A message of the frame with values, as ecCodes packs them or by packedComplex.
    GribMessage packed(const std::vector<std::optional<double>>& values) const {
        constexpr double kMissing = 9.999e20;
        const Handle handle(codes_handle_clone(frame_.get()));
        const bool complex = spec_.packing == "complex";
        std::vector<double> numbers;
        std::vector<std::optional<double>> present;
        for (const auto& value : values) {
            numbers.push_back(value.value_or(complex && spec_.marked > 0 ? 0.0 : kMissing));
            if (value || spec_.marked > 0) present.push_back(value);
        }
        if (std::ranges::find(numbers, kMissing) != numbers.end()) {
            put(handle, "bitmapPresent", 1L);
            put(handle, "missingValue", kMissing);
        }
        put(handle, "bitsPerValue", static_cast<long>(spec_.bits));
        const auto pack = [&] {
            require(codes_set_double_array(handle.get(), "values", numbers.data(), numbers.size()),
                    "values");
        };
        pack();
        // ecCodes packs fields of one value simply, and fails with others.
        const bool even = std::ranges::all_of(numbers, [&](double v) { return v == numbers[0]; });
        if (spec_.packing != "grid_simple" && !complex && !even) {
            put(handle, "packingType", spec_.packing);
            pack();
        }
        for (const auto& [key, value] : spec_.keys) put(handle, key.c_str(), value);
        const void* bytes = nullptr;
        std::size_t count = 0;
        require(codes_get_message(handle.get(), &bytes, &count), "message");
        const auto* from = static_cast<const std::uint8_t*>(bytes);
        GribMessage message(from, from + count);
        if (!complex) return message;
        return packedComplex(message, present, {spec_.order, spec_.marked, spec_.bits});
    }

    void hand(const std::function<void(const GribMessage&)>& take) {
        if (spec_.severalFields && !messages_.empty()) join();
        for (const GribMessage& message : messages_) take(message);
        messages_.clear();
    }

    /// Makes one message of all: sections 0 to 3 once, 4 to 7 of each.
    void join() {
        GribMessage joined;
        for (const GribMessage& one : messages_) {
            std::size_t at = 16;
            while (one[at + 4] < 4) at += numberAt(one, at);
            const auto from = one.begin() + static_cast<std::ptrdiff_t>(at);
            if (joined.empty()) joined.assign(one.begin(), from);
            joined.insert(joined.end(), from, one.end() - 4);
        }
        for (int i = 0; i < 4; ++i) joined.push_back('7');
        setLength(joined);
        messages_ = {std::move(joined)};
    }

    const GribSpec& spec_;
    Handle frame_;
    std::map<std::string, GribFunction> fields_;
    std::vector<GribMessage> messages_;  ///< of the level that is being made
};

}  // namespace

double GribSpec::defaultValue(const std::string& name, int z) {
    if (name == "HGT") return 50.0 + 100.0 * z;
    if (name == "PRES") return 5e4;
    if (name == "TMP") return 262.5;
    if (name == "SPFH") return 0.002;
    return 0.0;
}

std::vector<GribMessage> gribMessages(const GribSpec& spec) {
    std::vector<GribMessage> messages;
    Maker(spec).make([&](const GribMessage& message) { messages.push_back(message); });
    return messages;
}

void writeMessages(const std::filesystem::path& path, const std::vector<GribMessage>& messages) {
    std::ofstream out(path, std::ios::binary);
    for (const GribMessage& message : messages) {
        out.write(reinterpret_cast<const char*>(message.data()), std::ssize(message));
    }
}

void writeGrib(const std::filesystem::path& path, const GribSpec& spec) {
    std::ofstream out(path, std::ios::binary);
    Maker(spec).make([&](const GribMessage& message) {
        out.write(reinterpret_cast<const char*>(message.data()), std::ssize(message));
    });
}

GribPoints gribPoints(const std::filesystem::path& path, std::size_t index) {
    std::FILE* file = std::fopen(path.c_str(), "rb");
    if (file == nullptr) throw std::runtime_error("cannot open " + path.string());
    Handle handle;
    for (std::size_t i = 0; i <= index; ++i) {
        int code = 0;
        handle.reset(codes_handle_new_from_file(nullptr, file, PRODUCT_GRIB, &code));
        if (!handle) break;
    }
    std::fclose(file);
    if (!handle) throw std::runtime_error("there is no such message");
    GribPoints points;
    int code = 0;
    codes_iterator* at = codes_grib_iterator_new(handle.get(), 0, &code);
    require(code, "points");
    double latitude = 0.0, longitude = 0.0, value = 0.0;
    while (codes_grib_iterator_next(at, &latitude, &longitude, &value) != 0) {
        points.latitude.push_back(latitude);
        points.longitude.push_back(longitude);
    }
    codes_grib_iterator_delete(at);
    // The iterator turns the values of some scanning modes; these are as the message has them.
    std::size_t count = points.latitude.size();
    points.value.resize(count);
    require(codes_get_double_array(handle.get(), "values", points.value.data(), &count), "values");
    return points;
}

std::vector<std::array<int, 2>> gribOrder(const GribSpec& spec) {
    const int slow = spec.alongY ? spec.nx : spec.ny, fast = spec.alongY ? spec.ny : spec.nx;
    const bool slowFalls = spec.alongY ? spec.westward : !spec.northward;
    const bool fastFalls = spec.alongY ? !spec.northward : spec.westward;
    std::vector<std::array<int, 2>> cells;
    for (int line = 0; line < slow; ++line) {
        const bool turned = fastFalls != (spec.alternating && line % 2 == 1);
        const int s = slowFalls ? slow - 1 - line : line;
        for (int i = 0; i < fast; ++i) {
            const int f = turned ? fast - 1 - i : i;
            cells.push_back(spec.alongY ? std::array{s, f} : std::array{f, s});
        }
    }
    return cells;
}

void referToBitmap(GribMessage& message, std::size_t field) {
    std::size_t seen = 0;
    for (std::size_t at = 16; at + 5 < message.size(); at += numberAt(message, at)) {
        if (message[at + 4] != 6 || seen++ != field) continue;
        const std::array<std::uint8_t, 6> section{0, 0, 0, 6, 6, 254};
        const auto from = message.begin() + static_cast<std::ptrdiff_t>(at);
        message.erase(from, from + static_cast<std::ptrdiff_t>(numberAt(message, at)));
        message.insert(message.begin() + static_cast<std::ptrdiff_t>(at), section.begin(),
                       section.end());
        break;
    }
    setLength(message);
}

void writeGribSample(const std::filesystem::path& path, const char* name) {
    const Handle handle(codes_grib_handle_new_from_samples(nullptr, name));
    if (!handle) throw std::runtime_error(std::string("ecCodes has no sample ") + name);
    const void* bytes = nullptr;
    std::size_t count = 0;
    require(codes_get_message(handle.get(), &bytes, &count), name);
    const auto* from = static_cast<const std::uint8_t*>(bytes);
    writeMessages(path, {GribMessage(from, from + count)});
}
