// fields_plots.h: what an unfolded field shows besides its parameters: its phase function with the
// angle of the view on it, how much of it there is, and how deep it is along the view.
#pragma once
#include "app/ui/fields/fields_state.h"
#include "app/ui/panel/panel_context.h"
#include "core/plot/figure.h"

namespace neph::ui {

/// Angle by which sunlight is turned towards the eye at the middle of the image, radians: 0 looks
/// into the sun.
double scatteringAngle(const Document& document, const Whereabouts& where);

/// The curve of a field, as last computed; another is begun where its phase function is another,
/// and taken over when it is done.
const PhaseCurve::Made* curveOf(FieldsState& state, const Look& look, Species species);

/// Optical depths along the middle of the view, computed again when volume, look or camera changed;
/// none without data.
const std::optional<OpticalDepth>& probeDepth(FieldsState& state, const Session& session);

void drawPhasePlot(const PanelContext& context, FieldsState& state, Species species);
/// Cells by what they hold, both logarithmic; empty where there is nothing to count.
plot::Figure histogramFigure(const FieldHistogram& histogram);
void drawHistogram(const FieldHistogram& histogram);
void drawDepth(FieldsState& state, const Session& session, Species species);

}  // namespace neph::ui
