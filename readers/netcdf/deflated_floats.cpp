// deflated_floats.cpp: stored bytes by HDF5, inflating by libdeflate.
#include "readers/netcdf/deflated_floats.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstring>
#include <thread>

namespace nc {
namespace {

constexpr std::size_t kMostChunkBytes = std::size_t{512} << 20U;  // larger: left to the library
constexpr std::size_t kMostThreads = 8;  // boxes seldom need more chunks at once
constexpr std::size_t kRowsBehind = 8;   // boxes by which one reader of rows may lag another

/// Undoes the shuffle filter, which stores first the first bytes of all floats, then the second
/// ones and so on.
void unshuffle(std::span<const std::byte> shuffled, std::span<float> values) {
    const std::size_t n = values.size();
    const std::byte* from = shuffled.data();
    for (std::size_t i = 0; i < n; ++i) {
        const auto byte = [&](std::size_t which) {
            return std::to_integer<std::uint32_t>(from[which * n + i]);
        };
        values[i] = std::bit_cast<float>(byte(0) | byte(1) << 8U | byte(2) << 16U | byte(3) << 24U);
    }
}

}  // namespace

/// Inflates chunks one after the other with one set of buffers.
class DeflatedFloats::Inflater {
  public:
    Inflater() : decompressor_(libdeflate_alloc_decompressor()) {}
    ~Inflater() { libdeflate_free_decompressor(decompressor_); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    bool inflate(std::span<const std::byte> stored, bool shuffled, std::span<float> values) {
        if (decompressor_ == nullptr) return false;
        if (!shuffled) return inflateTo(stored, std::as_writable_bytes(values));
        bytes_.resize(values.size_bytes());  // the same for all chunks of a variable
        if (!inflateTo(stored, bytes_)) return false;
        unshuffle(bytes_, values);
        return true;
    }

  private:
    bool inflateTo(std::span<const std::byte> stored, std::span<std::byte> bytes) {
        std::size_t got = 0;
        return libdeflate_zlib_decompress(decompressor_, stored.data(), stored.size(), bytes.data(),
                                          bytes.size(), &got) == LIBDEFLATE_SUCCESS &&
               got == bytes.size();
    }
    libdeflate_decompressor* decompressor_;
    std::vector<std::byte> bytes_;
};

/// HDF5 demands the degree of closing that NetCDF chose, which depends on its version.
hid_t DeflatedFloats::fileOf(const std::string& path) {
    hid_t file = -1;
    for (const H5F_close_degree_t degree : {H5F_CLOSE_WEAK, H5F_CLOSE_SEMI, H5F_CLOSE_STRONG}) {
        if (file >= 0) break;
        const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
        H5Pset_fclose_degree(access, degree);
        file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
        H5Pclose(access);
    }
    return file;
}

std::unique_ptr<DeflatedFloats> DeflatedFloats::of(hid_t file, const std::string& name,
                                                   std::span<const std::size_t> shape,
                                                   std::span<const std::size_t> chunk) {
    if (shape.empty() || shape.size() != chunk.size() || std::ranges::count(chunk, 0U) > 0) {
        return nullptr;
    }
    const hid_t dataset = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
    if (dataset < 0) return nullptr;
    std::unique_ptr<DeflatedFloats> found(new DeflatedFloats(dataset, shape, chunk));
    return found->readFilters() ? std::move(found) : nullptr;
}

DeflatedFloats::DeflatedFloats(hid_t dataset, std::span<const std::size_t> shape,
                               std::span<const std::size_t> chunk)
    : dataset_(dataset), shape_(shape.begin(), shape.end()), chunk_(chunk.begin(), chunk.end()) {
    for (std::size_t axis = 0; axis < shape_.size(); ++axis) {
        chunks_.push_back((shape_[axis] + chunk_[axis] - 1) / chunk_[axis]);
        chunkCells_ = std::min(chunkCells_ * std::min(chunk_[axis], kMostChunkBytes),
                               kMostChunkBytes);  // no overflow: both are below 2^30
    }
    const std::size_t rank = shape_.size();
    std::size_t row = chunks_.back();
    if (rank >= 3) row *= chunks_[rank - 3];
    mostKept_ = std::min(2 * row, kMostBytes / (chunkCells_ * sizeof(float)));
}

DeflatedFloats::~DeflatedFloats() {
    H5Dclose(dataset_);
}

/// False unless the data set is what of() promises.
bool DeflatedFloats::readFilters() {
    if (std::endian::native != std::endian::little ||
        chunkCells_ * sizeof(float) > kMostChunkBytes) {
        return false;
    }
    const hid_t type = H5Dget_type(dataset_);
    const bool floats = H5Tequal(type, H5T_IEEE_F32LE) > 0;
    H5Tclose(type);
    const hid_t space = H5Dget_space(dataset_);
    const bool ranked = H5Sget_simple_extent_ndims(space) == static_cast<int>(shape_.size());
    H5Sclose(space);
    if (!floats || !ranked) return false;
    const hid_t list = H5Dget_create_plist(dataset_);
    std::array<hsize_t, H5S_MAX_RANK> chunk{};
    bool fits = H5Pget_layout(list) == H5D_CHUNKED &&
                H5Pget_chunk(list, H5S_MAX_RANK, chunk.data()) == static_cast<int>(shape_.size()) &&
                std::equal(chunk_.begin(), chunk_.end(), chunk.begin());
    const int filters = H5Pget_nfilters(list);
    for (int i = 0; i < filters; ++i) {
        unsigned flags = 0, config = 0;
        std::size_t values = 0;
        const H5Z_filter_t id = H5Pget_filter2(list, static_cast<unsigned>(i), &flags, &values,
                                               nullptr, 0, nullptr, &config);
        const bool last = i + 1 == filters;
        shuffled_ = shuffled_ || id == H5Z_FILTER_SHUFFLE;
        fits = fits && (last ? id == H5Z_FILTER_DEFLATE : i == 0 && id == H5Z_FILTER_SHUFFLE);
    }
    H5Pclose(list);
    return fits && filters > 0;
}

template <typename Visit>
void DeflatedFloats::eachChunk(std::span<const std::size_t> start,
                               std::span<const std::size_t> count, Visit&& visit) const {
    const std::size_t rank = shape_.size();
    std::vector<std::size_t> at(rank);
    for (std::size_t axis = 0; axis < rank; ++axis) at[axis] = start[axis] / chunk_[axis];
    for (;;) {
        std::size_t index = 0;
        std::vector<std::size_t> origin(rank);
        for (std::size_t axis = 0; axis < rank; ++axis) {
            index = index * chunks_[axis] + at[axis];
            origin[axis] = at[axis] * chunk_[axis];
        }
        if (!visit(index, origin)) return;
        std::size_t axis = rank;
        for (; axis-- > 0; at[axis] = start[axis] / chunk_[axis]) {
            if (++at[axis] * chunk_[axis] < start[axis] + count[axis]) break;
        }
        if (axis >= rank) return;
    }
}

std::optional<std::vector<DeflatedFloats::Stored>> DeflatedFloats::fetch(
    std::span<const std::size_t> start, std::span<const std::size_t> count) {
    for (std::size_t axis = 0; axis < shape_.size(); ++axis) {
        if (count[axis] == 0 || count[axis] > shape_[axis] ||
            start[axis] > shape_[axis] - count[axis]) {
            return {};
        }
    }
    std::vector<Stored> needed;
    bool whole = true;
    std::size_t met = 0;
    eachChunk(start, count, [&](std::size_t index, std::span<const std::size_t> origin) {
        ++met;
        if (kept_.contains(index)) return true;
        auto chunk = stored(index, origin);
        whole = chunk.has_value() && met * chunkCells_ * sizeof(float) <= kMostChunkBytes;
        if (whole) needed.push_back(std::move(*chunk));
        return whole;
    });
    if (!whole) return {};
    return needed;
}

std::optional<DeflatedFloats::Stored> DeflatedFloats::stored(
    std::size_t index, std::span<const std::size_t> origin) const {
    const std::vector<hsize_t> offset(origin.begin(), origin.end());
    haddr_t address = HADDR_UNDEF;
    hsize_t size = 0;
    unsigned mask = 0;
    const herr_t status =
        H5Dget_chunk_info_by_coord(dataset_, offset.data(), &mask, &address, &size);
    const std::size_t most = libdeflate_zlib_compress_bound(nullptr, chunkCells_ * sizeof(float));
    if (status < 0 || address == HADDR_UNDEF || size == 0 || size > most || mask != 0) return {};
    Stored chunk{index, std::vector<std::byte>(size)};
    std::uint32_t skipped = 0;
    if (H5Dread_chunk(dataset_, H5P_DEFAULT, offset.data(), &skipped, chunk.bytes.data()) < 0 ||
        skipped != 0) {
        return {};
    }
    return chunk;
}

/// Memory for one chunk.
DeflatedFloats::Cells DeflatedFloats::cells() {
    if (spare_.empty()) return std::make_unique_for_overwrite<float[]>(chunkCells_);
    Cells cells = std::move(spare_.back());
    spare_.pop_back();
    return cells;
}

bool DeflatedFloats::inflate(std::span<const Stored> chunks) {
    if (chunks.empty()) return true;
    std::vector<Cells> targets;
    while (targets.size() < chunks.size()) targets.push_back(cells());
    const std::size_t cores = std::max(std::thread::hardware_concurrency(), 1U);
    const std::size_t threads = std::min({cores, kMostThreads, chunks.size()});
    while (inflaters_.size() < threads) inflaters_.push_back(std::make_unique<Inflater>());
    std::atomic<std::size_t> next{0};
    std::atomic<bool> whole{true};
    const auto work = [&](Inflater& inflater) {
        for (std::size_t i = next++; i < chunks.size() && whole; i = next++) {
            const std::span<float> values(targets[i].get(), chunkCells_);
            if (!inflater.inflate(chunks[i].bytes, shuffled_, values)) whole = false;
        }
    };
    {
        std::vector<std::jthread> others;
        for (std::size_t i = 1; i < threads; ++i) {
            others.emplace_back([&work, this, i] { work(*inflaters_[i]); });
        }
        work(*inflaters_.front());
    }
    if (!whole) return false;
    for (std::size_t i = 0; i < chunks.size(); ++i) {
        kept_[chunks[i].index] = {std::move(targets[i]), use_};
    }
    return true;
}

void DeflatedFloats::copy(std::span<const std::size_t> start, std::span<const std::size_t> count,
                          std::span<float> values) {
    const std::size_t rank = shape_.size();
    ++use_;
    eachChunk(start, count, [&](std::size_t index, std::span<const std::size_t> origin) {
        Kept& chunk = kept_.at(index);
        chunk.lastUse = use_;
        std::vector<std::size_t> lower(rank), upper(rank);
        std::size_t runs = 1;
        for (std::size_t axis = 0; axis < rank; ++axis) {
            lower[axis] = std::max(start[axis], origin[axis]);
            upper[axis] = std::min(start[axis] + count[axis], origin[axis] + chunk_[axis]);
            if (axis + 1 < rank) runs *= upper[axis] - lower[axis];
        }
        const std::size_t length = upper.back() - lower.back();
        std::vector<std::size_t> at = lower;
        for (std::size_t run = 0; run < runs; ++run) {
            std::size_t from = 0, to = 0;
            for (std::size_t axis = 0; axis < rank; ++axis) {
                from = from * chunk_[axis] + at[axis] - origin[axis];
                to = to * count[axis] + at[axis] - start[axis];
            }
            std::memcpy(values.data() + to, chunk.values.get() + from, length * sizeof(float));
            for (std::size_t axis = rank - 1; axis-- > 0; at[axis] = lower[axis]) {
                if (++at[axis] < upper[axis]) break;
            }
        }
        return true;
    });
    dropPassed(start, count);
}

/// Row of chunks along y, the last axis but one.
std::size_t DeflatedFloats::rowOf(std::size_t index) const {
    return shape_.size() < 2 ? 0 : index / chunks_.back() % chunks_[shape_.size() - 2];
}

void DeflatedFloats::drop(std::size_t index) {
    const auto chunk = kept_.find(index);
    spare_.push_back(std::move(chunk->second.values));
    kept_.erase(chunk);
}

/// Rows are read from south to north, by a few readers that are a few boxes apart; anything else is
/// kept until there is too much.
void DeflatedFloats::dropPassed(std::span<const std::size_t> start,
                                std::span<const std::size_t> count) {
    const std::size_t rank = shape_.size();
    std::vector<std::size_t> passed;
    for (const auto& each : kept_) {
        if (rank < 2) break;
        const std::size_t end = (rowOf(each.first) + 1) * chunk_[rank - 2];
        if (end + kRowsBehind * count[rank - 2] <= start[rank - 2]) passed.push_back(each.first);
    }
    for (const std::size_t index : passed) drop(index);
    while (kept_.size() > mostKept_) {
        drop(std::ranges::min_element(kept_, {}, [](const auto& each) {
                 return each.second.lastUse;
             })->first);
    }
    const std::size_t room = mostKept_ - kept_.size();
    if (spare_.size() > room) spare_.resize(room);
}

}  // namespace nc
