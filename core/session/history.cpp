// history.cpp: undo steps and their labels.
#include "core/session/history.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "core/dataset/ensemble.h"

namespace neph {
namespace {

/// Joins parts in a list, with lower-case initials after the first.
std::string joined(const std::vector<std::string>& parts) {
    std::string text;
    for (std::string part : parts) {
        if (!text.empty()) {
            text += ", ";
            part.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(part[0])));
        }
        text += part;
    }
    return text;
}

std::string valuesText(const Parameter& row, const ParameterSet& before,
                       const ParameterSet& after) {
    if (row.kind == ParameterKind::colour) return {};
    return fmt::format(" {} -> {}", screenText(row, valueOf(before, row)),
                       screenText(row, valueOf(after, row)));
}

bool allSame(const std::vector<std::string>& texts) {
    return std::ranges::all_of(texts, [&](const std::string& text) { return text == texts[0]; });
}

/// "Cloud: Mixing scale 1 -> 0.5", "Cloud, Rain: Mixing scale", "Cloud: 3 parameters".
std::string describeParameters(const ParameterSet& before, const ParameterSet& after) {
    std::vector<std::string> labels, groups, values;
    for (const Parameter& row : parameterTable()) {
        if (valueOf(before, row) == valueOf(after, row)) continue;
        labels.push_back(row.label);
        groups.push_back(row.group);
        values.push_back(valuesText(row, before, after));
    }
    if (labels.empty()) return {};
    const bool oneLabel = allSame(labels);
    const std::string value = allSame(values) ? values.front() : std::string();
    if (oneLabel) return fmt::format("{}: {}{}", fmt::join(groups, ", "), labels.front(), value);
    if (allSame(groups)) return fmt::format("{}: {} parameters", groups.front(), labels.size());
    return fmt::format("{} parameters", labels.size());
}

std::string describeBookmarks(const std::vector<Bookmark>& before,
                              const std::vector<Bookmark>& after) {
    if (before == after) return {};
    const auto lacks = [](const std::vector<Bookmark>& list, const Bookmark& one) {
        return std::ranges::find(list, one.name, &Bookmark::name) == list.end();
    };
    if (after.size() == before.size() + 1 && lacks(before, after.back())) {
        return fmt::format("Bookmark \"{}\"", after.back().name);
    }
    if (after.size() + 1 == before.size()) {
        const auto gone =
            std::ranges::find_if(before, [&](const Bookmark& mark) { return lacks(after, mark); });
        if (gone != before.end()) return fmt::format("Bookmark \"{}\" removed", gone->name);
    }
    return after.empty() ? "Bookmarks removed" : "Bookmarks changed";
}

/// "3" for the third member.
std::string memberText(const Document& document) {
    return document.member == kMeanMember ? "mean" : fmt::format("{}", document.member + 1);
}

std::string describePath(const CameraPath& before, const CameraPath& after) {
    if (before == after) return {};
    const std::size_t was = before.keys.size(), is = after.keys.size();
    if (is == 0 && was > 0) return "Camera path removed";
    if (is == was + 1) return fmt::format("Camera path: key {} added", is);
    if (is + 1 == was) return "Camera path: a key removed";
    if (before.keys == after.keys) return "Camera path: time";
    return "Camera path changed";
}

}  // namespace

std::string describeChange(const Document& before, const Document& after) {
    std::vector<std::string> parts{describeParameters(before, after)};
    if (before.time != after.time) {
        parts.push_back(fmt::format("Time {} -> {}", before.time + 1, after.time + 1));
    }
    if (before.member != after.member) {
        parts.push_back(fmt::format("Member {} -> {}", memberText(before), memberText(after)));
    }
    if (before.camera != after.camera) parts.emplace_back("Camera");
    parts.push_back(describeBookmarks(before.bookmarks, after.bookmarks));
    parts.push_back(describePath(before.path, after.path));
    if (before.pins.size() < after.pins.size()) {
        parts.push_back(fmt::format("Pin \"{}\"", after.pins.back().label));
    } else if (before.pins != after.pins) {
        parts.emplace_back(before.pins.size() > after.pins.size() ? "Pin removed" : "Pin renamed");
    }
    std::erase(parts, std::string());
    return joined(parts);
}

void History::restart(const Document& document) {
    past_.clear();
    future_.clear();
    last_ = document;
}

/// All states change alike, so undo still leads to valid documents.
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

/// A drag is one step, not one per frame.
void History::settle(const Document& document, bool handDown, double restS) {
    const bool letGo = handDown_ && !handDown;
    handDown_ = handDown;
    if (letGo || (!handDown && restS > kRestS)) commit(document);
}

std::vector<std::string> History::steps() const {
    std::vector<std::string> labels;
    labels.reserve(past_.size() + future_.size());
    for (const Step& step : past_) labels.push_back(step.label);
    for (auto step = future_.rbegin(); step != future_.rend(); ++step) {
        labels.push_back(step->label);
    }
    return labels;
}

bool History::jumpTo(Document& document, std::size_t steps) {
    commit(document);
    if (steps == past_.size() || steps > past_.size() + future_.size()) return false;
    while (past_.size() > steps) undo(document);
    while (past_.size() < steps) redo(document);
    return true;
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
