// measure_error.cpp: images and input come first, whatever is asked for.
#include "app/workbench/measure_error.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace neph {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kLeastRestS = 1.0;  // of the image, before its error is measured unasked
constexpr std::chrono::milliseconds kMoment{50};

/// Whether the error of what is seen is wanted: asked for, or because nothing else is done.
bool isErrorWanted(const ui::Ui& ui, Slots& slots) {
    if (slots.seen().wantsError()) return true;
    if (!ui.errorMeter.map && !ui.errorMeter.atRest(ui.settings)) return false;
    return slots.seen().restS() >= kLeastRestS &&
           std::ranges::all_of(slots.all(), [](const Slot* slot) {
               return slot->waiting(false) == Slot::Waiting::no && !slot->session.loading();
           });
}

}  // namespace

bool measureError(ui::Ui& ui, Slots& slots, bool idle, const std::function<bool()>& inputWaits) {
    ui::ErrorMeter& meter = ui.errorMeter;
    Slot& seen = slots.seen();
    if (std::exchange(meter.toggled, false)) seen.toggleError();
    const bool wanted = isErrorWanted(ui, slots);
    // One reference at a time is held in memory.
    for (Slot* slot : slots.all()) {
        if (slot != &seen || !wanted) slot->stopMeasuring();
    }
    const bool works = wanted && idle && !seen.session.loading() && !seen.changedSinceLastLook() &&
                       seen.isMeasurable();
    if (works) {
        const Clock::time_point start = Clock::now();
        seen.measureError([&](double) { return Clock::now() - start < kMoment && !inputWaits(); });
        ui.next.again(ui::kLookS);
    }
    meter.measures = seen.measures();
    meter.found = seen.errorMap();
    ui.profile.error = seen.report.error ? errorText(*seen.report.error) : seen.report.knownError;
    return works;
}

}  // namespace neph
