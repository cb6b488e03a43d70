// old_metres.cpp: from metres by way of cells of 1 km to cells of the data.
#include "core/look/old_metres.h"

#include <fmt/format.h>

#include <algorithm>

namespace neph {
namespace {

constexpr std::string_view kOldEnding = ".noise_scale", kEnding = ".noise_cells";

template <typename Do>
void forEach(FieldSet fields, const Do& work) {
    for (int i = 0; i < kSpeciesCount; ++i) {
        if ((fields >> static_cast<unsigned>(i) & 1U) != 0) work(static_cast<Species>(i));
    }
}

const Parameter& rowOf(Species s) {
    return parameter(fmt::format("{}{}", info(s).id, kEnding));
}

}  // namespace

const Parameter* replacedInCells(std::string_view id) {
    if (!id.ends_with(kOldEnding)) return nullptr;
    id.remove_suffix(kOldEnding.size());
    return findParameter(fmt::format("{}{}", id, kEnding));
}

float asLookCells(float metres) {
    return static_cast<float>(static_cast<double>(metres) / kLookCellM);
}

FieldSet noiseScaleField(const Parameter& row) {
    const bool scale = row.species && row.id.ends_with(kEnding);
    return scale ? 1U << static_cast<unsigned>(*row.species) : 0U;
}

std::string bringToCells(Look& look, FieldSet fields, double cellM) {
    if (cellM == kLookCellM) return {};
    std::string told;
    forEach(fields, [&](Species s) {
        const ParameterRange& range = rowOf(s).range;
        float& scale = look.of(s).noiseScaleCells;
        const double metres = static_cast<double>(scale) * kLookCellM;
        const double cells = std::clamp(metres / cellM, range.lo, range.hi);
        scale = static_cast<float>(cells);
        told += fmt::format("{}{} {:.4g} m = {:.4g} cells", told.empty() ? "" : ", ", info(s).id,
                            metres, cells);
    });
    if (told.empty()) return {};
    return fmt::format(
        "Noise scales that an older version saved in metres are kept as they were, in cells of "
        "{:.4g} m: {}. Smaller ones suit these data: the standard preset has 2.5 to 8 cells.",
        cellM, told);
}

std::string namesOf(FieldSet fields) {
    std::string names;
    forEach(fields, [&](Species s) {
        names += fmt::format("{}{}", names.empty() ? "" : ", ", info(s).id);
    });
    return names;
}

}  // namespace neph
