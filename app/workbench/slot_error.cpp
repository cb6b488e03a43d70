// slot_error.cpp: the error of a slot's image, which is measured beside it and goes when it does.
#include <utility>

#include "app/workbench/slot.h"
#include "core/image/box_average.h"

namespace neph {
namespace {

constexpr double kMostTracingS =
    120.0;  // of tracing; half the standard error would take four times

}  // namespace

void Slot::toggleError() {
    const bool stops = measures();
    stopMeasuring();
    if (stops) return;
    forgetError();
    unmeasurable_ = 0;
    wantsError_ = true;
}

bool Slot::isMeasurable() const {
    const bool known = report.error && !measurement_;
    return whole() && waiting(false) == Waiting::no && !known && images_ != unmeasurable_ &&
           !traitsOf(session.document.look.engine).groundTruth;
}

void Slot::stopMeasuring() {
    measurement_.reset();
    wantsError_ = false;
}

void Slot::forgetError() {
    measurement_.reset();
    errorMap_.reset();
    report.error.reset();
}

void Slot::beginToMeasure() {
    BoxAverage average(report.sizePx, ErrorMeasurement::sizeFor(report.sizePx));
    average.add(renderer_.readLinear());
    DrawRequest request;
    request.placePx = placePx_;
    measurement_.emplace(renderer_, inputsOf(*drawn_, request), average.mean(), kMostTracingS);
}

void Slot::measureError(const Progress& progress) {
    try {
        if (!measurement_) beginToMeasure();
        if (measurement_->trace(progress)) {
            report.error = measurement_->result();
            errorMap_ = std::make_shared<const ui::ErrorMap>(
                ui::errorMapOf(report.error->sizePx, measurement_->map()));
        }
        report.gpuBytes = renderer_.gpuBytes() + measurement_->bytes();
        if (measurement_->finished()) stopMeasuring();
    } catch (const Cancelled&) {
        report.gpuBytes = renderer_.gpuBytes() + measurement_->bytes();
    } catch (const Error& error) {
        stopMeasuring();
        unmeasurable_ = images_;
        session.say(Message::Kind::warning, "The error cannot be measured: " + error.message());
    }
}

}  // namespace neph
