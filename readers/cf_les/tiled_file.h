// tiled_file.h: one NetCDF file, or the files that the MPI ranks of a run wrote in its place.
//
// Tiles are put together by the positions of their cells. Boxes are x, y, z of the whole domain, as
// the files store it.
#pragma once
#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "readers/cf_les/axes.h"
#include "readers/les/box.h"

namespace cf {

class TiledFile {
  public:
    /// Opens the tiles beside a file if it is one. Throws Failure, also where tiles are missing.
    TiledFile(std::unique_ptr<nc::NcFile> file, const Model& model);

    /// All tiles have the same variables and times.
    const nc::NcFile& first() const { return *tiles_.front().file; }
    std::vector<std::string> paths() const;

    /// Cells along an axis, of the whole domain, for a dimension that has `length` in the first
    /// file.
    std::size_t lengthOf(std::size_t axis, bool face, std::size_t length) const;
    /// Joins the values of a variable along x or y in the first file, such as positions.
    std::vector<double> joined(const nc::NcVariable& variable, std::size_t axis) const;

    /// Fills `values`, x fastest, then y, then z. Throws Failure.
    void read(const nc::NcVariable& variable, const Layout& layout, std::size_t record,
              const les::Box& box, std::span<float> values) const;

  private:
    struct Tile {
        std::unique_ptr<nc::NcFile> file;
        std::array<std::size_t, 2> lower{}, size{};
    };
    void join(const Model& model);
    void readTile(const Tile& tile, const nc::NcVariable& variable, const Layout& layout,
                  std::size_t record, const les::Box& box, std::span<float> values) const;

    std::vector<Tile> tiles_;
    std::array<std::size_t, 2> columns_{};  ///< of all tiles; 0: there is one
};

}  // namespace cf
