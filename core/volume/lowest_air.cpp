// lowest_air.cpp: one layer of a few fields.
#include "core/volume/lowest_air.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/optics/aerosol.h"
#include "core/sky/humidity.h"
#include "core/volume/native_band.h"

namespace neph {
namespace {

/// What must be there.
struct Ingredient {
    VariableRole role;
    const char* name;
};
/// The first three are for humidity, all for aerosol.
constexpr std::size_t kOfHumidity = 3;
constexpr std::array kIngredients{
    Ingredient{VariableRole::waterVapour, "water vapour"},
    Ingredient{VariableRole::airPressure, "pressure of the air"},
    Ingredient{VariableRole::airTemperature, "temperature of the air"},
    Ingredient{VariableRole::hygroscopicAerosolNumber, "number of hygroscopic aerosol"},
    Ingredient{VariableRole::dustNumber, "number of dust"}};
using Air = std::array<ColumnField, kIngredients.size()>;

/// Why some of the ingredients are not known; empty where everything is there.
std::string lackOf(const DatasetInfo& all, const DatasetInfo& there, std::size_t first,
                   std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
        const Ingredient& each = kIngredients[i];
        if (there.find(each.role) != nullptr) continue;
        if (all.find(each.role) == nullptr) return fmt::format("the data have no {}", each.name);
        return fmt::format("there is no {} at this time", each.name);
    }
    return {};
}

/// The mean of `valueAt(column)` by the area of the cells.
double meanOf(const DatasetInfo& info, const auto& valueAt) {
    double sum = 0.0, areaSum = 0.0;
    std::size_t column = 0;
    for (int y = 0; y < info.size.y; ++y) {
        const double widthY = info.edgeM(1, y + 1) - info.edgeM(1, y);
        for (int x = 0; x < info.size.x; ++x, ++column) {
            const double area = widthY * (info.edgeM(0, x + 1) - info.edgeM(0, x));
            sum += area * valueAt(column);
            areaSum += area;
        }
    }
    return sum / areaSum;
}

double valueOf(const Air& air, std::size_t ingredient, std::size_t column) {
    return static_cast<double>(air[ingredient].at(column, 0));
}

/// At most 1.
double humidityAt(const Air& air, std::size_t column) {
    const auto of = [&](std::size_t i) { return valueOf(air, i, column); };
    return std::min(relativeHumidity(of(1), of(2), of(0)), 1.0);
}

/// Extinction of the aerosol, 1/m.
double aerosolAt(const Air& air, std::size_t column) {
    static const ExtinctionByHumidity hygroscopic(kHygroscopicAerosol), dust(kDustAerosol);
    const auto of = [&](std::size_t i) { return valueOf(air, i, column); };
    const double humidity = humidityAt(air, column);
    return dryDensityKgPerM3(of(1), of(2), of(0)) *
           (std::max(of(3), 0.0) * hygroscopic.atM2(humidity) +
            std::max(of(4), 0.0) * dust.atM2(humidity));
}

/// Reads some of the ingredients, which are there; why that fails, or nothing.
std::string readInto(Air& air, Dataset& dataset, int time, std::size_t first, std::size_t end,
                     const Progress& progress) {
    const DatasetInfo there = dataset.infoAt(time);
    CellBox ground = wholeBox(dataset.info());
    ground.upper.z = 1;
    try {
        for (std::size_t i = first; i < end; ++i) {
            air[i] =
                readColumns(dataset, *there.find(kIngredients[i].role), time, ground, progress);
        }
    } catch (const Error& error) {
        return fmt::format("{} ({})", error.parts().what, error.parts().found);
    }
    return {};
}

}  // namespace

LowestAir readLowestAir(Dataset& dataset, int time, const Progress& progress) {
    const DatasetInfo& all = dataset.info();
    const DatasetInfo there = dataset.infoAt(time);
    constexpr std::size_t kAll = kIngredients.size();
    LowestAir lowest;
    lowest.reason = lackOf(all, there, 0, kOfHumidity);
    lowest.noAerosol = lackOf(all, there, kOfHumidity, kAll);
    Air air;
    if (lowest.reason.empty()) {
        lowest.reason = readInto(air, dataset, time, 0, kOfHumidity, progress);
    }
    if (!lowest.reason.empty()) {
        if (lowest.noAerosol.empty()) lowest.noAerosol = lowest.reason;
        return lowest;
    }
    lowest.humidity = meanOf(all, [&](std::size_t column) { return humidityAt(air, column); });
    if (lowest.noAerosol.empty()) {
        lowest.noAerosol = readInto(air, dataset, time, kOfHumidity, kAll, progress);
    }
    if (lowest.noAerosol.empty()) {
        lowest.aerosolPerM =
            meanOf(all, [&](std::size_t column) { return aerosolAt(air, column); });
    }
    return lowest;
}

}  // namespace neph
