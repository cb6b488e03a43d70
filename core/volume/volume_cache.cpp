// volume_cache.cpp: a list in order of use; the few entries need no index.
#include "core/volume/volume_cache.h"

#include <algorithm>

namespace neph {
namespace {

/// Whether what `held` stands for has all that `wanted` asks for.
bool serves(const VolumeKey& held, const VolumeKey& wanted) {
    return held == wanted || (held.request.humidity && held == withHumidity(wanted, true));
}

}  // namespace

VolumeKey withHumidity(VolumeKey key, bool humidity) {
    key.request.humidity = humidity;
    return key;
}

void VolumeCache::setLimit(std::uint64_t bytes) {
    limit_ = bytes;
    shrink();
}

void VolumeCache::put(VolumeKey key, std::shared_ptr<const HeldVolume> volume) {
    drop([&key](const VolumeKey& other) { return serves(key, other); });
    bytes_ += volume->volume->bytes();
    entries_.push_front({std::move(key), std::move(volume)});
    shrink();
}

std::shared_ptr<const HeldVolume> VolumeCache::find(const VolumeKey& key) {
    const auto found =
        std::ranges::find_if(entries_, [&](const Entry& entry) { return serves(entry.key, key); });
    if (found == entries_.end()) return nullptr;
    entries_.splice(entries_.begin(), entries_, found);
    return entries_.front().volume;
}

bool VolumeCache::holds(const VolumeKey& key) const {
    return std::ranges::any_of(entries_,
                               [&](const Entry& entry) { return serves(entry.key, key); });
}

void VolumeCache::drop(const std::function<bool(const VolumeKey&)>& which) {
    entries_.remove_if([&](const Entry& entry) {
        const bool given = which(entry.key);
        if (given) bytes_ -= entry.volume->volume->bytes();
        return given;
    });
}

/// The newest volume stays even if it is larger than the limit: it is the one that is shown.
void VolumeCache::shrink() {
    while (bytes_ > limit_ && entries_.size() > 1) {
        bytes_ -= entries_.back().volume->volume->bytes();
        entries_.pop_back();
    }
}

}  // namespace neph
