// render_view.cpp: observers and views from their spelling on the command line.
#include "app/cli/render/render_view.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

#include "app/cli/common/usage.h"
#include "core/base/names.h"
#include "core/volume/framing.h"

namespace neph {
namespace {

constexpr double kMPerKm = 1000.0;
constexpr double kFarKm = 1e5;  // beyond any domain

struct Number {
    const char* name;
    double lo, hi;
};
constexpr std::array<Number, 6> kNumbers{
    {{"east, km", -kFarKm, kFarKm},
     {"north, km", -kFarKm, kFarKm},
     {"height, m", -kFarKm, kFarKm* kMPerKm},
     {"azimuth, degrees", -360.0, 360.0},
     {"elevation, degrees", -90.0, 90.0},
     {"field of view, degrees", static_cast<double>(kMinFovDeg), static_cast<double>(kMaxFovDeg)}}};

[[noreturn]] void refuse(const std::string& what, const std::string& found) {
    throw UsageError({"--observer", what, found,
                      "east,north,height,azimuth,elevation[,fov] in km, km, m and degrees",
                      "as --observer 20,5,2,45,10: 20 km east and 5 km north of the domain's "
                      "south-west corner, looking north-east"});
}

}  // namespace

Observer parseObserver(const std::string& text) {
    std::vector<double> values;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (values.size() < kNumbers.size()) {
        const Number& number = kNumbers[values.size()];
        double value = 0.0;
        const auto [stop, fault] = std::from_chars(at, end, value);
        if (fault != std::errc{}) refuse(fmt::format("{} cannot be read", number.name), text);
        if (!(value >= number.lo && value <= number.hi)) {
            refuse(fmt::format("{} is not between {} and {}", number.name, number.lo, number.hi),
                   text);
        }
        values.push_back(value);
        at = stop;
        if (at == end || *at != ',') break;
        ++at;
    }
    if (at != end || values.size() < 5) refuse("needs five or six numbers", text);
    Observer observer{values[0] * kMPerKm, values[1] * kMPerKm, values[2], values[3], values[4]};
    if (values.size() == 6) observer.fovDeg = values[5];
    return observer;
}

View parseView(const std::string& name) {
    const auto found = std::ranges::find(kViewNames, name);
    if (found != kViewNames.end()) return static_cast<View>(found - kViewNames.begin());
    const std::string_view near = nearestName(name, kViewNames);
    throw UsageError({"--view", "is not known", name,
                      fmt::format("one of {}", fmt::join(kViewNames, ", ")),
                      near.empty() ? "" : fmt::format("did you mean {}?", near)});
}

RenderView firstView(const RenderView& asked, const Scene& scene) {
    if (asked.given() || scene.cameraAsked) return asked;
    return {.observer = {}, .view = View::fit};
}

CameraPose poseOf(const RenderView& from, const CameraPose& pose, const VolumeSummary& shown,
                  const Look& look, double aspect) {
    if (from.view) {
        return framed(*from.view, pose, shown, look, aspect);
    }
    if (!from.observer) return pose;
    if (const auto stood = poseOf(*from.observer, shown.grid)) {
        CameraPose seen = pose;
        takeView(seen, *stood);
        return seen;
    }
    const glm::dvec3 lower = shown.grid.originM / kMPerKm, upper = shown.grid.upperM() / kMPerKm;
    throw UsageError(
        {"--observer", "is too far from the domain", "",
         "a view that meets the domain, or one domain's width around it",
         fmt::format("the domain goes from {:.4g} to {:.4g} km east and from {:.4g} to {:.4g} "
                     "km north",
                     lower.x, upper.x, lower.y, upper.y)});
}

}  // namespace neph
