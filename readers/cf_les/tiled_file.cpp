// tiled_file.cpp: finds tiles by name, orders them by position, and reads boxes across them.
#include "readers/cf_les/tiled_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>

namespace cf {
namespace {

namespace fs = std::filesystem;

/// The files of other ranks beside a file, and the file itself, sorted; it alone if it is no tile.
std::vector<std::string> tilesOf(const std::string& path, const Tiles& tiles) {
    std::vector<std::string> found{path};
    if (tiles.pattern.empty()) return found;
    const std::regex pattern(tiles.pattern);
    const std::string name = fs::path(path).filename().string();
    std::smatch own;
    if (!std::regex_match(name, own, pattern)) return found;
    found.clear();
    std::error_code code;
    const fs::path folder = fs::path(path).parent_path();
    for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, code)) {
        const std::string other = entry.path().filename().string();
        std::smatch groups;
        if (!std::regex_match(other, groups, pattern)) continue;
        bool same = true;
        for (std::size_t i = 1; i < groups.size(); ++i) {
            const bool rank = std::ranges::find(tiles.ranks, i) != tiles.ranks.end();
            same = same && (rank || groups[i] == own[i]);
        }
        if (same) found.push_back((folder / other).string());
    }
    if (found.empty()) found.push_back(path);
    std::ranges::sort(found);
    return found;
}

/// Positions of the cells of one file along x or y.
std::vector<double> positionsOf(const nc::NcFile& file, const Model& model, std::size_t axis) {
    for (const std::string& dimension : model.axes[axis].cells) {
        if (file.dimension(dimension) == nullptr) continue;
        const nc::NcVariable* variable = Axes::positions(file, model, axis, dimension);
        if (variable == nullptr || variable->axes.front().length > kMostCells) continue;
        const std::array<std::size_t, 1> start{0}, count{variable->axes.front().length};
        return file.readDoubles(*variable, start, count);
    }
    throw nc::Failure{"is a tile of one MPI rank without the positions of its cells",
                      "dimensions " + nc::listOf(file.dimensions()),
                      "a coordinate for x and one for y", "join the tiles of the run into one file",
                      file.path()};
}

}  // namespace

TiledFile::TiledFile(std::unique_ptr<nc::NcFile> file, const Model& model) {
    const std::string path = file->path();
    for (const std::string& each : tilesOf(path, model.tiles)) {
        Tile tile;
        tile.file = each == path ? std::move(file) : std::make_unique<nc::NcFile>(each);
        tiles_.push_back(std::move(tile));
    }
    if (tiles_.size() > 1) join(model);
}

std::vector<std::string> TiledFile::paths() const {
    std::vector<std::string> paths;
    for (const Tile& tile : tiles_) paths.push_back(tile.file->path());
    return paths;
}

/// Lays the tiles out in rows and columns.
void TiledFile::join(const Model& model) {
    std::array<std::map<double, std::size_t>, 2> starts;  // first position to number of cells
    std::vector<std::array<double, 2>> corners;
    for (Tile& tile : tiles_) {
        std::array<double, 2> corner{};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const std::vector<double> positions = positionsOf(*tile.file, model, axis);
            if (positions.empty())
                throw nc::Failure{"a tile has no cells", {}, {}, {}, tile.file->path()};
            corner[axis] = positions.front();
            tile.size[axis] = positions.size();
            const auto [entry, isNew] = starts[axis].emplace(corner[axis], positions.size());
            if (!isNew && entry->second != positions.size()) {
                throw nc::Failure{"a tile has another size than those beside it",
                                  fmt::format("{} cells", positions.size()),
                                  fmt::format("{} cells", entry->second),
                                  "keep the tiles of one run together", tile.file->path()};
            }
        }
        corners.push_back(corner);
    }
    if (starts[0].size() * starts[1].size() != tiles_.size()) {
        throw nc::Failure{"is a tile of one MPI rank, and the tiles beside it do not make a domain",
                          fmt::format("{} tiles at {} places in x and {} in y", tiles_.size(),
                                      starts[0].size(), starts[1].size()),
                          "one tile at each place", "put all tiles of this time into its folder"};
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
        for (std::size_t i = 0; i < tiles_.size(); ++i) {
            for (const auto& [start, cells] : starts[axis]) {
                if (start < corners[i][axis]) tiles_[i].lower[axis] += cells;
            }
        }
        for (const auto& [start, cells] : starts[axis]) columns_[axis] += cells;
    }
    std::ranges::stable_sort(
        tiles_, {}, [](const Tile& tile) { return std::pair(tile.lower[1], tile.lower[0]); });
}

