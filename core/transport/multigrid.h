// multigrid.h: corrects a field by what sweeps on coarser grids say of its residual.
//
// A sweep K x + b carries light from a node to its neighbours well and through a thick cloud badly;
// the error of what it gave obeys delta = K (delta + residual), which coarse grids solve at a
// fraction of the work. With thick nodes the residual left after an update is found by a sweep of
// its own, and the error obeys error = K error + residual. docs/transport.md
#pragma once
#include <vector>

#include "core/transport/directions.h"
#include "core/transport/transport_level.h"

namespace neph {

/// What the correction of one cycle needs beside the levels.
struct MultigridPass {
    const LightDirections* directions = nullptr;  ///< the same as in the sweep that is corrected
    glm::dvec3 sunTravel{0.0};
    double groundAlbedo = 0.0;
    int sweepsPerLevel = 2;
    int threads = 1;
};

/// `levels` holds the finest first. Adds to `after`, which a sweep made of `before`, the
/// correction. Returns the correction of the coarsest level relative to the field, root mean
/// squares of l = 0; without coarse levels the relative change from `before` to `after`.
double correctByMultigrid(const std::vector<TransportLevel>& levels, const MultigridPass& pass,
                          const LightField& before, LightField& after);

/// The same for thick levels, of which there are several: `missing` is `missingFrom(field)`.
double correctThick(const std::vector<TransportLevel>& levels, const MultigridPass& pass,
                    const LightField& missing, LightField& field);

}  // namespace neph
