// nested_run.h: small nested runs of WRF on a map, for tests.
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/geo/map_place.h"
#include "tests/readers/wrf_maker.h"

/// A domain of a run whose outermost has 12 x 10 cells of 3 km from the origin of its map on.
struct NestedDomain {
    int number = 1, parent = 0, ratio = 1;
    int i = 1, j = 1;  ///< cell of the parent at its corner, from 1
    int nx = 12, ny = 10;
    double cellM = 3000.0;
    glm::dvec2 cornerM{0.0};  ///< on the map
    double standLongitude = -98.0;
    bool mercator = false;  ///< else Lambert's map
    float cloudKgPerKg = 1e-3f;

    /// A nest of this domain.
    NestedDomain nest(int itsNumber, int itsI, int itsJ, int itsNx, int itsNy,
                      int itsRatio = 3) const {
        NestedDomain inner = *this;
        inner.number = itsNumber;
        inner.parent = number;
        inner.ratio = itsRatio;
        inner.i = itsI;
        inner.j = itsJ;
        inner.nx = itsNx;
        inner.ny = itsNy;
        inner.cellM = cellM / itsRatio;
        inner.cornerM = cornerM + cellM * glm::dvec2(itsI - 1, itsJ - 1);
        inner.cloudKgPerKg = 3.0f * cloudKgPerKg;
        return inner;
    }

    /// `placed`: on the earth, else idealised.
    void write(const std::filesystem::path& file, const std::vector<std::string>& times,
               bool placed = true) const {
        WrfSpec spec;
        spec.nx = nx;
        spec.ny = ny;
        spec.dx = spec.dy = static_cast<float>(cellM);
        spec.times = times;
        spec.mapProjection = !placed ? 0 : mercator ? 3 : 1;
        spec.attributes = {{"GRID_ID", number},          {"PARENT_ID", parent},
                           {"I_PARENT_START", i},        {"J_PARENT_START", j},
                           {"PARENT_GRID_RATIO", ratio}, {"TRUELAT1", 30.0},
                           {"TRUELAT2", 60.0},           {"STAND_LON", standLongitude}};
        spec.texts = {{"SIMULATION_START_DATE", "2021-08-14_12:00:00"}};
        spec.fields["QCLOUD"] = everywhere(cloudKgPerKg);
        if (placed) {
            const std::string projection =
                (mercator ? "+proj=merc +lat_ts=30" : "+proj=lcc +lat_1=30 +lat_2=60 +lat_0=30") +
                std::string(" +lon_0=") + std::to_string(standLongitude) + " +R=6370000 +units=m";
            const auto map = std::make_shared<neph::MapPlace>(neph::MapGrid{projection, cornerM});
            const auto at = [map, cell = cellM](int x, int y) {
                return map->geoAt(cell * (glm::dvec2(x, y) + 0.5)).value();
            };
            spec.flat["XLAT"] = [at](int x, int y, int, int) {
                return static_cast<float>(at(x, y).latitudeDeg);
            };
            spec.flat["XLONG"] = [at](int x, int y, int, int) {
                return static_cast<float>(at(x, y).longitudeDeg);
            };
        }
        writeWrf(file, spec);
    }
};
