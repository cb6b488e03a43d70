// look_table.h: the groups of rows that the parameter table is put together from.
#pragma once
#include <vector>

#include "core/look/parameter.h"

namespace neph {

void addModes(std::vector<Parameter>& table);
void addFields(std::vector<Parameter>& table);
void addLight(std::vector<Parameter>& table);
void addUniformPhase(std::vector<Parameter>& table);
void addSunAndSky(std::vector<Parameter>& table);
void addView(std::vector<Parameter>& table);
void addSampling(std::vector<Parameter>& table);

}  // namespace neph
