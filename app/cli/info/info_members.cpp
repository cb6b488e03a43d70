// info_members.cpp: a line for each member.
#include "app/cli/info/info_members.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/dataset/ensemble.h"

namespace neph {
namespace {

/// "wrfout_d01" or "wrfout_d01_a and 12 more".
std::string filesText(const DatasetInfo& info) {
    std::vector<std::filesystem::path> files;
    for (const TimeInfo& time : info.times) {
        if (files.empty() || files.back() != time.file) files.push_back(time.file);
    }
    const std::string first = files.front().string();
    return files.size() == 1 ? first : fmt::format("{} and {} more", first, files.size() - 1);
}

}  // namespace

std::string membersLines(const Dataset& dataset) {
    const Ensemble* ensemble = ensembleOf(dataset);
    if (ensemble == nullptr) return {};
    std::string text = fmt::format("Members  {}; what follows is of {}, where it has the time\n",
                                   ensemble->count(), ensemble->nameOf(0));
    for (int member = 0; member < ensemble->count(); ++member) {
        const DatasetInfo& info = ensemble->infoOf(member);
        const std::size_t times = info.times.size();
        text += fmt::format("         {}: {} time{}, {}{}, {}\n", ensemble->nameOf(member), times,
                            times == 1 ? "" : "s", info.times.front().label,
                            times == 1 ? "" : " to " + info.times.back().label, filesText(info));
    }
    return text;
}

nlohmann::ordered_json membersJson(const Dataset& dataset) {
    using Json = nlohmann::ordered_json;
    const Ensemble* ensemble = ensembleOf(dataset);
    if (ensemble == nullptr) return nullptr;
    Json members = Json::array();
    for (int member = 0; member < ensemble->count(); ++member) {
        Json times = Json::array(), files = Json::array();
        for (const TimeInfo& time : ensemble->infoOf(member).times) {
            times.push_back(time.label);
            const Json file = time.file.string();
            if (files.empty() || files.back() != file) files.push_back(file);
        }
        members.push_back({{"name", ensemble->nameOf(member)}, {"times", times}, {"files", files}});
    }
    return members;
}

}  // namespace neph
