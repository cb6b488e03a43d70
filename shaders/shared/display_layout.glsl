// display_layout.glsl: image units and locations of the passes between an engine's radiance and the
// display. C++: in namespace neph::render.
#pragma once

// background.comp
const int kBackgroundEyeImage = 0;
const int kBackgroundLinearImage = 1;
const int kBackgroundLayerLocation = 0;

// average.comp
const int kAverageRaysImage = 0;
const int kAverageLinearImage = 1;
const int kAverageSideLocation = 0;

// resolve.comp
const int kResolveLinearImage = 0;
const int kResolveDisplayImage = 1;
const int kResolveExposureLocation = 0;
const int kResolveCurveLocation = 1;
const int kResolveLeftLocation = 2;
const int kResolveLowerLocation = 3;
const int kResolveTransparentLocation = 4;
const int kResolveSunShownImage = 2;
const int kResolveGlareLocation = 5;
const int kResolveForwardLocation = 6;
const int kResolveRightLocation = 7;
const int kResolveUpLocation = 8;
const int kResolveTowardsSunLocation = 9;
const int kResolveWholeLocation = 10;
