// packing.cpp: WMO No. 306, volume I.2, regulations 92.9.4 and 92.9.7 and the notes to the
// templates.
#include "readers/grib/packing.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>

namespace grib {
namespace {

constexpr std::size_t kLinesPerMark = 8;
constexpr std::size_t kSectionHead = 5;  // bytes of section 7 before its data
constexpr std::size_t kBitmapHead = 6;   // bytes of section 6 before its bits
constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();

[[noreturn]] void failShort(ByteSpan data, std::uint64_t bits) {
    throw Failure{"its packed data end early", fmt::format("{} bytes", data.size()),
                  fmt::format("at least {} bytes", (bits + 7) / 8),
                  "the message is damaged: download the file again"};
}

void requireBits(ByteSpan data, std::uint64_t end) {
    if (end > 8 * static_cast<std::uint64_t>(data.size())) failShort(data, end);
}

/// How many of the bits [from, from + count) are set.
std::size_t setBits(ByteSpan bytes, std::uint64_t from, std::size_t count) {
    std::size_t sum = 0;
    while (count > 0) {
        const auto take = static_cast<unsigned>(std::min<std::size_t>(count, 32));
        sum += static_cast<std::size_t>(std::popcount(bitsAt(bytes, from, take)));
        from += take;
        count -= take;
    }
    return sum;
}

unsigned widthAt(ByteSpan s, std::size_t at, const char* what) {
    const std::uint64_t bits = unsignedAt(s, at, 1);
    if (bits <= 32) return static_cast<unsigned>(bits);
    throw Failure{fmt::format("{} have an impossible width", what), fmt::format("{} bits", bits),
                  "at most 32", "the message is damaged: download the file again"};
}

}  // namespace

bool isUnpackedHere(unsigned form) {
    return form == 0 || form == 2 || form == 3;
}

std::string packingName(unsigned form) {
    const char* name = form == 0                  ? "simple"
                       : form == 2                ? "complex"
                       : form == 3                ? "complex with spatial differencing"
                       : form == 4                ? "IEEE numbers"
                       : form == 40               ? "JPEG 2000"
                       : form == 41               ? "PNG"
                       : form == 42               ? "CCSDS"
                       : form == 50 || form == 51 ? "spectral"
                       : form == 200              ? "run length"
                                                  : "unknown";
    return fmt::format("{} (template 5.{})", name, form);
}

Packing packingOf(ByteSpan s) {
    Packing p;
    p.values = unsignedAt(s, 5, 4);
    p.form = static_cast<unsigned>(unsignedAt(s, 9, 2));
    constexpr unsigned kJpeg = 40, kPng = 41, kCcsds = 42;
    if (p.form == kJpeg || p.form == kPng || p.form == kCcsds) {
        widthAt(s, 19, "packed numbers");  // ecCodes corrupts its memory with others
    }
    if (!isUnpackedHere(p.form)) return p;
    const double decimal = std::pow(10.0, static_cast<double>(-signedAt(s, 17, 2)));
    p.reference = realAt(s, 11) * decimal;
    p.scale = std::pow(2.0, static_cast<double>(signedAt(s, 15, 2))) * decimal;
    p.bits = widthAt(s, 19, "packed numbers");
    if (!std::isfinite(p.reference) || !std::isfinite(p.scale)) {
        throw Failure{"its scale is not a number",
                      fmt::format("reference {}, factor {}", p.reference, p.scale),
                      {},
                      "the message is damaged: download the file again"};
    }
    if (p.form == 0) return p;
    p.missing = static_cast<unsigned>(unsignedAt(s, 22, 1));
    if (p.missing > 2) p.missing = 0;  // 255: not stated, as in files without missing values
    p.groups = unsignedAt(s, 31, 4);
    p.widthBase = static_cast<unsigned>(unsignedAt(s, 35, 1));
    p.widthBits = widthAt(s, 36, "widths of groups");
    p.lengthBase = unsignedAt(s, 37, 4);
    p.lengthStep = static_cast<unsigned>(unsignedAt(s, 41, 1));
    p.lastLength = unsignedAt(s, 42, 4);
    p.lengthBits = widthAt(s, 46, "lengths of groups");
    if (p.groups > p.values) {
        throw Failure{"it has more groups than values",
                      fmt::format("{} groups, {} values", p.groups, p.values),
                      {},
                      "the message is damaged: download the file again"};
    }
    if (p.form == 2) return p;
    p.order = static_cast<unsigned>(unsignedAt(s, 47, 1));
    p.extraBytes = static_cast<unsigned>(unsignedAt(s, 48, 1));
    if (p.order > 2 || p.extraBytes > 8) {  // ecCodes writes order 0 for plain complex packing
        throw Failure{"its spatial differencing is not known",
                      fmt::format("order {}, {} bytes", p.order, p.extraBytes), "order 0 to 2",
                      "the message is damaged: download the file again"};
    }
    return p;
}

LineUnpacker::LineUnpacker(const Packing& packing, std::size_t lineLength, std::size_t lineCount)
    : packing_(packing), lineLength_(lineLength), lineCount_(lineCount) {
    marks_.push_back({});
}

LineUnpacker::Layout LineUnpacker::layoutOf(ByteSpan data) const {
    Layout layout;
    if (packing_.form == 0) return layout;
    std::size_t at = kSectionHead;
    if (packing_.order > 0 && packing_.extraBytes > 0) {
        for (unsigned i = 0; i < packing_.order; ++i, at += packing_.extraBytes) {
            layout.first[i] = signedAt(data, at, packing_.extraBytes);
        }
        layout.least = signedAt(data, at, packing_.extraBytes);
        at += packing_.extraBytes;
    }
    const auto behind = [&](std::uint64_t from, unsigned bits) {
        return (from + packing_.groups * bits + 7) / 8 * 8;  // parts begin with a byte
    };
    layout.references = 8 * static_cast<std::uint64_t>(at);
    layout.widths = behind(layout.references, packing_.bits);
    layout.lengths = behind(layout.widths, packing_.widthBits);
    layout.numbers = behind(layout.lengths, packing_.lengthBits);
    requireBits(data, layout.numbers);
    return layout;
}

/// Goes to the nearest known place at or before a line.
void LineUnpacker::seek(std::size_t line) {
    if (at_.line <= line && line - at_.line < kLinesPerMark) return;
    const std::size_t mark = std::min(line / kLinesPerMark, marks_.size() - 1);
    if (at_.line <= line && at_.line >= marks_[mark].line) return;
    at_ = marks_[mark];
}

void LineUnpacker::read(std::size_t first, ByteSpan bitmap, ByteSpan data,
                        std::span<float> values) {
    const Layout layout = layoutOf(data);
    if (!bitmap.empty()) {
        bitmap = bitmap.subspan(std::min(kBitmapHead, bitmap.size()));
        requireBits(bitmap, static_cast<std::uint64_t>(lineLength_) * lineCount_);
    }
    seek(first);
    std::vector<float> passed(at_.line < first ? lineLength_ : 0);
    const std::size_t end = first + values.size() / lineLength_;
    while (at_.line < end) {
        if (at_.line % kLinesPerMark == 0 && at_.line / kLinesPerMark == marks_.size()) {
            marks_.push_back(at_);
        }
        line(bitmap, data, layout,
             at_.line < first ? std::span(passed)
                              : values.subspan((at_.line - first) * lineLength_, lineLength_));
        ++at_.line;
    }
}

void LineUnpacker::line(ByteSpan bitmap, ByteSpan data, const Layout& layout,
                        std::span<float> values) {
    if (bitmap.empty()) return present(data, layout, values);
    const std::uint64_t point = static_cast<std::uint64_t>(at_.line) * lineLength_;
    std::size_t count = setBits(bitmap, point, lineLength_);
    present(data, layout, values.first(count));
    if (count == lineLength_) return;
    // From the end, so that nothing is overwritten before it has moved.
    for (std::size_t i = lineLength_; i-- > 0;) {
        values[i] = bitsAt(bitmap, point + i, 1) != 0 ? values[--count] : kMissing;
    }
}

/// The next values that the bitmap, if any, declares present.
void LineUnpacker::present(ByteSpan data, const Layout& layout, std::span<float> values) {
    if (values.size() > packing_.values - std::min(packing_.values, at_.value)) {
        throw Failure{"it has fewer values than its grid has points",
                      fmt::format("{} values", packing_.values),
                      {},
                      "the message is damaged: download the file again"};
    }
    if (packing_.form == 0 || packing_.groups == 0) {
        simple(data, values);
    } else {
        complex(data, layout, values);
    }
    at_.value += values.size();
}

void LineUnpacker::simple(ByteSpan data, std::span<float> values) {
    const unsigned bits = packing_.groups == 0 && packing_.form != 0 ? 0 : packing_.bits;
    std::uint64_t bit = 8 * kSectionHead + at_.value * bits;
    requireBits(data, bit + values.size() * bits);
    for (float& value : values) {
        value = static_cast<float>(packing_.reference +
                                   packing_.scale * static_cast<double>(bitsAt(data, bit, bits)));
        bit += bits;
    }
}

void LineUnpacker::complex(ByteSpan data, const Layout& layout, std::span<float> values) {
    while (!values.empty()) {
        if (at_.group >= packing_.groups) {
            throw Failure{"its groups hold fewer values than it states",
                          fmt::format("{} values", at_.value),
                          fmt::format("{} values", packing_.values),
                          "the message is damaged: download the file again"};
        }
        const std::uint64_t g = at_.group;
        const std::uint32_t reference =
            bitsAt(data, layout.references + g * packing_.bits, packing_.bits);
        const std::uint64_t width =
            packing_.widthBase +
            std::uint64_t{bitsAt(data, layout.widths + g * packing_.widthBits, packing_.widthBits)};
        const std::uint64_t scaled =
            bitsAt(data, layout.lengths + g * packing_.lengthBits, packing_.lengthBits);
        const std::uint64_t length = g + 1 == packing_.groups
                                         ? packing_.lastLength
                                         : packing_.lengthBase + packing_.lengthStep * scaled;
        const auto count = static_cast<std::size_t>(
            std::min<std::uint64_t>(values.size(), length - std::min(length, at_.inGroup)));
        if (width > 32) {
            throw Failure{"a group of its numbers has an impossible width",
                          fmt::format("{} bits", width), "at most 32",
                          "the message is damaged: download the file again"};
        }
        const std::uint64_t bit = layout.numbers + at_.bit;
        requireBits(data, bit + count * width);
        const bool missing = packing_.missing > 0;
        const auto unpack = [&]<unsigned kOrder>() {
            missing ? group<kOrder, true>(data, layout, reference, static_cast<unsigned>(width),
                                          values.first(count))
                    : group<kOrder, false>(data, layout, reference, static_cast<unsigned>(width),
                                           values.first(count));
        };
        packing_.order == 2   ? unpack.template operator()<2>()
        : packing_.order == 1 ? unpack.template operator()<1>()
                              : unpack.template operator()<0>();
        at_.bit += count * width;
        at_.inGroup += count;
        values = values.subspan(count);
        if (at_.inGroup >= length) {
            ++at_.group;
            at_.inGroup = 0;
        }
    }
}

/// Values of one group. Differences are those of the values that are present; numbers wrap, as in
/// damaged data, rather than overflow.
template <unsigned kOrder, bool kMissing_>
void LineUnpacker::group(ByteSpan data, const Layout& layout, std::uint32_t reference,
                         unsigned width, std::span<float> values) {
    std::uint64_t bit = layout.numbers + at_.bit;
    // All ones mark missing values: of the group's width, or of a reference without numbers.
    const unsigned markBits = width > 0 ? width : packing_.bits;
    const std::uint32_t mark =
        markBits == 0 ? 0U : static_cast<std::uint32_t>((std::uint64_t{1} << markBits) - 1);
    auto near = static_cast<std::uint64_t>(at_.before[0]);
    auto far = static_cast<std::uint64_t>(at_.before[1]);
    unsigned known = at_.known;
    for (float& value : values) {
        const std::uint32_t number = bitsAt(data, bit, width);
        bit += width;
        if constexpr (kMissing_) {
            const std::uint32_t tested = width > 0 ? number : reference;
            if (markBits > 0 && (tested == mark || (packing_.missing == 2 && tested + 1 == mark))) {
                value = kMissing;
                continue;
            }
        }
        std::uint64_t whole = std::uint64_t{reference} + number;
        if constexpr (kOrder > 0) {
            if (known < kOrder) {
                whole = static_cast<std::uint64_t>(layout.first[known]);
                ++known;
            } else {
                whole += static_cast<std::uint64_t>(layout.least);
                whole += kOrder == 1 ? near : 2 * near - far;
            }
            far = near;
            near = whole;
        }
        value = static_cast<float>(packing_.reference +
                                   packing_.scale *
                                       static_cast<double>(static_cast<std::int64_t>(whole)));
    }
    at_.before = {static_cast<std::int64_t>(near), static_cast<std::int64_t>(far)};
    at_.known = known;
}

}  // namespace grib
