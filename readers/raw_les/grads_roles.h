// grads_roles.h: what the variables of a descriptor mean, and what has to be said about those that
// mean something and are not used.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "readers/les/contents.h"
#include "readers/les/names.h"
#include "readers/les/terrain.h"
#include "readers/raw_les/grads_ctl.h"

namespace les {

/// A variable with a known meaning that can be used.
struct Meaning {
    const KnownVariable* known = nullptr;
    shared::Conversion toSi;
};

/// Decides on one variable after another, then on all together.
class GradsRoles {
  public:
    /// `levels`: of the grid. `hail`: qg holds hail.
    GradsRoles(std::size_t levels, bool hail) : levels_(levels), hail_(hail) {}

    /// The meaning of a variable; nothing if it has none or cannot be used, which a note will say.
    /// Throws Error for a hydrometeor or air in an unknown unit.
    std::optional<Meaning> meaningOf(const CtlVariable& variable);

    /// Adds a variable with its meaning, if it has one, to the contents.
    void add(const CtlVariable& variable, const std::optional<Meaning>& meaning, Source source,
             Contents& contents);

    /// Adds sums of categories, resolves what is there twice, and notes what is not used.
    void finish(Contents& contents) const;

    const Terrain& terrain() const { return terrain_; }

  private:
    std::size_t levels_;
    bool hail_;
    Terrain terrain_;
    std::vector<std::string> onePlane_, fewLevels_, otherUnit_, unknown_;
};

}  // namespace les
