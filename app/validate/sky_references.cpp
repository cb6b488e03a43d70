// sky_references.cpp: formulas of standards, and numbers of an independent program.
#include "app/validate/sky_references.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace neph::validate {
namespace {

double gradation(const StandardSky& type, double up) {
    return up <= 0.0 ? 1.0 : 1.0 + type.a * std::exp(type.b / up);
}

double indicatrix(const StandardSky& type, double fromSun) {
    const double cosine = std::cos(fromSun);
    return 1.0 + type.c * (std::exp(type.d * fromSun) - std::exp(type.d * 0.5 * std::numbers::pi)) +
           type.e * cosine * cosine;
}

}  // namespace

double relativeAirMass(double elevationDeg) {
    return 1.0 / (std::sin(glm::radians(elevationDeg)) +
                  0.50572 * std::pow(elevationDeg + 6.07995, -1.6364));
}

double luminousExtinction(double airMass) {
    return 1.0 / (9.9 + 0.043 * airMass);
}

double relativeLuminance(const StandardSky& type, const glm::dvec3& towards,
                         const glm::dvec3& towardsSun) {
    const double fromSun = std::acos(std::clamp(glm::dot(towards, towardsSun), -1.0, 1.0));
    return gradation(type, towards.z) * indicatrix(type, fromSun) /
           (gradation(type, 1.0) * indicatrix(type, std::acos(towardsSun.z)));
}

ZenithKcdPerM2 zenithOf(const StandardSky& type, double sunDeg, double diffuseKlx,
                        double turbidity) {
    constexpr double kOutsideKlx = 133.8;
    const double up = std::sin(glm::radians(sunDeg)), across = std::cos(glm::radians(sunDeg));
    const double aureole = std::pow(up, type.zenithC) / std::pow(across, type.zenithD);
    return {diffuseKlx / (kOutsideKlx * up) * (type.zenithB * aureole + type.zenithE * up),
            (type.zenithA1 * turbidity + type.zenithA2) * up + 0.7 * (turbidity + 1.0) * aureole +
                0.04 * turbidity};
}

std::vector<ExactSky> exactSkies() {
    return {
        {100.0e3,
         {{10.0, 90.0, 0.0, 0.00490},   {10.0, 60.0, 45.0, 0.00701},  {10.0, 60.0, 90.0, 0.00563},
          {10.0, 60.0, 180.0, 0.00586}, {10.0, 30.0, 45.0, 0.01499},  {10.0, 30.0, 90.0, 0.00939},
          {10.0, 30.0, 180.0, 0.01287}, {10.0, 10.0, 45.0, 0.03680},  {10.0, 10.0, 90.0, 0.02135},
          {10.0, 10.0, 180.0, 0.03310}, {40.0, 90.0, 0.0, 0.01129},   {40.0, 60.0, 45.0, 0.01841},
          {40.0, 60.0, 90.0, 0.01179},  {40.0, 60.0, 180.0, 0.00919}, {40.0, 30.0, 45.0, 0.02852},
          {40.0, 30.0, 90.0, 0.01669},  {40.0, 30.0, 180.0, 0.01598}, {40.0, 10.0, 45.0, 0.05343},
          {40.0, 10.0, 90.0, 0.03641},  {40.0, 10.0, 180.0, 0.04310}}},
        {25.0e3,
         {{10.0, 90.0, 0.0, 0.00647},   {10.0, 60.0, 45.0, 0.01045},  {10.0, 60.0, 90.0, 0.00744},
          {10.0, 60.0, 180.0, 0.00709}, {10.0, 30.0, 45.0, 0.02533},  {10.0, 30.0, 90.0, 0.01210},
          {10.0, 30.0, 180.0, 0.01414}, {10.0, 10.0, 45.0, 0.05286},  {10.0, 10.0, 90.0, 0.02160},
          {10.0, 10.0, 180.0, 0.02634}, {40.0, 90.0, 0.0, 0.02076},   {40.0, 60.0, 45.0, 0.04369},
          {40.0, 60.0, 90.0, 0.02013},  {40.0, 60.0, 180.0, 0.01302}, {40.0, 30.0, 45.0, 0.06298},
          {40.0, 30.0, 90.0, 0.02509},  {40.0, 30.0, 180.0, 0.02047}, {40.0, 10.0, 45.0, 0.08704},
          {40.0, 10.0, 90.0, 0.04415},  {40.0, 10.0, 180.0, 0.04307}}},
    };
}

}  // namespace neph::validate
