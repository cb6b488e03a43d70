// tiles.cpp: finds the tiles of a domain by the patches that their attributes state.
#include "readers/wrf_netcdf/tiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "readers/wrf_netcdf/advice.h"

namespace wrf {
namespace {

namespace fs = std::filesystem;

constexpr std::array kAxisNames{"WEST-EAST", "SOUTH-NORTH"};

/// What the attributes of a file state along x or y.
struct Patch {
    std::size_t first = 0, count = 0;  ///< cells of this rank
    std::size_t whole = 0;             ///< cells of the domain
};

std::optional<Patch> patchOf(const NcFile& file, std::size_t axis) {
    const std::string name = kAxisNames[axis];
    const auto start = file.number((name + "_PATCH_START_UNSTAG").c_str());
    const auto end = file.number((name + "_PATCH_END_UNSTAG").c_str());
    const auto points = file.number((name + "_GRID_DIMENSION").c_str());
    constexpr double kMost = 1U << 20U;
    if (!start || !end || !points || !(*start >= 1.0) || !(*end >= *start) || !(*points > *end) ||
        !(*points <= kMost)) {
        return {};
    }
    return Patch{static_cast<std::size_t>(*start) - 1, static_cast<std::size_t>(*end - *start) + 1,
                 static_cast<std::size_t>(*points) - 1};
}

/// "name_0007" without the rank; empty if the name does not end in one.
std::string stemOf(const std::string& name) {
    const std::size_t bar = name.rfind('_');
    if (bar == std::string::npos || name.size() - bar - 1 < 4) return {};
    const bool digits = name.find_first_not_of("0123456789", bar + 1) == std::string::npos;
    return digits ? name.substr(0, bar + 1) : std::string();
}

/// The files of all ranks, in order of rank.
std::vector<std::string> siblingsOf(const std::string& path) {
    const std::string name = fs::path(path).filename().string();
    const std::string stem = stemOf(name);
    if (stem.empty()) return {path};
    std::vector<std::string> found;
    const fs::path folder = fs::path(path).parent_path();
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, error)) {
        const std::string other = entry.path().filename().string();
        if (other.size() == name.size() && stemOf(other) == stem) {
            found.push_back((folder / other).string());
        }
    }
    std::ranges::sort(found);
    return found;
}

}  // namespace

Tiles::Tiles(const std::string& path) {
    auto file = std::make_unique<NcFile>(path);
    const auto axes = axesOf(*file);
    if (!axes) throw adviceFor(*file);
    axes_ = *axes;
    const auto x = patchOf(*file, 0);
    const auto y = patchOf(*file, 1);
    columns_ = {axes_.length[0], axes_.length[1]};
    // Who cuts a region out of a file keeps the attributes of the whole.
    const bool tile = x && y && x->count == columns_[0] && y->count == columns_[1] &&
                      (x->count < x->whole || y->count < y->whole);
    const bool cut = x && y && !tile && (columns_[0] < x->whole || columns_[1] < y->whole);
    if (cut) {
        partNote_ = fmt::format("The file holds {} x {} of the {} x {} columns of its domain.",
                                columns_[0], columns_[1], x->whole, y->whole);
    }
    if (!tile) {
        tiles_.push_back({std::move(file), {0, 0}, columns_});
        flipsRows_ = runsSouth();
        return;
    }
    columns_ = {x->whole, y->whole};
    axes_.length[0] = columns_[0];
    axes_.length[1] = columns_[1];
    file.reset();
    openOthers(path);
    requireWhole(path);
}

Tiles::Tile Tiles::open(const std::string& path) const {
    Tile tile;
    try {
        tile.file = std::make_unique<NcFile>(path);
    } catch (Failure& failure) {
        failure.where = path;
        throw;
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto patch = patchOf(*tile.file, axis);
        const NcDimension* dimension = tile.file->dimension(axes_.centre[axis]);
        if (!patch || dimension == nullptr || dimension->length != patch->count ||
            patch->whole != columns_[axis] || patch->first + patch->count > columns_[axis]) {
            throw Failure{"is not a tile of the same domain as the files beside it",
                          listOf(tile.file->dimensions()),
                          fmt::format("a part of {} x {} columns", columns_[0], columns_[1]),
                          "keep the tiles of one domain and run in a folder of their own", path};
        }
        tile.lower[axis] = patch->first;
        tile.size[axis] = patch->count;
    }
    return tile;
}

void Tiles::openOthers(const std::string& path) {
    for (const std::string& sibling : siblingsOf(path)) tiles_.push_back(open(sibling));
}

/// Throws Failure unless every column of the domain is in exactly one tile.
void Tiles::requireWhole(const std::string& path) const {
    std::uint64_t held = 0;
    bool overlap = false;
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
        held += std::uint64_t{tiles_[i].size[0]} * tiles_[i].size[1];
        for (std::size_t j = 0; j < i && !overlap; ++j) overlap = meet(tiles_[i], tiles_[j]);
    }
    const std::uint64_t wanted = std::uint64_t{columns_[0]} * columns_[1];
    if (held == wanted && !overlap) return;
    throw Failure{
        fmt::format("is a tile that one MPI rank wrote (io_form_history = 102), and {}",
                    overlap ? "tiles overlap" : "tiles of other ranks are missing"),
        fmt::format("{} file(s) with {} columns", tiles_.size(), held),
        fmt::format("the files of all ranks, {}0000 and so on, in one folder: {} columns",
                    stemOf(fs::path(path).filename().string()), wanted),
        "copy the others beside it, or run with io_form_history = 2, which writes one file"};
}

