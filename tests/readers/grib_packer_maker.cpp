// grib_packer_maker.cpp: differences, groups, bits.
#include "tests/readers/grib_packer_maker.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace {

using Number = std::int64_t;
using Numbers = std::vector<std::optional<Number>>;

class BitWriter {
  public:
    void put(std::uint64_t value, int bits) {
        for (int i = bits - 1; i >= 0; --i) {
            if (used_ % 8 == 0) bytes_.push_back(0);
            const auto bit = static_cast<unsigned>(value >> static_cast<unsigned>(i) & 1U);
            bytes_.back() = static_cast<std::uint8_t>(bytes_.back() | bit << (7U - used_ % 8));
            ++used_;
        }
    }
    void putSigned(Number value, int bytes) {
        const auto magnitude = static_cast<std::uint64_t>(std::abs(value));
        put(value < 0 ? 1 : 0, 1);
        put(magnitude, 8 * bytes - 1);
    }
    void align() { used_ = 8 * static_cast<unsigned>(bytes_.size()); }
    GribMessage take() { return std::move(bytes_); }

  private:
    GribMessage bytes_;
    unsigned used_ = 0;
};

int bitsOf(std::uint64_t value) {
    return static_cast<int>(std::bit_width(value));
}

struct Group {
    std::uint64_t reference = 0;
    int width = 0;
    std::vector<std::optional<std::uint64_t>> numbers;
};

/// Differences of the given order of what is present, less their smallest; the first ones apart.
struct Differences {
    std::array<Number, 2> first{};
    Number least = 0;
    std::vector<std::optional<std::uint64_t>> rest;
};

Differences differencesOf(const Numbers& numbers, int order) {
    std::vector<Number> present;
    for (const auto& n : numbers) {
        if (n) present.push_back(*n);
    }
    std::vector<Number> steps = present;
    const auto count = static_cast<Number>(present.size());
    for (Number i = order; i < count; ++i) {
        const auto at = [&](Number back) { return present[static_cast<std::size_t>(i - back)]; };
        if (order == 1) steps[static_cast<std::size_t>(i)] = at(0) - at(1);
        if (order == 2) steps[static_cast<std::size_t>(i)] = at(0) - 2 * at(1) + at(2);
    }
    Differences d;
    const auto from = static_cast<std::ptrdiff_t>(std::min<Number>(order, count));
    for (std::ptrdiff_t i = 0; i < from; ++i) {
        d.first[static_cast<std::size_t>(i)] = present[static_cast<std::size_t>(i)];
        steps[static_cast<std::size_t>(i)] = 0;
    }
    if (from < count) d.least = *std::min_element(steps.begin() + from, steps.end());
    if (order == 0) d.least = 0;
    std::size_t i = 0;
    for (const auto& n : numbers) {
        if (!n) {
            d.rest.push_back({});
            continue;
        }
        const bool isFirst = i < static_cast<std::size_t>(from);
        d.rest.push_back(static_cast<std::uint64_t>(isFirst ? 0 : steps[i] - d.least));
        ++i;
    }
    return d;
}

/// Groups of 1 to 29 values, so that every length and many widths occur.
std::vector<Group> groupsOf(const std::vector<std::optional<std::uint64_t>>& values, int marks) {
    std::vector<Group> groups;
    for (std::size_t at = 0; at < values.size();) {
        const std::size_t length = std::min(1 + (7 * groups.size()) % 29, values.size() - at);
        Group group;
        group.numbers.assign(values.begin() + static_cast<std::ptrdiff_t>(at),
                             values.begin() + static_cast<std::ptrdiff_t>(at + length));
        at += length;
        bool gaps = false, any = false;
        std::uint64_t least = ~std::uint64_t{0}, most = 0;
        for (const auto& n : group.numbers) {
            gaps = gaps || !n;
            if (!n) continue;
            any = true;
            least = std::min(least, *n);
            most = std::max(most, *n);
        }
        group.reference = any ? least : ~std::uint64_t{0};
        // Numbers of all ones are marks where there are gaps, and so where there may be any.
        const auto reserved = static_cast<std::uint64_t>(marks > 0 ? marks : 0);
        const std::uint64_t range = any ? most - least : 0;
        group.width = any && (gaps || range > 0) ? bitsOf(range + reserved) : 0;
        groups.push_back(std::move(group));
    }
    return groups;
}

void putNumber(GribMessage& to, std::uint64_t value, int bytes) {
    for (int i = bytes - 1; i >= 0; --i) {
        to.push_back(static_cast<std::uint8_t>(value >> static_cast<unsigned>(8 * i)));
    }
}

