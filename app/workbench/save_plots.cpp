// save_plots.cpp: a sheet of equal parts.
#include "app/workbench/save_plots.h"

#include <fmt/format.h>

#include "app/image_io/figure_file.h"
#include "core/base/atomic_file.h"
#include "core/base/resources.h"

namespace neph {
namespace {

namespace fs = std::filesystem;
constexpr glm::dvec2 kFigurePt{760.0, 520.0};

fs::path freshName(const fs::path& folder, const fs::path& name) {
    fs::path file = folder / name;
    for (int i = 2; fs::exists(file); ++i) {
        file = folder / fmt::format("{}-{}{}", name.stem().string(), i, name.extension().string());
    }
    return file;
}

}  // namespace

std::string savePlots(const fs::path& folder, const std::string& name,
                      const std::vector<plot::Figure>& figures, plot::Table table,
                      const DatasetInfo* data) {
    const fs::path file = fs::path(name).is_absolute()
                              ? fs::path(name)
                              : freshName(folder.empty() ? fs::current_path() : folder, name);
    Metadata metadata{{"Software", fmt::format("Nephoscope {}", versionText())}};
    if (data != nullptr) {
        metadata.emplace_back("Source", data->times.front().file.string());
        metadata.emplace_back("Model", data->model);
    }
    if (file.extension() == ".csv") {
        for (const auto& [key, value] : metadata) table.comments.push_back(key + ": " + value);
        replaceFile(file, plot::csvOf(table));
        return file.string();
    }
    Sheet sheet;
    sheet.sizePt = {kFigurePt.x * static_cast<double>(figures.size()), kFigurePt.y};
    sheet.metadata = metadata;
    for (std::size_t i = 0; i < figures.size(); ++i) {
        const double left = kFigurePt.x * static_cast<double>(i);
        sheet.figures.push_back({figures[i], {{left, 0.0}, {left + kFigurePt.x, kFigurePt.y}}});
    }
    writeSheet(file, sheet);
    return file.string();
}

}  // namespace neph
