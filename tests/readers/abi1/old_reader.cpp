// old_reader.cpp: a reader as version 1 of the ABI had them: it answers to that version alone, and
// to structs of that version alone. It reads any file that begins with "old".
#include <array>
#include <fstream>
#include <string>

#include "tests/readers/abi1/reader_abi_1.h"

struct NephFile {
    int unused;
};

namespace {

NephFile theFile{0};

template <typename T>
constexpr NephHeader header() {
    return {1, static_cast<std::uint32_t>(sizeof(T))};
}

const NephTime kTime{header<NephTime>(), "noon", 43200.0};
const NephVariable kCloud{
    header<NephVariable>(), "cloud",  "", "kg kg-1", "", NEPH_ROLE_MIXING_RATIO,
    NEPH_SPECIES_CLOUD,     {2, 2, 2}};
const std::array<const NephTime*, 1> kTimes{&kTime};
const std::array<const NephVariable*, 1> kVariables{&kCloud};

std::int32_t score(const char* path) {
    std::string word;
    std::ifstream(path) >> word;
    return word == "old" ? 60 : 0;
}

NephStatus open(const char*, NephFile** file, NephError* error) {
    if (error->header.abi_version != 1) return NEPH_FAILED;
    *file = &theFile;
    return NEPH_OK;
}

const NephDescription* describe(NephFile*) {
    static NephDescription description{};
    description.header = header<NephDescription>();
    description.model = "Old 1";
    description.size[0] = description.size[1] = description.size[2] = 2;
    description.spacing_m[0] = description.spacing_m[1] = 100.0;
    description.time_count = 1;
    description.times = kTimes.data();
    description.variable_count = 1;
    description.variables = kVariables.data();
    description.domain = "domain 1";
    return &description;
}

NephStatus read(NephFile*, NephReadRequest* request, NephError*) {
    if (request->header.abi_version != 1) return NEPH_FAILED;
    for (std::uint64_t i = 0; i < request->value_count; ++i) request->values[i] = 1e-3f;
    request->values_written = request->value_count;
    return NEPH_OK;
}

void close(NephFile*) {}

const NephReader kReader{
    header<NephReader>(), "old", "1.0", "old files", "", &score, &open, &describe, &read, &close};

}  // namespace

const NephReader* nephReader(uint32_t host_abi_version) {
    return host_abi_version == NEPH_READER_ABI_VERSION ? &kReader : nullptr;
}
