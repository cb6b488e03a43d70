// profile.h: what an image cost, as rows of text, for the overlay and for `render --profile`.
#pragma once
#include <string>
#include <vector>

namespace neph::ui {

struct ProfileRow {
    std::string label, value, note;  ///< "light", "12.30 ms", "29 %"
    double share = 0.0;              ///< of the frame's time, at most 1
    bool old = false;                ///< of an earlier image: this one did without
};

struct Profile {
    std::string engine, device;
    std::vector<ProfileRow> image;    ///< size, time
    std::string error;                ///< as it was measured, or as far as it is known
    std::vector<ProfileRow> passes;   ///< in the order they run
    std::vector<ProfileRow> samples;  ///< of the eye pass, where the engine counts them
    std::vector<ProfileRow> memory;   ///< on the GPU: all, then the parts
    std::string redone;               ///< "light > eye > resolve"
};

/// Takes over the profile of a newer image. Passes and samples that it did without stay, as old
/// ones, while the engine is the same. `afterChange`: something was changed before it; else it
/// refines the image before, and what the last change redid stays.
void update(Profile& shown, Profile next, bool afterChange);

}  // namespace neph::ui
