// les_maker.cpp: files of LES models by NetCDF-C, with the names, units and axes of each.
#include "tests/readers/les_maker.h"

#include <netcdf.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace {

void need(int status) {
    if (status != NC_NOERR) throw std::runtime_error(nc_strerror(status));
}

void putTexts(int file, int variable, const std::map<std::string, std::string>& texts) {
    for (const auto& [name, text] : texts) {
        need(nc_put_att_text(file, variable, name.c_str(), text.size(), text.data()));
    }
}

int define(int file, const LesFile& spec, const LesVariable& variable) {
    std::vector<int> axes;
    for (const std::string& axis : variable.axes) {
        const auto found =
            std::ranges::find(spec.dimensions, axis, &std::pair<std::string, std::size_t>::first);
        if (found == spec.dimensions.end()) throw std::runtime_error("no dimension " + axis);
        axes.push_back(static_cast<int>(found - spec.dimensions.begin()));
    }
    int id = -1;
    need(nc_def_var(file, variable.name.c_str(), variable.type, static_cast<int>(axes.size()),
                    axes.data(), &id));
    if (!variable.units.empty()) putTexts(file, id, {{"units", variable.units}});
    putTexts(file, id, variable.texts);
    for (const auto& [name, numbers] : variable.numbers) {
        need(nc_put_att_double(file, id, name.c_str(),
                               variable.type == NC_FLOAT ? NC_FLOAT : NC_DOUBLE, numbers.size(),
                               numbers.data()));
    }
    return id;
}

void put(int file, int id, const LesFile& spec, const LesVariable& variable) {
    if (variable.type == NC_CHAR)
        return need(nc_put_var_text(file, id, variable.characters.data()));
    if (!variable.value) return;
    std::vector<std::size_t> shape;
    std::size_t count = 1;
    for (const std::string& axis : variable.axes) {
        const auto found =
            std::ranges::find(spec.dimensions, axis, &std::pair<std::string, std::size_t>::first);
        shape.push_back(found->second);
        count *= found->second;
    }
    std::vector<double> values(count);
    std::vector<std::size_t> at(shape.size(), 0);
    for (double& value : values) {
        value = variable.value(at);
        for (std::size_t i = shape.size(); i-- > 0;) {
            if (++at[i] < shape[i]) break;
            at[i] = 0;
        }
    }
    const std::vector<std::size_t> start(shape.size(), 0);
    need(nc_put_vara_double(file, id, start.data(), shape.data(), values.data()));
}

std::vector<std::string> tzyx(const char* z, const char* y, const char* x) {
    return {"time", z, y, x};
}

/// The axes of the samples under the names of a model.
void addAxes(LesFile& file, const char* x, const char* y, const char* z) {
    file.dimensions = {{"time", 1}, {x, 4}, {y, 3}, {z, 5}};
    file.variables = {along("time", {600.0}, "s"), along(x, kSampleXM, "m"),
                      along(y, kSampleYM, "m"), along(z, kSampleCentresM, "m")};
}

}  // namespace

LesVariable& LesFile::variable(const std::string& name) {
    const auto found = std::ranges::find(variables, name, &LesVariable::name);
    if (found == variables.end()) throw std::runtime_error("no variable " + name);
    return *found;
}

void LesFile::drop(const std::string& name) {
    std::erase_if(variables, [&](const LesVariable& each) { return each.name == name; });
}

void LesFile::resize(const std::string& dimension, std::size_t length) {
    for (auto& [name, size] : dimensions) {
        if (name == dimension) size = length;
    }
}

void writeLes(const std::filesystem::path& path, const LesFile& spec) {
    int file = -1;
    need(
        nc_create(path.c_str(), NC_CLOBBER | (spec.netcdf4 ? NC_NETCDF4 : NC_64BIT_OFFSET), &file));
    for (const auto& [name, length] : spec.dimensions) {
        int id = -1;
        const bool record = name == "time" && !spec.netcdf4;
        need(nc_def_dim(file, name.c_str(), record ? NC_UNLIMITED : length, &id));
    }
    putTexts(file, NC_GLOBAL, spec.texts);
    for (const auto& [name, number] : spec.numbers) {
        need(nc_put_att_double(file, NC_GLOBAL, name.c_str(), NC_DOUBLE, 1, &number));
    }
    std::vector<int> ids;
    for (const LesVariable& variable : spec.variables) ids.push_back(define(file, spec, variable));
    need(nc_enddef(file));
    for (std::size_t i = 0; i < ids.size(); ++i) put(file, ids[i], spec, spec.variables[i]);
    need(nc_close(file));
}

