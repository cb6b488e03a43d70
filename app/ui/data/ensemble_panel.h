// ensemble_panel.h: the window with the maps of an ensemble: probability, mean and spread of the
// optical depth, read in the background.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/panel/panel_context.h"
#include "core/base/jobs.h"
#include "core/plot/figure.h"
#include "core/volume/ensemble_maps.h"

namespace neph::ui {

/// What depths are of: those of another are read again.
struct EnsembleKey {
    const DatasetInfo* data = nullptr;
    int time = 0;
    VolumeRequest request;
    std::array<float, kSpeciesCount> extinctionPerHeld{};
    bool operator==(const EnsembleKey&) const = default;
};

struct EnsemblePanel {
    EnsembleMap map = EnsembleMap::probability;
    float threshold = 1.0f;
    std::string file = "ensemble.nc";  ///< to be written, as typed

    std::shared_ptr<const EnsembleDepths> depths;  ///< read last; nullptr before
    std::optional<EnsembleKey> readOf, wantedOf;   ///< of `depths`, and of what is being read
    std::optional<EnsembleKey> left;               ///< cancelled or failed: not read by itself
    std::string fault;
    std::unique_ptr<Jobs> jobs;

    plot::Figure figure;  ///< of `depths`
    std::vector<GeoPoint> places;
    bool stale = true;  ///< the figure is of other choices
};

/// The window; closing it sets `shown` to false and stops what is being read.
void drawEnsemble(const PanelContext& context, EnsemblePanel& panel, bool& shown);

}  // namespace neph::ui
