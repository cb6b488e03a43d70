// lowest_air.cpp: one layer of three fields.
#include "core/volume/lowest_air.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/sky/humidity.h"
#include "core/volume/native_band.h"

namespace neph {
namespace {

/// What must be there.
struct Ingredient {
    VariableRole role;
    const char* name;
};
constexpr std::array kIngredients{
    Ingredient{VariableRole::waterVapour, "water vapour"},
    Ingredient{VariableRole::airPressure, "pressure of the air"},
    Ingredient{VariableRole::airTemperature, "temperature of the air"}};

/// Why humidity is not known; empty where everything is there.
std::string lackOf(const DatasetInfo& all, const DatasetInfo& there) {
    for (const Ingredient& each : kIngredients) {
        if (there.find(each.role) != nullptr) continue;
        if (all.find(each.role) == nullptr) return fmt::format("the data have no {}", each.name);
        return fmt::format("there is no {} at this time", each.name);
    }
    return {};
}

/// By the area of the cells.
double meanOf(const std::array<ColumnField, 3>& air, const DatasetInfo& info) {
    double sum = 0.0, areaSum = 0.0;
    std::size_t column = 0;
    for (int y = 0; y < info.size.y; ++y) {
        const double widthY = info.edgeM(1, y + 1) - info.edgeM(1, y);
        for (int x = 0; x < info.size.x; ++x, ++column) {
            const double area = widthY * (info.edgeM(0, x + 1) - info.edgeM(0, x));
            const auto value = [&](std::size_t i) {
                return static_cast<double>(air[i].at(column, 0));
            };
            sum += area * std::min(relativeHumidity(value(1), value(2), value(0)), 1.0);
            areaSum += area;
        }
    }
    return sum / areaSum;
}

}  // namespace

LowestAir readLowestAir(Dataset& dataset, int time, const Progress& progress) {
    const DatasetInfo there = dataset.infoAt(time);
    if (const std::string lack = lackOf(dataset.info(), there); !lack.empty()) return {{}, lack};
    CellBox ground = wholeBox(dataset.info());
    ground.upper.z = 1;
    try {
        std::array<ColumnField, 3> air;
        for (std::size_t i = 0; i < air.size(); ++i) {
            air[i] =
                readColumns(dataset, *there.find(kIngredients[i].role), time, ground, progress);
        }
        return {meanOf(air, dataset.info()), {}};
    } catch (const Error& error) {
        return {{}, fmt::format("{} ({})", error.parts().what, error.parts().found)};
    }
}

}  // namespace neph
