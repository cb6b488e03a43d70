// slots.cpp: making, choosing and linking slots.
//
// Poses are shares of the domain, so linked cameras see the same part of domains that differ.
// Linked times meet by their labels; where the other series has no such time it takes as many
// steps.
#include "app/workbench/slots.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace neph {
namespace {

int indexOf(const DatasetInfo& info, const std::string& label) {
    const auto found = std::ranges::find(info.times, label, &TimeInfo::label);
    return found == info.times.end() ? -1 : static_cast<int>(found - info.times.begin());
}

SlotState stateOf(const Session& session) {
    return {session.named(),       session.region(), session.presetName, session.document, 0,
            session.namesMembers()};
}

}  // namespace

Slots::Slots(ui::CompareState& compare, const Make& make) : compare_(compare), make_(make) {
    slots_[0] = make_();
}

std::vector<Slot*> Slots::all() {
    std::vector<Slot*> slots{slots_[0].get()};
    if (slots_[1]) slots.push_back(slots_[1].get());
    return slots;
}

std::vector<ShownImage> Slots::shown(const PixelBox& place) {
    if (!slots_[1]) return {{slots_[0].get(), place}};
    if (compare_.mode == CompareMode::flicker) {
        return {{slots_[compare_.flickered == 0 ? 0 : 1].get(), place}};
    }
    if (compare_.mode != CompareMode::split) {
        return {{compare_.peeking ? other() : &active(), place}};
    }
    const float at = std::clamp(compare_.splitAt, 0.0f, 1.0f);
    const int column =
        place.lower.x + static_cast<int>(std::lround(at * static_cast<float>(place.size().x)));
    return {{slots_[0].get(), {place.lower, {column, place.upper.y}}, {0.0f, at}},
            {slots_[1].get(), {{column, place.lower.y}, place.upper}, {at, 1.0f}}};
}

Slot& Slots::seen() {
    return compare_.mode == CompareMode::single ? *shown({}).front().slot : active();
}

ui::PairState Slots::pair() const {
    if (!slots_[1]) return {};
    const Slot &a = *slots_[0], &b = *slots_[1];
    const auto rests = [](const Slot& slot) { return slot.waiting(false) == Slot::Waiting::no; };
    ui::PairState state;
    state.a = a.images();
    state.b = b.images();
    state.whole = a.whole() && b.whole() && a.report.sizePx == b.report.sizePx;
    state.settled = state.whole && rests(a) && rests(b);
    if (b.converges()) state.traced = b.report.reference;
    return state;
}

bool Slots::updatePreviews(bool wanted, ui::PreviewMarks& marks) {
    bool changed = false;
    marks = {};
    for (std::size_t i = 0; i < slots_.size(); ++i) {
        if (!slots_[i]) continue;
        changed |= slots_[i]->updatePreview(wanted);
        marks.possible[i] = slots_[i]->canPreview();
        marks.samples[i] = slots_[i]->report.previewSamples;
    }
    return changed;
}

bool Slots::rest() {
    if (seen().measures() && !seen().report.error) return false;
    return std::ranges::all_of(all(), [](const Slot* slot) {
        return !slot->session.loading() && !slot->denoises() &&
               slot->waiting(false) == Slot::Waiting::no;
    });
}

void Slots::needSecond() {
    if (slots_[1]) return;
    slots_[1] = make_();
    slots_[1]->session.copyFrom(slots_[0]->session);
    compare_.second = true;
}

/// Again, so that nothing of what B was comes in later.
void Slots::traceInB() {
    slots_[1].reset();
    needSecond();
    Session& traced = slots_[1]->session;
    traced.document.look.engine = groundTruth();
    traced.history.restart(traced.document);
    compare_.mode = CompareMode::split;
    compare_.linkedCameras = compare_.linkedTimes = compare_.figures = true;
    compare_.active = 0;
    compare_.wanted = linkedTime_ = -1;
}

bool Slots::carryOut() {
    const int before = compare_.active;
    if (std::exchange(compare_.trace, false)) traceInB();
    if (compare_.wanted >= 0) {
        if (compare_.wanted == 1) needSecond();
        compare_.active = compare_.wanted;
        compare_.wanted = -1;
    }
    if (compare_.close) {
        compare_.close = compare_.second = compare_.peeking = compare_.figures = false;
        compare_.mode = CompareMode::single;
        compare_.active = 0;
        slots_[1].reset();
    }
    return compare_.active != before;
}

void Slots::link() {
    for (std::size_t i = 0; i < slots_.size(); ++i) {
        const Ensemble* ensemble = slots_[i] ? slots_[i]->session.ensemble() : nullptr;
        compare_.members[i] =
            ensemble ? ensemble->nameOf(slots_[i]->session.document.member) : std::string();
    }
    Slot* follower = other();
    if (follower == nullptr) return;
    const Session& leader = active().session;
    Session& led = follower->session;
    if (compare_.linkedCameras) {
        led.document.camera = leader.document.camera;
        if (leader.shown() && led.shown()) {
            const RegularGrid &from = leader.shown()->grid, &to = led.shown()->grid;
            keepOnGround(led.document.camera, to, to.movedM - from.movedM);
        }
    }
    const int time = leader.document.time;
    const int stepped =
        linkedTime_ < 0 || linkedActive_ != compare_.active ? 0 : time - linkedTime_;
    linkedTime_ = time;
    linkedActive_ = compare_.active;
    if (!compare_.linkedTimes || stepped == 0 || !leader.info() || !led.info()) return;
    const int same =
        indexOf(*led.info(), leader.info()->times[static_cast<std::size_t>(time)].label);
    const int last = static_cast<int>(led.info()->times.size()) - 1;
    led.document.time = same >= 0 ? same : std::clamp(led.document.time + stepped, 0, last);
}

SessionState Slots::state() const {
    SessionState state;
    for (const auto& slot : slots_) {
        if (slot) state.slots.push_back(stateOf(slot->session));
    }
    state.active = compare_.active;
    const bool split = compare_.mode == CompareMode::split;
    state.compare = split ? CompareMode::split : CompareMode::single;
    state.splitAt = compare_.splitAt;
    state.linkedCameras = compare_.linkedCameras;
    state.linkedTimes = compare_.linkedTimes;
    return state;
}

void Slots::restore(const SessionState& state) {
    if (state.slots.empty()) return;
    compare_ = {};
    slots_[1].reset();
    if (state.slots.size() > 1) slots_[1] = make_();
    for (std::size_t i = 0; i < std::min(slots_.size(), state.slots.size()); ++i) {
        const SlotState& kept = state.slots[i];
        Session& session = slots_[i]->session;
        session.document = kept.document;
        session.homeCamera = kept.document.camera;
        session.history.restart(kept.document);
        session.openAs({.named = kept.data,
                        .members = kept.members,
                        .time = kept.document.time,
                        .member = kept.document.member,
                        .region = kept.region,
                        .keepsView = true});
        session.takeMetres(kept.inMetres);  // of the data that are being opened
        session.setPreset(kept.presetName);
    }
    compare_.second = slots_[1] != nullptr;
    compare_.active = compare_.second ? std::clamp(state.active, 0, 1) : 0;
    compare_.mode = compare_.second ? state.compare : CompareMode::single;
    compare_.splitAt = state.splitAt;
    compare_.linkedCameras = state.linkedCameras;
    compare_.linkedTimes = state.linkedTimes;
    linkedTime_ = -1;
}

}  // namespace neph
