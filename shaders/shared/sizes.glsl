// sizes.glsl: how many there are of what core fills and shaders read. C++: in namespace neph.
#pragma once

const int kSpeciesCount = 6;  // core/grid/species.h

// Entries of a phase function's table. shaders/lib/phase_table.glsl
const int kPhaseTableSize = 1024;

// Texels along the edge of the tile of blue noise; a power of two.
const int kBlueNoiseSize = 64;
