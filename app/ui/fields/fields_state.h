// fields_state.h: what the panels of fields and parameters keep between frames.
#pragma once
#include <array>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "core/camera/camera.h"
#include "core/look/look.h"
#include "core/optics/phase.h"
#include "core/volume/held_volume.h"
#include "core/volume/optical_depth.h"

namespace neph::ui {

/// A phase function as it is plotted; droplets take a while and are computed beside the panels.
struct PhaseCurve {
    struct Made {
        PhaseSpec spec;
        PhaseTable table;
        float asymmetry = 0.0f;
    };
    std::optional<Made> made;
    std::future<Made> making;
};

/// Optical depths along the middle of the view, and what they were computed from.
struct DepthProbe {
    std::weak_ptr<const HeldVolume> volume;
    CameraPose pose;
    Look look;
    std::optional<OpticalDepth> depth;
};

struct FieldsState {
    Look atPress;  ///< as it was before the user took hold of what it holds
    std::array<bool, kSpeciesCount> beforeSolo{};
    bool linkLiquid = false, linkIce = false;
    bool polar = true;  ///< phase functions; else over the angle
    std::array<PhaseCurve, kSpeciesCount> curves;
    DepthProbe probe;
    std::string find;  ///< part of the parameter that is looked for
};

}  // namespace neph::ui
