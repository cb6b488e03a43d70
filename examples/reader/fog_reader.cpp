// fog_reader.cpp: .fog files, one line "FOG nx ny nz dx dy dz" and cloud water in g/kg as floats.
#include <nephoscope/reader_plugin.h>

#include <cmath>
#include <fstream>

using namespace neph::plugin;

class FogFile : public File {
  public:
    explicit FogFile(const char* path) : in_(path, std::ios::binary) {
        auto& [nx, ny, nz] = about_.size;
        std::string word;
        in_ >> word >> nx >> ny >> nz >> about_.spacingM[0] >> about_.spacingM[1] >> dz_;
        if (!in_ || in_.get() != '\n') {
            throw Error{"line 1 is wrong", word, "FOG nx ny nz dx dy dz", "write the file again"};
        }
        start_ = in_.tellg();
        about_.model = "Fog 1";
        about_.times = {{"the only time", 0.0}};
        const std::array<int, 3> levels{1, 1, nz + 1}, layers{1, 1, nz};
        about_.variables = {
            {"cloud", "", "kg kg-1", "", NEPH_ROLE_MIXING_RATIO, NEPH_SPECIES_CLOUD, about_.size},
            {"height", "", "m", "", NEPH_ROLE_INTERFACE_HEIGHT, NEPH_SPECIES_NONE, levels},
            {"density", "", "kg m-3", "", NEPH_ROLE_DRY_AIR_DENSITY, NEPH_SPECIES_NONE, layers}};
    }
    const Description& description() const override { return about_; }

    void read(const Request& box) override {
        float* to = box.values;
        for (std::size_t z = box.lower[2]; z < box.upper[2]; ++z) {
            box.tick(double(z - box.lower[2]) / double(box.length(2)));
            if (box.variable == 1) *to++ = float(dz_ * double(z));
            if (box.variable == 2) *to++ = float(1.2 * std::exp(-dz_ * (double(z) + 0.5) / 8500));
            for (std::size_t y = box.lower[1]; box.variable == 0 && y < box.upper[1]; ++y) {
                const std::size_t row = z * std::size_t(about_.size[1]) + y;
                in_.clear();
                in_.seekg(start_ +
                          std::streamoff(4 * (row * std::size_t(about_.size[0]) + box.lower[0])));
                in_.read(reinterpret_cast<char*>(to), std::streamsize(4 * box.length(0)));
                if (!in_) throw Error{"cloud ends early", "", "4 bytes per cell", "copy it again"};
                for (std::size_t x = 0; x < box.length(0); ++x) *to++ *= 1e-3f;  // to kg/kg
            }
        }
    }

  private:
    std::ifstream in_;
    std::streamoff start_ = 0;
    double dz_ = 0;
    Description about_;
};

int score(const char* path) {
    std::string word;
    std::getline(std::ifstream(path), word, ' ');
    return word == "FOG" ? 80 : 0;
}
constexpr Reader kFog{"fog", "1.0", "fog files", "fog", &score, &openAs<FogFile>};
NEPHOSCOPE_READER(kFog)
