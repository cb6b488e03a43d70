// choice_help.cpp: by the spelling of the choices, of which no two parameters that differ in
// meaning share any. A long table is data.
#include "core/look/choice_help.h"

#include <array>

#include "core/optics/phase_functions.h"

namespace neph {
namespace {

struct Entry {
    std::string_view of;  // end of the parameter's id
    std::string_view choice;
    std::string_view help;
};

constexpr std::array kEntries{
    Entry{"mode.transport", "low_albedo",
          "Beer-Lambert alone: what is scattered is lost. Dark, for thin or absorbing media."},
    Entry{"mode.transport", "translucent",
          "Light scattered nearly straight on goes on to light what lies behind, Eq. 12, 14-17."},
    Entry{"mode.phase", "uniform", "The uniform phase function for all fields."},
    Entry{"mode.phase", "per_field",
          "Each field its own, weighted by scattering coefficient, Eq. 18."},
    Entry{"mode.extinction", "physical",
          "3 / (2 r rho) per kilogram: Eq. 9 with each field's size."},
    Entry{"mode.extinction", "equal",
          "The same m²/kg for every field: amounts of mass can be compared by eye."},
    Entry{"mode.radiation_optics", "geometric", "Large spheres: extinction efficiency 2."},
    Entry{"mode.radiation_optics", "wrf_rrtmg",
          "As WRF's radiation code has ice and snow of the model's radius."},
    Entry{"mode.colour", "natural", "White particles, coloured by the light alone."},
    Entry{"mode.colour", "fields", "Each field in its field colour, [Riley03] table 2."},
    Entry{".radius_source", "constant", "One radius for the whole field; nothing is read again."},
    Entry{".radius_source", "file", "Effective radii that the model wrote."},
    Entry{".radius_source", "number", "From mass and number of particles in each cell."},
    Entry{".radius_source", "scheme",
          "From mass by the size distribution that the microphysics scheme assumes."},
    Entry{"light.form", "printed", "As the paper prints it: brightness depends on the planes."},
    Entry{"light.form", "consistent", "The same light however many planes. docs/physics.md §1"},
    Entry{"light.phase_display", "linear", "Cut at the peak and normalised, linear."},
    Entry{"light.phase_display", "logarithmic",
          "Cut at the peak and normalised, logarithmic, as [Riley03] fig. 10."},
    Entry{"light.phase_display", "physical", "The true value times 4 pi."},
    Entry{"view.tone_map", "linear", "Clipped where it is too bright."},
    Entry{"view.tone_map", "filmic", "Toe and shoulder as film has them. [Narkowicz15]"},
    Entry{".noise_character", "billow", "Rounded heaps, as convective cloud has."},
    Entry{".noise_character", "wisp", "Streaks, as cirrus has."},
};

}  // namespace

std::string_view choiceHelp(const Parameter& row, int choice) {
    if (row.kind != ParameterKind::choice) return {};
    const auto index = static_cast<std::size_t>(choice);
    if (row.id == "view.engine") return kEngines[index].help;
    const std::string_view id = row.choices[index];
    for (const Entry& entry : kEntries) {
        if (entry.choice == id && row.id.ends_with(entry.of)) return entry.help;
    }
    for (const PhaseFunction& function : phaseFunctions()) {
        if (function.id == id && row.id.ends_with("phase")) return function.help;
    }
    return {};
}

}  // namespace neph