GribMessage dataOf(const Differences& d, const std::vector<Group>& groups, int referenceBits,
                   const ComplexPacking& how, int extraBytes) {
    BitWriter out;
    if (how.order > 0) {
        for (int i = 0; i < how.order; ++i) {
            out.putSigned(d.first[static_cast<std::size_t>(i)], extraBytes);
        }
        out.putSigned(d.least, extraBytes);
    }
    const std::uint64_t ones = (std::uint64_t{1} << static_cast<unsigned>(referenceBits)) - 1;
    for (const Group& g : groups) out.put(std::min(g.reference, ones), referenceBits);
    out.align();
    for (const Group& g : groups) out.put(static_cast<std::uint64_t>(g.width), 6);
    out.align();
    for (const Group& g : groups) out.put(g.numbers.size() - 1, 5);
    out.align();
    for (const Group& g : groups) {
        const std::uint64_t mark = (std::uint64_t{1} << static_cast<unsigned>(g.width)) - 1;
        for (const auto& n : g.numbers) out.put(n ? *n - g.reference : mark, g.width);
    }
    return out.take();
}

GribMessage templateOf(const std::vector<Group>& groups, std::size_t values, float reference,
                       int scale, int referenceBits, const ComplexPacking& how, int extraBytes) {
    GribMessage body;
    putNumber(body, values, 4);
    putNumber(body, how.order > 0 ? 3 : 2, 2);
    putNumber(body, std::bit_cast<std::uint32_t>(reference), 4);
    putNumber(body, static_cast<std::uint64_t>(scale < 0 ? 0x8000 | -scale : scale), 2);
    putNumber(body, 0, 2);  // decimal scale
    putNumber(body, static_cast<std::uint64_t>(referenceBits), 1);
    putNumber(body, 0, 1);  // floating point
    putNumber(body, 1, 1);  // general group splitting
    putNumber(body, static_cast<std::uint64_t>(how.missing), 1);
    putNumber(body, std::bit_cast<std::uint32_t>(9.999e20f), 4);
    putNumber(body, how.missing == 2 ? std::bit_cast<std::uint32_t>(9.998e20f) : 0xffffffffU, 4);
    putNumber(body, groups.size(), 4);
    putNumber(body, 0, 1);  // reference of widths
    putNumber(body, 6, 1);
    putNumber(body, 1, 4);  // reference of lengths
    putNumber(body, 1, 1);
    putNumber(body, groups.back().numbers.size(), 4);
    putNumber(body, 5, 1);
    if (how.order == 0) return body;
    putNumber(body, static_cast<std::uint64_t>(how.order), 1);
    putNumber(body, static_cast<std::uint64_t>(extraBytes), 1);
    return body;
}

}  // namespace

GribMessage withSection(const GribMessage& message, int number,
                        std::span<const std::uint8_t> body) {
    GribMessage out(message.begin(), message.begin() + 16);
    for (std::size_t at = 16; at + 5 < message.size();) {
        const std::size_t length =
            std::size_t{message[at]} << 24U | std::size_t{message[at + 1]} << 16U |
            std::size_t{message[at + 2]} << 8U | std::size_t{message[at + 3]};
        const auto from = message.begin() + static_cast<std::ptrdiff_t>(at);
        if (message[at + 4] == number) {
            putNumber(out, body.size() + 5, 4);
            out.push_back(static_cast<std::uint8_t>(number));
            out.insert(out.end(), body.begin(), body.end());
        } else {
            out.insert(out.end(), from, from + static_cast<std::ptrdiff_t>(length));
        }
        at += length;
    }
    for (int i = 0; i < 4; ++i) out.push_back('7');
    GribMessage length;
    putNumber(length, out.size(), 8);
    std::ranges::copy(length, out.begin() + 8);
    return out;
}

GribMessage packedComplex(const GribMessage& simple, std::span<const std::optional<double>> values,
                          const ComplexPacking& how) {
    double least = 1e300, most = -1e300;
    for (const auto& value : values) {
        if (value) least = std::min(least, *value), most = std::max(most, *value);
    }
    if (least > most) least = most = 0.0;
    const auto reference = static_cast<float>(least);
    const double steps = std::pow(2.0, how.bits) - 1.0;
    const int scale =
        most > least ? static_cast<int>(std::ceil(std::log2((most - least) / steps))) : 0;
    Numbers numbers;
    for (const auto& value : values) {
        if (!value) {
            numbers.push_back({});
            continue;
        }
        const double number =
            std::round((*value - static_cast<double>(reference)) / std::pow(2.0, scale));
        numbers.push_back(static_cast<Number>(std::max(number, 0.0)));
    }
    const Differences d = differencesOf(numbers, how.order);
    const std::vector<Group> groups = groupsOf(d.rest, how.missing);
    std::uint64_t largest = 0;
    for (const Group& g : groups) {
        if (g.reference != ~std::uint64_t{0}) largest = std::max(largest, g.reference);
    }
    const int referenceBits = bitsOf(largest + static_cast<std::uint64_t>(how.missing));
    constexpr int kExtraBytes = 4;
    const GribMessage section =
        templateOf(groups, values.size(), reference, scale, referenceBits, how, kExtraBytes);
    return withSection(withSection(simple, 5, section), 7,
                       dataOf(d, groups, referenceBits, how, kExtraBytes));
}
