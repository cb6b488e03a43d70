// compare_request.h: what `nephoscope compare` is asked for. Filled once, by compare_arguments.cpp.
#pragma once
#include <string>
#include <vector>

#include "app/cli/render/render_request.h"

namespace neph {

/// An engine, and what it changes of the look.
struct ComparedEngine {
    std::string name;               ///< as typed
    std::vector<Setting> settings;  ///< of which the first is view.engine
};

struct CompareRequest {
    std::vector<ComparedEngine>
        engines;  ///< the last is the reference; none: two images, or members
    /// Of what is drawn; the scene's files are the two images where nothing is. Another member of
    /// its ensemble beside it is the reference.
    RenderRequest render;
    bool draws() const { return !engines.empty() || !render.beside.member.empty(); }
    bool json = false;
    std::filesystem::path errorImage;  ///< a PNG file; empty: none, here and below
    bool bothSigns = false;            ///< in images of errors
    std::optional<double> errorTo;     ///< share at the end of their scale; none: one that fits
    std::filesystem::path flipImage;
    std::optional<double> exposureEv;  ///< of HDR-FLIP; none: the reference's own
    std::filesystem::path out;         ///< folder for all that engines draw
};

/// From "slicing:light.form=printed,march,reference": names of engines between commas, each
/// followed by assignments, a colon before each. At least two. Throws UsageError.
std::vector<ComparedEngine> parseEngines(const std::vector<std::string>& texts);

/// Samples of an engine: those that the window averages for the march, and those of the reference
/// as asked for.
SamplePlan planSamples(const CompareRequest& request, const ParameterSet& drawn);

}  // namespace neph
