// deflated_floats.h: reads boxes of floats from chunks that were compressed with deflate (zlib),
// with or without the shuffle filter.
//
// HDF5 undoes filters under its lock, one chunk after the other. Here it only hands over the stored
// bytes, and threads inflate the chunks that a box needs. Inflated chunks are kept for the boxes
// that follow: those of neighbouring rows need the same ones.
#pragma once
#include <hdf5.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace nc {

/// One variable of an HDF5 file. Used by one thread at a time.
class DeflatedFloats {
  public:
    /// Inflated chunks of a variable that are held between two boxes, at most: two rows of chunks,
    /// over the full width and depth, or this much if that is less.
    static constexpr std::size_t kMostBytes = std::size_t{256} << 20U;

    /// The identifier of a file that NetCDF has open as well; negative if HDF5 refuses. The caller
    /// holds the lock of the library and closes it.
    static hid_t fileOf(const std::string& path);

    /// The variable `name` of the file with the identifier `file`, if it has `shape`, in chunks of
    /// `chunk`, as floats of this machine and no other filters; otherwise null. The caller holds
    /// the lock of the library, as for all of this class but inflate() and copy().
    static std::unique_ptr<DeflatedFloats> of(hid_t file, const std::string& name,
                                              std::span<const std::size_t> shape,
                                              std::span<const std::size_t> chunk);
    ~DeflatedFloats();
    DeflatedFloats(const DeflatedFloats&) = delete;
    DeflatedFloats& operator=(const DeflatedFloats&) = delete;

    /// A chunk that a box needs and that is not kept: its bytes as they are stored.
    struct Stored {
        std::size_t index = 0;  ///< of the chunk, last axis fastest
        std::vector<std::byte> bytes;
    };
    /// What has to be inflated for the box [start, start + count), slowest axis first. Nothing if
    /// the library has to read: a chunk was never written, or skipped a filter, or its bytes cannot
    /// be had. Then the library gives the values or the error.
    std::optional<std::vector<Stored>> fetch(std::span<const std::size_t> start,
                                             std::span<const std::size_t> count);
    /// Inflates chunks in several threads and keeps them. False if one is damaged.
    bool inflate(std::span<const Stored> chunks);
    /// Copies the box of the last fetch() out of the chunks, all of which are kept now, and drops
    /// those that are no longer expected to be needed.
    void copy(std::span<const std::size_t> start, std::span<const std::size_t> count,
              std::span<float> values);

  private:
    using Cells = std::unique_ptr<float[]>;  ///< of one chunk; not filled before it is inflated
    class Inflater;
    struct Kept {
        Cells values;
        std::uint64_t lastUse = 0;
    };
    DeflatedFloats(hid_t dataset, std::span<const std::size_t> shape,
                   std::span<const std::size_t> chunk);
    bool readFilters();
    /// Calls `visit(index, origin)` for each chunk that meets the box.
    template <typename Visit>
    void eachChunk(std::span<const std::size_t> start, std::span<const std::size_t> count,
                   Visit&& visit) const;
    std::optional<Stored> stored(std::size_t index, std::span<const std::size_t> origin) const;
    Cells cells();
    void drop(std::size_t index);
    void dropPassed(std::span<const std::size_t> start, std::span<const std::size_t> count);
    std::size_t rowOf(std::size_t index) const;

    hid_t dataset_;
    bool shuffled_ = false;
    std::vector<std::size_t> shape_, chunk_, chunks_;  ///< cells; cells per chunk; chunks
    std::size_t chunkCells_ = 1;
    std::size_t mostKept_ = 0;  ///< chunks
    std::map<std::size_t, Kept> kept_;
    // Memory of dropped chunks for the next ones: fresh pages would cost as much as inflating.
    std::vector<Cells> spare_;
    std::vector<std::unique_ptr<Inflater>> inflaters_;  ///< one for each thread
    std::uint64_t use_ = 0;
};

}  // namespace nc
