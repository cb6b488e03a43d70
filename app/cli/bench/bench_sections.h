// bench_sections.h: what `bench` measures, one function a section, each with renderers of its own.
//
// Each prints a table on stderr and returns what is in it as JSON.
#pragma once
#include "app/cli/bench/bench_run.h"

namespace neph::bench {

/// Frames of a camera that orbits, in [Riley03] table 4's modes, by each engine, for each grid and
/// size, beside the floor and the paper's figures.
Json measureModes(const Run& run);

/// From a changed mixing scale, sun or time to a first and to the full image.
Json measureChanges(const Run& run);

/// The eye pass and the memory on grids that double in each direction.
Json measureGrowth(const Run& run);

/// An orbit as the workbench draws it, its quality adapting, without its panels.
Json measureWindow(const Run& run);

/// Paths, collisions and scatterings per second of the reference, and the time to an error.
Json measureReference(const Run& run);

}  // namespace neph::bench
