// render_error.cpp: the measurement that the window makes, from beginning to end.
#include "app/cli/render/render_error.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/workbench/error_measurement.h"
#include "core/base/error.h"

namespace neph {

std::optional<MeasuredError> errorOf(const Bands& bands, double seconds, const Progress& progress) {
    const DrawnSide& side = bands.sides().front();
    try {
        ErrorMeasurement measurement(*side.renderer, side.inputs, bands.averaged(), seconds);
        while (!measurement.finished()) measurement.trace(progress);
        return measurement.result();
    } catch (const Error& error) {
        fmt::print(stderr, "warning: the error cannot be measured: {}\n", error.message());
        return {};
    }
}

std::string errorJson(const MeasuredError& measured) {
    const ImageErrors& errors = measured.errors;
    const nlohmann::ordered_json json{{"bias", errors.bias},
                                      {"bias_sigma", errors.biasSigma},
                                      {"rel_rmse", errors.relRmse},
                                      {"rel_rmse_sigma", errors.relRmseSigma},
                                      {"noise_taken_off", errors.noise},
                                      {"width", measured.sizePx.x},
                                      {"height", measured.sizePx.y},
                                      {"paths", measured.paths},
                                      {"light_spread", measured.spread}};
    return json.dump();
}

}  // namespace neph
