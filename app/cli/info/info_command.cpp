// info_command.cpp: opens the series and prints its summary.
#include "app/cli/info/info_command.h"

#include <fmt/format.h>

#include "app/cli/common/scene.h"
#include "app/cli/info/info_json.h"
#include "app/cli/info/info_text.h"
#include "core/dataset/dataset.h"

namespace neph {

int runInfo(const InfoRequest& request) {
    std::vector<std::string> warnings;
    const MemoryBudget budget = chooseBudget(request.memory, MemoryBudget{}.gpu, warnings);
    for (const std::string& warning : warnings) fmt::print(stderr, "warning: {}\n", warning);
    const auto dataset = openData(request.files, request.members,
                                  PluginHost::standard(request.readers, request.map));
    fmt::print("{}", request.json ? infoJson(*dataset, request.times, budget)
                                  : infoText(*dataset, request.times, budget));
    return 0;
}

}  // namespace neph
