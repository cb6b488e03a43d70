// field_reader.cpp: lines of a message to rows of the grid.
#include "readers/grib/field_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "readers/grib/codes.h"
#include "readers/grib/product.h"

namespace grib {
namespace {

constexpr std::uint64_t kMostMapped = std::uint64_t{2} << 30U;  // of 8 GiB that a reader may have
constexpr std::size_t kMostKept = 64U << 10U;                   // values of one field

}  // namespace

void FieldReader::read(std::size_t index, const Columns& columns, std::span<float> values) {
    const Field& field = fields_.at(index);
    try {
        Open& open = opened(index);
        const std::size_t width = grid_.size[0];
        const std::size_t first = columns.lower[1], count = columns.length(1);
        const bool kept =
            first >= open.keptRow && (first - open.keptRow + count) * width <= open.kept.size();
        std::vector<float> large;
        std::span<const float> whole;
        if (kept) {
            whole = std::span(open.kept).subspan((first - open.keptRow) * width, count * width);
        } else {
            std::vector<float>& target = count * width <= kMostKept ? open.kept : large;
            target.resize(count * width);
            open.keptRow = first;
            if (&target == &large) open.kept.clear();
            rows(open, field, first, target);
            whole = target;
        }
        for (std::size_t y = 0; y < count; ++y) {
            const auto row = whole.subspan(y * width + columns.lower[0], columns.length(0));
            std::ranges::copy(row,
                              values.begin() + static_cast<std::ptrdiff_t>(y * columns.length(0)));
        }
    } catch (Failure& failure) {
        open_.erase(index);
        failure.what = fieldName(field) + ": " + failure.what;
        throw;
    } catch (...) {  // such as a lack of memory: what was begun is not kept
        open_.erase(index);
        throw;
    }
}

void FieldReader::clear() {
    open_.clear();
    scratch_.clear();
    mappedBytes_ = 0;
}

FieldReader::Open& FieldReader::opened(std::size_t index) {
    Open& open = open_[index];
    if (open.unpacker || open.unpacked) return open;
    const Field& field = fields_[index];
    const Packing packing = packingOf(field.packing);
    const std::uint64_t points = std::uint64_t{grid_.size[0]} * grid_.size[1];
    if (packing.values > points || (field.bitmap.length == 0 && packing.values != points)) {
        throw Failure{"it has another number of values than its grid has points",
                      fmt::format("{} values", packing.values), fmt::format("{} points", points),
                      "the message is damaged: download the file again"};
    }
    const std::size_t lineAxis = grid_.order.alongY ? 1 : 0;
    if (isUnpackedHere(packing.form)) {
        open.unpacker =
            std::make_unique<LineUnpacker>(packing, grid_.size[lineAxis], grid_.size[1 - lineAxis]);
    }
    if (!open.unpacker || grid_.order.alongY) unpackWhole(open, field);
    return open;
}

/// Maps the data of a field, and lets go of those of others where they would be too many.
void FieldReader::map(Open& open, const Field& field) {
    if (open.data) return;
    const std::uint64_t bytes = field.data.length + field.bitmap.length;
    if (mappedBytes_ + bytes > kMostMapped) {
        for (auto& [index, other] : open_) {
            other.data.reset();
            other.bitmap.reset();
        }
        mappedBytes_ = 0;
    }
    open.data = file_.map(field.data);
    if (field.bitmap.length > 0) open.bitmap = file_.map(field.bitmap);
    mappedBytes_ += bytes;
}

/// Lines in the order of the message.
void FieldReader::readLines(Open& open, const Field& field, std::size_t first,
                            std::span<float> values) {
    map(open, field);
    open.unpacker->read(first, open.bitmap ? open.bitmap->bytes() : ByteSpan(), open.data->bytes(),
                        values);
}

/// All lines of a field in the order of the message.
std::vector<float> FieldReader::linesOf(Open& open, const Field& field) {
    const std::size_t points = grid_.size[0] * grid_.size[1];
    std::vector<float> lines;
    if (open.unpacker) {
        lines.resize(points);
        readLines(open, field, 0, lines);
        open.unpacker.reset();
    } else {
        lines = unpackWithCodes(messageOf(file_, field, true),
                                static_cast<unsigned>(unsignedAt(field.packing, 9, 2)));
    }
    if (lines.size() == points) return lines;
    throw Failure{"ecCodes gives another number of values than its grid has points",
                  fmt::format("{} values", lines.size()), fmt::format("{} points", points),
                  "the message is damaged: download the file again"};
}

/// Unpacks a whole field into the scratch file, x fastest from the south-west corner.
void FieldReader::unpackWhole(Open& open, const Field& field) {
    const std::vector<float> lines = linesOf(open, field);
    const ScanOrder& order = grid_.order;
    const auto& size = grid_.size;
    std::vector<float> rowsNorth(lines.size());
    std::size_t at = 0;
    const std::size_t fast = order.alongY ? 1 : 0, slow = 1 - fast;
    const std::array<bool, 2> falling{order.westward, !order.northward};
    std::array<std::size_t, 2> cell{};
    for (std::size_t line = 0; line < size[slow]; ++line) {
        const bool turned = falling[fast] != (order.alternating && line % 2 == 1);
        cell[slow] = falling[slow] ? size[slow] - 1 - line : line;
        for (std::size_t i = 0; i < size[fast]; ++i) {
            cell[fast] = turned ? size[fast] - 1 - i : i;
            rowsNorth[cell[1] * size[0] + cell[0]] = lines[at++];
        }
    }
    open.scratchAt = scratch_.append(rowsNorth);
    open.unpacked = true;
}

/// Whole rows from `first` northward.
void FieldReader::rows(Open& open, const Field& field, std::size_t first, std::span<float> values) {
    const std::size_t width = grid_.size[0];
    if (open.unpacked) {
        return scratch_.read(open.scratchAt + sizeof(float) * first * width, values);
    }
    const ScanOrder& order = grid_.order;
    const std::size_t count = values.size() / width;
    const std::size_t line = order.northward ? first : grid_.size[1] - first - count;
    readLines(open, field, line, values);
    for (std::size_t y = 0; y < count; ++y) {
        if (order.westward != (order.alternating && (line + y) % 2 == 1)) {
            std::ranges::reverse(values.subspan(y * width, width));
        }
    }
    if (order.northward) return;
    for (std::size_t y = 0; y < count / 2; ++y) {
        std::ranges::swap_ranges(values.subspan(y * width, width),
                                 values.subspan((count - 1 - y) * width, width));
    }
}

}  // namespace grib
