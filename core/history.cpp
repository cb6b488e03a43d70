// history.cpp: steps and their labels.
#include "core/history.h"

#include <fmt/format.h>

#include <utility>

namespace neph {
namespace {

std::string describeParameter(const Parameter& row, const Look& before, const Look& after) {
    std::string name = fmt::format("{}: {}", row.group, row.label);
    if (row.kind == ParameterKind::colour) return name;
    return fmt::format("{} {} -> {}", name, screenText(row, valueOf(before, row)),
                       screenText(row, valueOf(after, row)));
}

}  // namespace

std::string describeChange(const Document& before, const Document& after) {
    std::vector<std::string> changes;
    for (const Parameter& row : lookTable()) {
        if (valueOf(before.look, row) != valueOf(after.look, row)) {
            changes.push_back(describeParameter(row, before.look, after.look));
        }
    }
    if (before.camera != after.camera) changes.emplace_back("Camera");
    if (before.time != after.time) {
        changes.push_back(fmt::format("Time {} -> {}", before.time, after.time));
    }
    if (changes.empty()) return {};
    return changes.size() == 1 ? changes.front() : fmt::format("{} changes", changes.size());
}

void History::restart(const Document& document) {
    past_.clear();
    future_.clear();
    last_ = document;
}

void History::adapt(const std::function<void(Document&)>& change) {
    for (auto* steps : {&past_, &future_}) {
        for (Step& step : *steps) {
            change(step.before);
            change(step.after);
        }
    }
    change(last_);
}

void History::commit(const Document& document, std::string label) {
    if (document == last_) return;
    if (label.empty()) label = describeChange(last_, document);
    past_.push_back({last_, document, std::move(label)});
    if (past_.size() > kMaxSteps) past_.erase(past_.begin());
    future_.clear();
    last_ = document;
}

bool History::undo(Document& document) {
    commit(document);
    if (past_.empty()) return false;
    document = last_ = past_.back().before;
    future_.push_back(std::move(past_.back()));
    past_.pop_back();
    return true;
}

bool History::redo(Document& document) {
    commit(document);
    if (future_.empty()) return false;
    document = last_ = future_.back().after;
    past_.push_back(std::move(future_.back()));
    future_.pop_back();
    return true;
}

}  // namespace neph
