// compare_options.h: what `nephoscope compare` is told, as typed, and what of it is wrong from the
// start.
#pragma once
#include <string>
#include <vector>

#include "app/cli/render/render_options.h"

namespace neph {

struct ComparisonOptions {
    std::vector<std::string> engines;  ///< as parseEngines, each may be a list; none: two pictures
    /// Of the pictures that engines draw; the scene's files are the two pictures where none do.
    RenderOptions render;
    bool json = false;
    std::string errorPicture;  ///< a PNG file; empty: none, here and below
    bool bothSigns = false;    ///< in pictures of errors
    std::string errorTo;       ///< percent at the end of their scale; empty: a number that fits
    std::string flipPicture;
    std::string exposureEv;  ///< of HDR-FLIP; empty: the reference's own
    std::string out;         ///< folder for all that engines draw
};

/// An engine, and what it changes of the look.
struct ComparedEngine {
    std::string name;                      ///< as typed
    std::vector<std::string> assignments;  ///< id=value, of which the first is view.engine
};

/// From "slicing:light.form=printed,march,reference": names of engines between commas, each
/// followed by assignments, a colon before each. At least two. Throws UsageError.
std::vector<ComparedEngine> parseEngines(const std::vector<std::string>& texts);

/// A finite number, or none where `text` is empty. Throws UsageError that names the option.
std::optional<double> parseOptionalNumber(const std::string& option, const std::string& text);

/// Samples of an engine: those that the window averages for the march, and paths of the reference
/// as typed.
SamplePlan planSamples(const ComparisonOptions& options, const ParameterSet& drawn);

/// Throws UsageError.
void checkOptions(const ComparisonOptions& options);

}  // namespace neph
