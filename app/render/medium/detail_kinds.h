// detail_kinds.h: which of several details can be read from the noise at once.
#pragma once
#include <algorithm>
#include <glm/glm.hpp>
#include <vector>

#include "core/optics/noise.h"

namespace neph::render {

/// The noise that a species or a class has.
struct Detail {
    float amount = 0.0f;
    float scaleM = 1.0f;
    glm::vec2 fit{1.0f};  ///< MediumClass::noiseFit
    NoiseCharacter character = NoiseCharacter::billow;
};

/// Details of one scale and character are of one kind; one of no amount is of whichever is there.
struct DetailKinds {
    std::vector<int> of;     ///< kind of each detail
    std::vector<int> first;  ///< a detail of each kind
};

inline DetailKinds kindsOf(const std::vector<Detail>& details) {
    DetailKinds kinds;
    for (std::size_t i = 0; i < details.size(); ++i) {
        const Detail& mine = details[i];
        const auto same = [&](int other) {
            const Detail& theirs = details[static_cast<std::size_t>(other)];
            return mine.amount == 0.0f ||
                   (theirs.scaleM == mine.scaleM && theirs.character == mine.character);
        };
        auto found = std::find_if(kinds.first.begin(), kinds.first.end(), same);
        if (found == kinds.first.end()) found = kinds.first.insert(found, static_cast<int>(i));
        kinds.of.push_back(static_cast<int>(found - kinds.first.begin()));
    }
    return kinds;
}

}  // namespace neph::render
