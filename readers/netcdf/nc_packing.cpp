// nc_packing.cpp: the attributes that say how numbers are stored.
#include "readers/netcdf/nc_packing.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>

#include "readers/netcdf/nc_attributes.h"

namespace nc {
namespace {

// The library fills cells that were never written with NC_FILL_FLOAT, 9.97e36.
constexpr double kNothingWritten = 9.9e36;

/// An integer type: its range, and the number that stands for cells never written; bytes have none.
struct IntegerType {
    nc_type type;
    int bits;
    bool isSigned;
    std::optional<double> fill;
};
constexpr std::array kIntegers{
    IntegerType{NC_BYTE, 8, true, {}},
    IntegerType{NC_UBYTE, 8, false, {}},
    IntegerType{NC_SHORT, 16, true, NC_FILL_SHORT},
    IntegerType{NC_USHORT, 16, false, NC_FILL_USHORT},
    IntegerType{NC_INT, 32, true, NC_FILL_INT},
    IntegerType{NC_UINT, 32, false, NC_FILL_UINT},
    IntegerType{NC_INT64, 64, true, static_cast<double>(NC_FILL_INT64)},
    IntegerType{NC_UINT64, 64, false, static_cast<double>(NC_FILL_UINT64)},
};

const IntegerType* integerOf(nc_type type) {
    const auto found = std::ranges::find(kIntegers, type, &IntegerType::type);
    return found == kIntegers.end() ? nullptr : &*found;
}

/// The attribute _Unsigned, by which NetCDF-3 keeps unsigned numbers in signed types.
std::optional<bool> unsignedAttribute(int file, int variable) {
    auto text = textAttribute(file, variable, "_Unsigned");
    if (!text) return {};
    std::ranges::transform(*text, text->begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (*text == "true") return true;
    if (*text == "false") return false;
    return {};
}

/// Whether a number can be one of the type at all.
bool fits(double number, const IntegerType& type) {
    const double half = std::ldexp(1.0, type.bits - 1);
    return number == std::floor(number) && number >= -half && number < 2.0 * half;
}

}  // namespace

NcPacking::NcPacking(int file, int variable, nc_type type) {
    const IntegerType* integer = integerOf(type);
    const auto scale = numberAttribute(file, variable, "scale_factor");
    const auto offset = numberAttribute(file, variable, "add_offset");
    packed_ = scale || offset;
    scale_ = scale.value_or(1.0);
    offset_ = offset.value_or(0.0);
    if (const auto mark = unsignedAttribute(file, variable);
        integer != nullptr && mark && *mark == integer->isSigned) {
        wrap_ = std::ldexp(1.0, integer->bits);
        toSigned_ = !integer->isSigned;
    }
    for (const char* name : {"_FillValue", "missing_value"}) {
        for (const double number : numbersAttribute(file, variable, name)) {
            const bool real = integer != nullptr && isRealAttribute(file, variable, name);
            if (real && !fits(number, *integer)) {
                missingValues_.push_back(number);
            } else {
                missing_.push_back(wrapped(
                    type == NC_FLOAT ? static_cast<double>(static_cast<float>(number)) : number));
            }
        }
    }
    // Programs that pack use the whole range of the type, this number included.
    if (integer != nullptr && integer->fill && !packed_)
        missing_.push_back(wrapped(*integer->fill));
    least_ = -std::numeric_limits<double>::infinity();
    most_ = std::numeric_limits<double>::infinity();
    const auto limit = [&](const char* name, double& end, std::size_t count, std::size_t index) {
        const auto numbers = numbersAttribute(file, variable, name);
        if (numbers.size() != count || std::isnan(numbers[index])) return;
        limited_ = true;
        limitsValues_ = packed_ && integer != nullptr && isRealAttribute(file, variable, name);
        end = limitsValues_ ? numbers[index] : wrapped(numbers[index]);
    };
    limit("valid_min", least_, 1, 0);
    limit("valid_max", most_, 1, 0);
    limit("valid_range", least_, 2, 0);
    limit("valid_range", most_, 2, 1);
}

bool NcPacking::isMissing(double number, double value) const {
    if (std::ranges::find(missing_, number) != missing_.end()) return true;
    for (const double missing : missingValues_) {
        if (std::abs(value - missing) <= 1e-6 * std::abs(missing)) return true;
    }
    const double limited = limitsValues_ ? value : number;
    return limited_ && !(limited >= least_ && limited <= most_);
}

/// Numbers whose sign bit means something else than their type says.
double NcPacking::wrapped(double number) const {
    if (wrap_ > 0.0 && toSigned_ && number >= 0.5 * wrap_) return number - wrap_;
    if (wrap_ > 0.0 && !toSigned_ && number < 0.0) return number + wrap_;
    return number;
}

double NcPacking::valueOf(double stored) const {
    const double number = wrapped(stored);
    const double value = number * scale_ + offset_;
    const bool missing = std::abs(number) >= kNothingWritten || isMissing(number, value);
    return missing ? std::numeric_limits<double>::quiet_NaN() : value;
}

void NcPacking::unpack(std::span<double> values) const {
    for (double& value : values) value = valueOf(value);
}

void NcPacking::unpack(std::span<const double> stored, std::span<float> values) const {
    std::ranges::transform(stored, values.begin(),
                           [this](double number) { return static_cast<float>(valueOf(number)); });
}

void NcPacking::unpack(std::span<float> values) const {
    if (!packed_ && missing_.empty() && !limited_) {  // as models write them
        for (float& value : values) {
            if (std::abs(value) >= static_cast<float>(kNothingWritten)) {
                value = std::numeric_limits<float>::quiet_NaN();
            }
        }
        return;
    }
    for (float& value : values) {
        value = static_cast<float>(valueOf(static_cast<double>(value)));
    }
}

}  // namespace nc