LesVariable along(const std::string& axis, std::vector<double> values, const std::string& units) {
    LesVariable variable{axis, {axis}, units};
    variable.value = [values = std::move(values)](std::span<const std::size_t> at) {
        return values[std::min(at[0], values.size() - 1)];
    };
    return variable;
}

LesVariable field(const std::string& name, std::vector<std::string> axes, const std::string& units,
                  IndexedValue value) {
    LesVariable variable{name, std::move(axes), units};
    variable.value = std::move(value);
    return variable;
}

IndexedValue constant(double value) {
    return [value](std::span<const std::size_t>) { return value; };
}

double numbered(std::size_t t, std::size_t z, std::size_t y, std::size_t x) {
    return 1e-6 * static_cast<double>(1 + x + 10 * y + 100 * z + 1000 * t);
}

IndexedValue numberedField() {
    return [](std::span<const std::size_t> at) { return numbered(at[0], at[1], at[2], at[3]); };
}

LesFile cm1Sample() {
    LesFile file;
    file.dimensions = {{"time", 2}, {"xh", 4}, {"yh", 3}, {"zh", 5}, {"xf", 5}, {"zf", 6}};
    const auto km = [](std::vector<double> metres) {
        for (double& value : metres) value *= 1e-3;
        return metres;
    };
    const auto axes = tzyx("zh", "yh", "xh");
    file.variables = {along("time", {600.0, 900.0}, "seconds"),
                      along("xh", km(kSampleXM), "km"),
                      along("yh", km(kSampleYM), "km"),
                      along("zh", km(kSampleCentresM), "km"),
                      along("zf", km(kSampleFacesM), "km"),
                      field("umove", {"time"}, "m/s", constant(12.5)),
                      field("vmove", {"time"}, "m/s", constant(-2.0)),
                      field("qc", axes, "g/kg",
                            [](std::span<const std::size_t> at) {
                                return 1e3 * numbered(at[0], at[1], at[2], at[3]);
                            }),
                      field("qg", axes, "kg/kg", constant(2e-4)),
                      field("th", axes, "K", constant(300.0)),
                      field("prs", axes, "Pa", constant(9e4)),
                      field("qv", axes, "kg/kg", constant(0.01)),
                      field("u", tzyx("zh", "yh", "xf"), "m/s", constant(3.0)),
                      field("uinterp", axes, "m/s", constant(3.5))};
    file.texts = {{"CM1 version", "cm1r21.1"}};
    file.numbers = {{"nx", 4},      {"ny", 3},    {"ptype", 5}, {"ctrlat", 36.0}, {"ctrlon", -98.0},
                    {"year", 2009}, {"month", 5}, {"day", 15},  {"hour", 21},     {"minute", 30}};
    return file;
}

LesFile samSample() {
    LesFile file;
    addAxes(file, "x", "y", "z");
    file.variable("time").units = "day";
    file.variable("time").value = constant(0.5);
    const auto axes = tzyx("z", "y", "x");
    file.variables.push_back(field("p", {"z"}, "mb", constant(900.0)));
    file.variables.push_back(field("PP", axes, "Pa", constant(100.0)));
    // Level by level: warm, between, cold.
    file.variables.push_back(field("TABS", axes, "K", [](std::span<const std::size_t> at) {
        constexpr std::array kKelvin{290.0, 275.66, 263.16, 253.16, 220.0};
        return kKelvin[at[1]];
    }));
    file.variables.push_back(field("QV", axes, "g/kg", constant(8.0)));
    file.variables.push_back(field("QN", axes, "g/kg", [](std::span<const std::size_t> at) {
        return 1e3 * numbered(at[0], at[1], at[2], at[3]);
    }));
    file.variables.push_back(field("QP", axes, "g/kg", constant(1.0)));
    return file;
}