bool Tiles::meet(const Tile& a, const Tile& b) {
    const auto along = [&](std::size_t axis) {
        return a.lower[axis] < b.lower[axis] + b.size[axis] &&
               b.lower[axis] < a.lower[axis] + a.size[axis];
    };
    return along(0) && along(1);
}

std::vector<std::string> Tiles::paths() const {
    std::vector<std::string> paths;
    for (const Tile& tile : tiles_) paths.push_back(tile.file->path());
    return paths;
}

std::optional<Shape> Tiles::shapeOf(const NcVariable& variable) const {
    auto shape = wrf::shapeOf(variable, axes_);
    if (!shape || tiles_.size() == 1) return shape;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const bool face = variable.axes[variable.axes.size() - 1 - axis].name == axes_.face[axis];
        shape->size[axis] = columns_[axis] + (face ? 1 : 0);
    }
    return shape;
}

/// Whether the rows of the only file run from north to south, by a coordinate that falls along y,
/// or by latitudes that fall. On a polar projection latitudes may fall beyond the pole.
bool Tiles::runsSouth() const {
    constexpr double kPolar = 2.0;  // of MAP_PROJ
    const NcFile& file = first();
    if (columns_[1] < 2) return false;
    const NcVariable* coordinate = file.variable(axes_.centre[1]);
    if (coordinate != nullptr && coordinate->number && coordinate->axes.size() == 1 &&
        coordinate->axes[0].name == axes_.centre[1]) {
        const std::array<std::size_t, 1> start{0}, count{columns_[1]};
        const auto positions = file.readDoubles(*coordinate, start, count);
        return positions.back() < positions.front();
    }
    const NcVariable* latitude = file.variable("XLAT");
    const auto shape = latitude == nullptr ? std::nullopt : shapeOf(*latitude);
    if (!shape || !shape->flat || !latitude->number || file.number("MAP_PROJ") == kPolar) {
        return false;
    }
    std::array<float, 2> ends{};
    for (const std::size_t end : {0U, 1U}) {
        const std::size_t y = end == 0 ? 0 : columns_[1] - 1;
        readRows(*latitude, 0, Box{{0, y, 0}, {1, y + 1, 1}}, std::span(ends).subspan(end, 1));
    }
    return ends[1] < ends[0];
}

void Tiles::read(const NcVariable& variable, std::size_t record, const Box& box,
                 std::span<float> values) const {
    if (!flipsRows_) return readRows(variable, record, box, values);
    const std::size_t rows = variable.axes[variable.axes.size() - 2].length;
    Box turned = box;
    turned.lower[1] = rows - box.upper[1];
    turned.upper[1] = rows - box.lower[1];
    readRows(variable, record, turned, values);
    const std::size_t width = box.length(0);
    for (std::size_t z = 0; z < box.length(2); ++z) {
        const auto level = values.subspan(z * box.plane(), box.plane());
        for (std::size_t y = 0; y < box.length(1) / 2; ++y) {
            std::swap_ranges(
                level.begin() + static_cast<std::ptrdiff_t>(y * width),
                level.begin() + static_cast<std::ptrdiff_t>((y + 1) * width),
                level.begin() + static_cast<std::ptrdiff_t>((box.length(1) - 1 - y) * width));
        }
    }
}

void Tiles::readRows(const NcVariable& variable, std::size_t record, const Box& box,
                     std::span<float> values) const {
    if (tiles_.size() == 1) return readTile(tiles_.front(), variable, record, box, values);
    std::vector<float> part;
    for (const Tile& tile : tiles_) {
        const NcVariable* own = tile.file->variable(variable.name);
        if (own == nullptr || own->axes.size() != variable.axes.size()) {
            throw Failure{fmt::format("variable {} is missing in one tile", variable.name),
                          {},
                          {},
                          "copy the tile again",
                          tile.file->path()};
        }
        Box cells = box;
        bool empty = false;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const std::size_t length = own->axes[own->axes.size() - 1 - axis].length;
            cells.lower[axis] = std::max(box.lower[axis], tile.lower[axis]);
            cells.upper[axis] = std::min(box.upper[axis], tile.lower[axis] + length);
            empty = empty || cells.lower[axis] >= cells.upper[axis];
        }
        if (empty) continue;
        if (own->units != variable.units) {
            throw Failure{fmt::format("the units of variable {} differ from those of other tiles",
                                      variable.name),
                          fmt::format("\"{}\"", own->units), fmt::format("\"{}\"", variable.units),
                          "keep the tiles of one run together", tile.file->path()};
        }
        part.resize(cells.count());
        try {
            readTile(tile, *own, record, cells, part);
        } catch (Failure& failure) {
            if (failure.where.empty()) failure.where = tile.file->path();
            throw;
        }
        shared::putInto(box, values, cells, part);
    }
}

/// Converts the box to starts and counts in file order: time, z, y, x.
void Tiles::readTile(const Tile& tile, const NcVariable& variable, std::size_t record,
                     const Box& box, std::span<float> values) const {
    std::vector<std::size_t> start;
    std::vector<std::size_t> count;
    if (!axes_.time.empty() && variable.axes.front().name == axes_.time) {
        start.push_back(record);
        count.push_back(1);
    }
    const bool flat = variable.axes.size() - start.size() == 2;
    for (std::size_t axis = flat ? 2 : 3; axis-- > 0;) {
        start.push_back(axis < 2 ? box.lower[axis] - tile.lower[axis] : box.lower[axis]);
        count.push_back(box.length(axis));
    }
    tile.file->read(variable, start, count, values);
}

}  // namespace wrf
