// volume_cache.h: volumes that were read, the least recently used given up first.
//
// Used by one thread. Volumes are shared: whoever took one keeps it alive beyond the cache.
#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <list>
#include <memory>
#include <string>

#include "core/volume/held_volume.h"

namespace neph {

/// What a volume is made from: equal keys give equal volumes while the file stays as it is.
struct VolumeKey {
    int indexInFile = 0;
    std::string file;
    VolumeRequest request;
    bool operator==(const VolumeKey&) const = default;
};

class VolumeCache {
  public:
    /// Bytes of fields that are held at most, though the newest volume always is.
    void setLimit(std::uint64_t bytes);
    std::uint64_t limit() const { return limit_; }

    /// Adds as the newest, or replaces; gives up the oldest until the rest fits.
    void put(VolumeKey key, std::shared_ptr<const HeldVolume> volume);
    /// The volume, which becomes the newest; nullptr where it is not held.
    std::shared_ptr<const HeldVolume> find(const VolumeKey& key);
    bool holds(const VolumeKey& key) const;

    /// Gives up those that `which` is true for.
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