LesFile dalesSample() {
    LesFile file;
    addAxes(file, "xt", "yt", "zt");
    file.dimensions.emplace_back("zm", 5);
    file.variables.push_back(along("zm", {0.0, 40.0, 100.0, 180.0, 280.0}, "m"));
    const auto axes = tzyx("zt", "yt", "xt");
    file.variables.push_back(field("ql", axes, "1e-5kg/kg", numberedField()));
    file.variables.push_back(field("qr", axes, "1e-5kg/kg", constant(1e-5)));
    file.variables.push_back(field("qt", axes, "1e-5kg/kg", constant(0.01)));
    file.variables.push_back(field("thl", axes, "K", constant(290.0)));
    return file;
}

LesFile palmSample() {
    LesFile file;
    file.dimensions = {{"time", 1}, {"x", 4}, {"y", 3}, {"zu_3d", 6}, {"zw_3d", 6}};
    const auto axes = tzyx("zu_3d", "y", "x");
    // The first level of PALM lies on the ground.
    std::vector<double> zu{0.0};
    zu.insert(zu.end(), kSampleCentresM.begin(), kSampleCentresM.end());
    file.variables = {along("time", {600.0}, "seconds"),
                      along("x", kSampleXM, "m"),
                      along("y", kSampleYM, "m"),
                      along("zu_3d", zu, "m"),
                      along("zw_3d", kSampleFacesM, "m"),
                      field("ql", axes, "kg/kg",
                            [](std::span<const std::size_t> at) {
                                if (at[1] == 0 || (at[1] == 1 && at[3] == 0)) return -9999.0;
                                return numbered(at[0], at[1] - 1, at[2], at[3]);
                            }),
                      field("qv", axes, "kg/kg", constant(0.01)),
                      field("nc", axes, "1/m3", constant(1e8))};
    file.variable("ql").numbers = {{"_FillValue", {-9999.0}}};
    file.texts = {{"title", "PALM 6.0  run: case.00"}};
    file.numbers = {{"origin_lat", 52.0}, {"origin_lon", 9.0}};
    return file;
}

LesFile moncSample() {
    LesFile file;
    // MONC writes z fastest. zn[0] lies below the ground.
    file.dimensions = {{"time_series_60_600", 1}, {"x", 4},   {"y", 3},     {"z", 6}, {"zn", 6},
                       {"number_options", 3},     {"kvp", 2}, {"string", 8}};
    const std::vector<std::string> axes{"time_series_60_600", "x", "y", "z"};
    std::vector<double> zn{-20.0};
    zn.insert(zn.end(), kSampleCentresM.begin(), kSampleCentresM.end());
    file.variables = {
        along("time_series_60_600", {600.0}, ""),
        along("z", kSampleFacesM, "m"),
        along("zn", zn, "m"),
        field("q_cloud_liquid_mass", axes, "kg/kg",
              [](std::span<const std::size_t> at) {
                  return at[3] == 0 ? 9.0 : numbered(at[0], at[3] - 1, at[2], at[1]);
              }),
        field("q_vapour", axes, "kg/kg", constant(0.01)),
        field("th", axes, "K", constant(2.0)),
        field("thref", {"time_series_60_600", "zn"}, "K", constant(298.0)),
        field("prefn", {"time_series_60_600", "zn"}, "Pa", constant(9e4)),
        field("rhon", {"time_series_60_600", "zn"}, "kg m-3", [](std::span<const std::size_t> at) {
            return 1.2 - 0.01 * static_cast<double>(at[1]);
        })};
    LesVariable options{"options_database", {"number_options", "kvp", "string"}};
    options.type = NC_CHAR;
    for (std::string text : {"dxx", "100.0", "dyy", "200.0", "z_size", "6"}) {
        text.resize(8, '\0');
        options.characters += text;
    }
    file.variables.push_back(options);
    return file;
}

LesFile uclalesSample() {
    LesFile file;
    file.dimensions = {{"time", 1}, {"xt", 4}, {"yt", 3}, {"zt", 6}, {"zm", 6}};
    // The first level of UCLALES lies below the ground; fields have z fastest.
    std::vector<double> zt{-20.0};
    zt.insert(zt.end(), kSampleCentresM.begin(), kSampleCentresM.end());
    file.variables = {
        along("time", {600.0}, "sec"),
        along("xt", kSampleXM, "m"),
        along("yt", kSampleYM, "m"),
        along("zt", zt, "m"),
        along("zm", kSampleFacesM, "m"),
        field("dn0", {"zt"}, "kg/m^3", constant(1.1)),
        field("l", {"time", "yt", "xt", "zt"}, "kg/kg", [](std::span<const std::size_t> at) {
            return at[3] == 0 ? 9.0 : numbered(at[0], at[3] - 1, at[1], at[2]);
        })};
    return file;
}

