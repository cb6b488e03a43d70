// memory_dataset.h: a data set in memory for tests: heights, density, and species by function.
#pragma once
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "core/dataset/dataset.h"

/// A dataset in memory: heights, unit or given density, and species by function.
class MemoryDataset : public neph::Dataset {
  public:
    MemoryDataset(glm::ivec3 size, const std::function<float(int x, int y, int z)>& height) {
        info_.size = size;
        info_.spacingM = {500.0, 250.0};
        info_.times = {{"2024-05-06_21:00:00", 0.0, "memory", 0}};
        add("z", neph::VariableRole::interfaceHeight, {}, size + glm::ivec3(0, 0, 1), height);
        add("rho", neph::VariableRole::dryAirDensity, {}, size,
            [](int, int, int z) { return 1.2f * std::exp(-0.05f * static_cast<float>(z)); });
    }

    void addRatio(neph::Species species, const std::function<float(int, int, int)>& value) {
        add("Q_" + std::string(neph::info(species).id), neph::VariableRole::mixingRatio, species,
            info_.size, value);
    }

    neph::Array3f read(std::string_view variable, int, std::optional<neph::CellBox> box,
                       const neph::Progress&) override {
        const neph::Array3f& field = fields_.at(std::string(variable));
        if (!box) return field;
        neph::Array3f part(box->size());
        for (int z = 0; z < part.size.z; ++z) {
            for (int y = 0; y < part.size.y; ++y) {
                for (int x = 0; x < part.size.x; ++x) {
                    const glm::ivec3 cell = box->lower + glm::ivec3(x, y, z);
                    part.at(x, y, z) = field.at(cell.x, cell.y, cell.z);
                }
            }
        }
        return part;
    }
    std::unique_ptr<neph::Dataset> anotherHandle() const override {
        auto other = std::unique_ptr<MemoryDataset>(new MemoryDataset);
        other->info_ = info_;
        other->fields_ = fields_;
        return other;
    }

    /// The same with heights and density as they are in the south-west column, 1 x 1 x n.
    MemoryDataset withProfiles() const {
        MemoryDataset flat;
        flat.info_ = info_;
        flat.info_.variables.clear();
        for (const auto& variable : info_.variables) {
            const neph::Array3f& field = fields_.at(variable.name);
            flat.add(variable.name, variable.role, variable.species, {1, 1, field.size.z},
                     [&](int, int, int z) { return field.at(0, 0, z); });
        }
        return flat;
    }

    void add(const std::string& name, neph::VariableRole role, std::optional<neph::Species> species,
             glm::ivec3 size, const std::function<float(int, int, int)>& value) {
        neph::VariableInfo variable;
        variable.name = name;
        variable.role = role;
        variable.species = species;
        variable.size = size;
        info_.variables.push_back(variable);
        neph::Array3f field(size);
        for (int z = 0; z < size.z; ++z) {
            for (int y = 0; y < size.y; ++y) {
                for (int x = 0; x < size.x; ++x) field.at(x, y, z) = value(x, y, z);
            }
        }
        fields_[name] = std::move(field);
    }

  private:
    MemoryDataset() = default;

    std::map<std::string, neph::Array3f> fields_;
};
