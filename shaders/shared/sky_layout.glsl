// sky_layout.glsl: units of the tables of sky and air. C++: in namespace neph::render.
#pragma once

const int kEyeSkyUnit = 16;
const int kAirUnit = 17;
const int kClearAirUnit = 18;
const int kAroundUnit = 19;
const int kByAltitudeUnit = 20;
const int kSunnyAirUnit = 21;
const int kByMoleculesUnit = 22;
const int kByHazeUnit = 23;