LesFile microhhSample(const std::string& variable) {
    LesFile file;
    addAxes(file, "x", "y", "z");
    file.variable("time").units = "time units since start";
    file.variables.push_back(field(variable, tzyx("z", "y", "x"), "",
                                   variable == "ql" ? numberedField() : constant(1e-5)));
    return file;
}

LesFile mesoNhSample() {
    LesFile file;
    file.dimensions = {{"time", 1}, {"ni", 6}, {"nj", 5}, {"level", 7}, {"level_w", 7}};
    // One column and one level more on every side.
    const auto wider = [](std::vector<double> inside, double before, double behind) {
        inside.insert(inside.begin(), before);
        inside.push_back(behind);
        return inside;
    };
    std::vector<double> faces = kSampleFacesM;
    faces.insert(faces.begin(), -40.0);
    const auto axes = tzyx("level", "nj", "ni");
    file.variables = {
        along("time", {600.0}, "seconds since 2001-01-01 12:00:00"),
        along("ni", wider(kSampleXM, -50.0, 450.0), "m"),
        along("nj", wider(kSampleYM, -100.0, 700.0), "m"),
        along("level", wider(kSampleCentresM, -20.0, 460.0), "m"),
        along("level_w", faces, "m"),
        field("JPHEXT", {}, "", constant(1.0)),
        field("ZS", {"nj", "ni"}, "m",
              [](std::span<const std::size_t> at) { return 10.0 * static_cast<double>(at[1]); }),
        field("RCT", axes, "kg kg-1",
              [](std::span<const std::size_t> at) {
                  const bool inside =
                      at[1] > 0 && at[1] < 6 && at[2] > 0 && at[2] < 4 && at[3] > 0 && at[3] < 5;
                  return inside ? numbered(at[0], at[1] - 1, at[2] - 1, at[3] - 1) : 9.0;
              }),
        field("THT", axes, "K", constant(300.0)),
        field("PABST", axes, "Pa", constant(9e4)),
        field("RVT", axes, "kg kg-1", constant(0.01))};
    return file;
}

LesFile cfSample() {
    LesFile file;
    file.dimensions = {{"t", 1}, {"east", 4}, {"north", 3}, {"up", 5}};
    std::vector<double> northFirst(kSampleYM.rbegin(), kSampleYM.rend());
    std::vector<double> topFirst(kSampleCentresM.rbegin(), kSampleCentresM.rend());
    file.variables = {along("t", {0.5}, "hours since 2020-06-01 00:00:00"),
                      along("east", kSampleXM, "m"), along("north", northFirst, "m"),
                      along("up", topFirst, "m")};
    file.variable("east").texts = {{"standard_name", "projection_x_coordinate"}};
    file.variable("north").texts = {{"standard_name", "projection_y_coordinate"}};
    file.variable("up").texts = {{"standard_name", "height"}, {"positive", "up"}};
    const std::vector<std::string> axes{"t", "up", "north", "east"};
    const auto add = [&](const char* name, const char* standardName, const char* units,
                         IndexedValue value) {
        file.variables.push_back(field(name, axes, units, std::move(value)));
        file.variables.back().texts = {{"standard_name", standardName}, {"grid_mapping", "crs"}};
    };
    add("clw", "mass_fraction_of_cloud_liquid_water_in_air", "1",
        [](std::span<const std::size_t> at) {
            return numbered(at[0], 4 - at[1], 2 - at[2], at[3]);
        });
    add("hus", "specific_humidity", "1", constant(0.02));
    add("pfull", "air_pressure", "hPa", constant(900.0));
    add("ta", "air_temperature", "K", constant(290.0));
    LesVariable crs{"crs", {}};
    crs.texts = {{"grid_mapping_name", "lambert_conformal_conic"}};
    crs.numbers = {{"standard_parallel", {30.0, 60.0}},
                   {"longitude_of_central_meridian", {10.0}},
                   {"latitude_of_projection_origin", {50.0}},
                   {"earth_radius", {6370000.0}}};
    crs.type = NC_INT;
    crs.value = constant(0.0);
    file.variables.push_back(crs);
    return file;
}
