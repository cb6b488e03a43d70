// ask_state.h: what is asked of the storm, and what was answered.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "app/ui/ask/answer.h"
#include "core/analysis/column.h"
#include "core/analysis/figures.h"
#include "core/analysis/ray_probe.h"
#include "core/analysis/section.h"
#include "core/analysis/series.h"

namespace neph::ui {

/// One time of the data that a session has open.
struct AskedTime {
    std::shared_ptr<const Dataset> data;
    int time = 0;
    bool operator==(const AskedTime&) const = default;
};

struct ColumnQuestion {
    AskedTime when;
    glm::ivec2 column{0};
    bool operator==(const ColumnQuestion&) const = default;
};

struct SectionQuestion {
    AskedTime when;
    SectionCut cut;
    bool operator==(const SectionQuestion&) const = default;
};

/// What was asked for and found along the mouse's ray.
struct PointedAt {
    RayProbe ray;
    std::optional<glm::dvec3> groundM;  ///< where the ray meets the ground, if it does
};

struct SeriesQuestion {
    std::shared_ptr<const Dataset> data;
    bool operator==(const SeriesQuestion&) const = default;
};
/// As far as it has been read.
struct SeriesSoFar {
    std::vector<SeriesPoint> points;
    std::vector<std::string> labels;
};

struct PinsQuestion {
    AskedTime when;
    std::vector<glm::dvec3> positionsM;
    bool operator==(const PinsQuestion&) const = default;
};

struct AskState {
    bool pin = false;  ///< what the mouse points at is to be kept
    bool showPins = false;
    Answer<PinsQuestion, std::vector<ColumnReport>> pinned;  ///< the column of each

    bool probes = false;  ///< the mouse over the image tells what it points at
    Answer<ColumnQuestion, ColumnReport> pointed;  ///< the column where the probe meets cloud
    bool showColumn = false, showSection = false, showSeries = false;

    glm::dvec2 placeM{0.0};  ///< of columns; where the storm was last clicked
    bool placed = false;     ///< else the middle of the domain
    ParcelSource parcel = ParcelSource::mixedLayer;
    Answer<ColumnQuestion, ColumnReport> column;

    SectionCut section;
    bool lineGiven = false;  ///< else from west to east through the place
    bool drawing = false;    ///< the next drag over the image is the line
    Answer<SectionQuestion, CrossSection> cut;

    SeriesKind kind = SeriesKind::contents;
    Answer<SeriesQuestion, SeriesSoFar> series;
};

}  // namespace neph::ui
