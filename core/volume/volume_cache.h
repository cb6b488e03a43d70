// volume_cache.h: volumes that were read; the least recently used is dropped first.
//
// Used by one thread. Volumes are shared: a user keeps a volume alive beyond the cache.
#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <list>
#include <memory>
#include <string>

#include "core/volume/held_volume.h"

namespace neph {

/// What determines a volume: equal keys give equal volumes while the file is unchanged.
struct VolumeKey {
    int indexInFile = 0;
    std::string file;
    VolumeRequest request;
    bool operator==(const VolumeKey&) const = default;
};

/// The same, whether humidity was read or not.
VolumeKey withHumidity(VolumeKey key, bool humidity);

/// A least-recently-used cache of volumes.
class VolumeCache {
  public:
    /// Largest total size of fields, bytes; the newest volume is kept in any case.
    void setLimit(std::uint64_t bytes);
    std::uint64_t limit() const { return limit_; }

    /// Adds a volume as the newest, or replaces it; drops the oldest until the rest fits. One with
    /// humidity also replaces the one without.
    void put(VolumeKey key, std::shared_ptr<const HeldVolume> volume);
    /// The volume, which becomes the newest; nullptr if it is not in the cache. One with humidity
    /// is found by a key without, too.
    std::shared_ptr<const HeldVolume> find(const VolumeKey& key);
    bool holds(const VolumeKey& key) const;

    /// Drops the volumes for which `which` is true.
    void drop(const std::function<bool(const VolumeKey&)>& which);
    void clear() {
        drop([](const VolumeKey&) { return true; });
    }

    std::uint64_t bytes() const { return bytes_; }
    std::size_t count() const { return entries_.size(); }

  private:
    struct Entry {
        VolumeKey key;
        std::shared_ptr<const HeldVolume> volume;
    };
    void shrink();

    std::list<Entry> entries_;  // newest first
    std::uint64_t limit_ = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t bytes_ = 0;
};

}  // namespace neph
