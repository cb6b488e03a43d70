// tiles.h: the files that one domain is stored in: one, or one for each MPI rank (io_form_history =
// 102), which WRF names with the rank at the end.
#pragma once
#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "readers/shared/box.h"
#include "readers/wrf_netcdf/axes.h"
#include "readers/wrf_netcdf/failure.h"

namespace wrf {

using shared::Box;

class Tiles {
  public:
    /// Opens a file, and those of the other ranks beside it if it is a tile. Throws Failure if some
    /// are missing, or if it is not model output.
    explicit Tiles(const std::string& path);

    /// The file of the first rank: all tiles have the same variables and times.
    const NcFile& first() const { return *tiles_.front().file; }
    const Axes& axes() const { return axes_; }
    /// Cells of the domain in x and y.
    std::array<std::size_t, 2> columns() const { return columns_; }
    /// All files; one if the domain is not divided.
    std::vector<std::string> paths() const;
    /// Whether rows are stored from north to south; read() turns them.
    bool flipsRows() const { return flipsRows_; }
    /// A sentence if the file says that it is a part of its domain, without being a tile.
    const std::string& partNote() const { return partNote_; }

    /// Size of a variable of the first file on the whole domain; nothing if it is not on the grid.
    std::optional<Shape> shapeOf(const NcVariable& variable) const;

    /// Fills `values` with a box of `variable`, which belongs to first(), at record `record`; x
    /// fastest, then y, then z. Throws Failure.
    void read(const NcVariable& variable, std::size_t record, const Box& box,
              std::span<float> values) const;

  private:
    /// One file, and its cells [lower, lower + size) of the domain in x and y.
    struct Tile {
        std::unique_ptr<NcFile> file;
        std::array<std::size_t, 2> lower{}, size{};
    };
    Tile open(const std::string& path) const;
    void openOthers(const std::string& path);
    void requireWhole(const std::string& path) const;
    bool runsSouth() const;
    void readRows(const NcVariable& variable, std::size_t record, const Box& box,
                  std::span<float> values) const;
    static bool meet(const Tile& a, const Tile& b);
    void readTile(const Tile& tile, const NcVariable& variable, std::size_t record, const Box& box,
                  std::span<float> values) const;

    Axes axes_;
    std::array<std::size_t, 2> columns_{};
    std::vector<Tile> tiles_;
    std::string partNote_;
    bool flipsRows_ = false;
};

}  // namespace wrf