std::size_t TiledFile::lengthOf(std::size_t axis, bool face, std::size_t length) const {
    if (axis > 1 || columns_[axis] == 0) return length;
    return columns_[axis] + (face && length > tiles_.front().size[axis] ? 1 : 0);
}

std::vector<double> TiledFile::joined(const nc::NcVariable& variable, std::size_t axis) const {
    std::vector<double> values;
    for (const Tile& tile : tiles_) {
        if (axis < 2 && tile.lower[1 - axis] != 0) continue;
        const nc::NcVariable* own = named(*tile.file, variable.name);
        if (own == nullptr || own->axes.size() != 1 || own->axes.front().length > kMostCells) {
            continue;
        }
        const std::array<std::size_t, 1> start{0}, count{own->axes.front().length};
        std::vector<double> part = tile.file->readDoubles(*own, start, count);
        own->packing.unpack(std::span<double>(part));
        // The last face of one tile is the first of the next.
        const bool face = tiles_.size() > 1 && axis < 2 && part.size() > tile.size[axis];
        if (face && !values.empty()) values.pop_back();
        values.insert(values.end(), part.begin(), part.end());
        if (axis > 1) break;
    }
    return values;
}

void TiledFile::read(const nc::NcVariable& variable, const Layout& layout, std::size_t record,
                     const les::Box& box, std::span<float> values) const {
    if (tiles_.size() == 1) {
        return readTile(tiles_.front(), variable, layout, record, box, values);
    }
    std::vector<float> part;
    for (const Tile& tile : tiles_) {
        const nc::NcVariable* own = named(*tile.file, variable.name);
        if (own == nullptr || own->axes.size() != variable.axes.size()) {
            throw nc::Failure{fmt::format("variable {} is missing in one tile", variable.name),
                              {},
                              {},
                              "copy the tile again",
                              tile.file->path()};
        }
        les::Box cells = box;
        bool empty = false;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            if (!layout.axis[axis]) continue;
            const std::size_t length = own->axes[*layout.axis[axis]].length;
            cells.lower[axis] = std::max(box.lower[axis], tile.lower[axis]);
            cells.upper[axis] = std::min(box.upper[axis], tile.lower[axis] + length);
            empty = empty || cells.lower[axis] >= cells.upper[axis];
        }
        if (empty) continue;
        part.resize(cells.count());
        readTile(tile, *own, layout, record, cells, part);
        shared::putInto(box, values, cells, part);
    }
}

/// Reads in the order of the file and turns the axes to x, y, z.
void TiledFile::readTile(const Tile& tile, const nc::NcVariable& variable, const Layout& layout,
                         std::size_t record, const les::Box& box, std::span<float> values) const {
    const std::size_t rank = variable.axes.size();
    std::vector<std::size_t> start(rank, 0), count(rank, 1);
    std::array<std::size_t, 3> lower = box.lower;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!layout.axis[axis]) continue;
        if (axis < 2) lower[axis] -= tile.lower[axis];
        start[*layout.axis[axis]] = lower[axis];
        count[*layout.axis[axis]] = box.length(axis);
    }
    if (layout.time) start[*layout.time] = record;
    const auto at = [&](std::size_t axis) { return layout.axis[axis].value_or(rank); };
    const bool ordered = (at(2) < at(1) || at(2) == rank) && (at(1) < at(0) || at(1) == rank);
    if (ordered) return tile.file->read(variable, start, count, values);
    std::vector<float> stored(values.size());
    tile.file->read(variable, start, count, stored);
    std::array<std::size_t, 3> stride{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!layout.axis[axis]) continue;
        stride[axis] = 1;
        for (std::size_t i = *layout.axis[axis] + 1; i < rank; ++i) stride[axis] *= count[i];
    }
    std::size_t to = 0;
    for (std::size_t z = 0; z < box.length(2); ++z) {
        for (std::size_t y = 0; y < box.length(1); ++y) {
            const std::size_t from = z * stride[2] + y * stride[1];
            for (std::size_t x = 0; x < box.length(0); ++x) {
                values[to++] = stored[from + x * stride[0]];
            }
        }
    }
}

}  // namespace cf
