// sections.cpp: walks from message to message and from section to section.
#include "readers/grib/sections.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace grib {
namespace {

constexpr std::string_view kMagic = "GRIB", kEnd = "7777";
constexpr std::size_t kIndicator = 16;            // bytes of section 0
constexpr std::size_t kMostHeading = 512;         // of a bulletin, before GRIB
constexpr std::uint64_t kMostHeader = 1U << 20U;  // of one section without data, in bytes
constexpr std::uint64_t kMostGap = 16U << 20U;    // that is searched for the next message
constexpr std::size_t kMostFields = 1'000'000;

bool standsAt(ByteSpan bytes, std::size_t at, std::string_view text) {
    return at + text.size() <= bytes.size() &&
           std::equal(text.begin(), text.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                      [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
}

/// A message that breaks the rules; the walk goes on behind it.
struct Damaged {};

class Walk {
  public:
    explicit Walk(const InputFile& file) : file_(file) {}

    Inventory take() {
        std::uint64_t at = 0;
        while (true) {
            const auto start = next(at);
            if (!start) break;
            at = *start;
            const std::uint64_t length = lengthOf(at);
            if (length < kIndicator || length > file_.size() - at) {
                // Either the file ends here, or this length is wrong and others follow.
                if (!next(at + kMagic.size())) {
                    inventory_.unfinished = Extent{at, length};
                    break;
                }
                leaveOut();
                at += kMagic.size();
                continue;
            }
            ++inventory_.messages;
            at += message(at, length) ? length : kMagic.size();
        }
        return std::move(inventory_);
    }

  private:
    /// Bytes of the file from a window that moves with the walk; short where the file ends.
    ByteSpan bytes(std::uint64_t at, std::size_t count) {
        if (at < windowAt_ || at + count > windowAt_ + window_.size()) {
            window_.resize(std::max<std::size_t>(count, 4096));
            windowAt_ = at;
            window_.resize(file_.read(at, window_));
        }
        const auto from = static_cast<std::size_t>(at - windowAt_);
        const std::size_t there = std::min(count, window_.size() - from);
        return ByteSpan(window_).subspan(from, there);
    }

    /// Where the next message of edition 1 or 2 begins, from `at` on; nothing if none does.
    std::optional<std::uint64_t> next(std::uint64_t at) {
        const std::uint64_t end = std::min(file_.size(), at + kMostGap);
        while (at + kIndicator <= end) {
            const ByteSpan chunk = bytes(at, 4096);
            const auto found = std::search(
                chunk.begin(), chunk.end(), kMagic.begin(), kMagic.end(),
                [](std::uint8_t a, char b) { return a == static_cast<std::uint8_t>(b); });
            const auto offset = static_cast<std::size_t>(found - chunk.begin());
            if (found == chunk.end()) {
                if (chunk.size() < kMagic.size()) return {};
                at += chunk.size() - (kMagic.size() - 1);
                continue;
            }
            at += offset;
            const ByteSpan head = bytes(at, kIndicator);
            if (head.size() < kIndicator) return {};
            if (head[7] == 1 || head[7] == 2) return at;
            at += kMagic.size();
        }
        return {};
    }

    /// Total length of the message at `at`.
    std::uint64_t lengthOf(std::uint64_t at) {
        const ByteSpan head = bytes(at, kIndicator);
        return head[7] == 1 ? unsignedAt(head, 4, 3) : unsignedAt(head, 8, 8);
    }

    void leaveOut() {
        ++inventory_.messages;
        inventory_.damaged.push_back(inventory_.messages);
    }

    /// Adds the fields of a message. Returns whether the next one is behind its stated length.
    bool message(std::uint64_t at, std::uint64_t length) {
        const std::size_t before = inventory_.fields.size();
        const bool ended = standsAt(bytes(at + length - kEnd.size(), kEnd.size()), 0, kEnd);
        if (bytes(at, kIndicator)[7] == 1) {
            ++inventory_.otherEdition;
            return ended;
        }
        try {
            if (!ended) throw Damaged{};
            sections(at, length);
        } catch (const Damaged&) {
            inventory_.fields.resize(before);
            inventory_.damaged.push_back(inventory_.messages);
        } catch (const Failure&) {  // a section that is too short
            inventory_.fields.resize(before);
            inventory_.damaged.push_back(inventory_.messages);
        }
        return ended;
    }

    void sections(std::uint64_t at, std::uint64_t length) {
        Field field;
        field.message = inventory_.messages;
        field.discipline = bytes(at, kIndicator)[6];
        const std::uint64_t end = at + length - kEnd.size();
        std::uint64_t from = at + kIndicator;
        while (from < end) {
            const ByteSpan head = bytes(from, 5);
            const std::uint64_t size = unsignedAt(head, 0, 4);
            if (size < 5 || size > end - from) throw Damaged{};
            section(field, static_cast<unsigned>(head[4]), {from, size});
            from += size;
        }
        if (field.part == 0) throw Damaged{};
    }

    void section(Field& field, unsigned number, Extent extent) {
        if (number < 6 && extent.length > kMostHeader) throw Damaged{};
        switch (number) {
            case 1:
                field.identification = shared(copy(extent));
                return;
            case 2:
                return;  // for local use
            case 3:
                field.grid = shared(copy(extent));
                return;
            case 4:
                field.product = copy(extent);
                return;
            case 5:
                field.packing = copy(extent);
                return;
            case 6:
                bitmap(field, extent);
                return;
            case 7:
                if (!field.identification || !field.grid || field.product.empty() ||
                    field.packing.empty() || inventory_.fields.size() >= kMostFields) {
                    throw Damaged{};
                }
                ++field.part;
                field.data = extent;
                inventory_.fields.push_back(field);
                return;
            default:
                throw Damaged{};
        }
    }

    /// Code table 6.0: 0 a bitmap follows, 254 that of the field before applies, 255 none.
    void bitmap(Field& field, Extent extent) {
        const unsigned indicator = static_cast<unsigned>(unsignedAt(bytes(extent.at, 6), 5, 1));
        if (indicator == 0) {
            field.bitmap = extent;
        } else if (indicator == 255) {
            field.bitmap = {};
        } else if (indicator != 254 || field.bitmap.length == 0) {
            throw Damaged{};
        }
    }

    Bytes copy(Extent extent) {
        const ByteSpan there = bytes(extent.at, static_cast<std::size_t>(extent.length));
        if (there.size() < extent.length) throw Damaged{};
        return {there.begin(), there.end()};
    }

    /// One copy of sections that many messages repeat.
    std::shared_ptr<const Bytes> shared(Bytes section) {
        const auto same = std::ranges::find_if(
            pool_, [&](const std::shared_ptr<const Bytes>& known) { return *known == section; });
        if (same != pool_.end()) return *same;
        constexpr std::size_t kMostPooled = 64;  // files have one or two
        auto kept = std::make_shared<const Bytes>(std::move(section));
        if (pool_.size() < kMostPooled) pool_.push_back(kept);
        return kept;
    }

    const InputFile& file_;
    Inventory inventory_;
    Bytes window_;
    std::uint64_t windowAt_ = 0;
    std::vector<std::shared_ptr<const Bytes>> pool_;
};

void append(Bytes& to, ByteSpan bytes) {
    to.insert(to.end(), bytes.begin(), bytes.end());
}

void append(Bytes& to, std::string_view text) {
    for (const char c : text) to.push_back(static_cast<std::uint8_t>(c));
}

}  // namespace

std::optional<std::size_t> messageStart(ByteSpan head) {
    for (std::size_t at = 0; at < std::min(head.size(), kMostHeading); ++at) {
        if (standsAt(head, at, kMagic) && at + 7 < head.size()) return at;
        const bool text = head[at] < 0x7f;  // headings are of the International Alphabet No. 5
        if (!text) return {};
    }
    return {};
}

Inventory scan(const InputFile& file) {
    return Walk(file).take();
}

Bytes messageOf(const InputFile& file, const Field& field, bool values) {
    Bytes message(kIndicator);
    std::ranges::copy(kMagic, message.begin());
    message[6] = static_cast<std::uint8_t>(field.discipline);
    message[7] = 2;
    append(message, *field.identification);
    append(message, *field.grid);
    append(message, field.product);
    append(message, field.packing);
    if (field.bitmap.length > 0 && values) {
        append(message, file.read(field.bitmap));
    } else {
        constexpr std::array<std::uint8_t, 6> kNone{0, 0, 0, 6, 6, 255};
        append(message, ByteSpan(kNone));
    }
    constexpr std::array<std::uint8_t, 5> kNoData{0, 0, 0, 5, 7};
    if (values) {
        append(message, file.read(field.data));
    } else {
        append(message, ByteSpan(kNoData));
    }
    append(message, kEnd);
    const std::uint64_t length = message.size();
    for (std::size_t i = 0; i < 8; ++i) {
        message[8 + i] = static_cast<std::uint8_t>(length >> (56U - 8U * i));
    }
    return message;
}

}  // namespace grib
