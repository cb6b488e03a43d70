/* reader_abi_1.h: version 1 of core/plugin/reader_abi.h, frozen, without its comments: what readers
 * were built against. */
#ifndef NEPHOSCOPE_READER_ABI_1_H
#define NEPHOSCOPE_READER_ABI_1_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define NEPH_READER_ABI_VERSION 1u

#if defined(_WIN32)
#define NEPH_READER_EXPORT __declspec(dllexport)
#else
#define NEPH_READER_EXPORT __attribute__((visibility("default")))
#endif

typedef struct NephHeader {
    uint32_t abi_version;
    uint32_t struct_size;
} NephHeader;

#define NEPH_LEAST_PRESSURE_PA 1.0
#define NEPH_MOST_PRESSURE_PA 120000.0
#define NEPH_LEAST_TEMPERATURE_K 100.0
#define NEPH_MOST_TEMPERATURE_K 400.0
#define NEPH_LEAST_DENSITY_KG_PER_M3 1e-6
#define NEPH_MOST_DENSITY_KG_PER_M3 2.0

#define NEPH_LEAST_VAPOUR_KG_PER_KG (-0.01)
#define NEPH_MOST_VAPOUR_KG_PER_KG 0.1

typedef int32_t NephStatus;
#define NEPH_OK 0
#define NEPH_FAILED 1
#define NEPH_CANCELLED 2

typedef int32_t NephRole;
#define NEPH_ROLE_OTHER 0
#define NEPH_ROLE_MIXING_RATIO 1
#define NEPH_ROLE_DRY_AIR_DENSITY 2
#define NEPH_ROLE_INTERFACE_HEIGHT 3
#define NEPH_ROLE_AIR_PRESSURE 4
#define NEPH_ROLE_AIR_TEMPERATURE 5
#define NEPH_ROLE_EFFECTIVE_RADIUS 6
#define NEPH_ROLE_NUMBER_CONCENTRATION 7

typedef int32_t NephSpecies;
#define NEPH_SPECIES_NONE (-1)
#define NEPH_SPECIES_CLOUD 0
#define NEPH_SPECIES_ICE 1
#define NEPH_SPECIES_RAIN 2
#define NEPH_SPECIES_SNOW 3
#define NEPH_SPECIES_GRAUPEL 4
#define NEPH_SPECIES_HAIL 5

typedef int32_t NephMicrophysics;
#define NEPH_MICROPHYSICS_UNKNOWN 0
#define NEPH_MICROPHYSICS_LIN 1
#define NEPH_MICROPHYSICS_WSM6 2
#define NEPH_MICROPHYSICS_THOMPSON 3
#define NEPH_MICROPHYSICS_MORRISON 4

typedef struct NephError {
    NephHeader header;
    char where[1024];
    char what[1024];
    char found[1024];
    char expected[1024];
    char hint[1024];
} NephError;

typedef struct NephTime {
    NephHeader header;
    const char* label;
    double seconds;
} NephTime;

typedef struct NephVariable {
    NephHeader header;
    const char* name;
    const char* standard_name;
    const char* units;
    const char* description;
    NephRole role;
    NephSpecies species;

    int32_t size[3];
} NephVariable;

typedef struct NephAttribute {
    NephHeader header;
    const char* name;
    const char* value;
} NephAttribute;

typedef struct NephDescription {
    NephHeader header;
    const char* model;
    const char* scheme;
    NephMicrophysics microphysics;
    double cloud_droplets_per_m3;
    int32_t size[3];
    double spacing_m[2];
    uint32_t time_count;
    const NephTime* const* times;
    uint32_t variable_count;
    const NephVariable* const* variables;
    uint32_t note_count;
    const char* const* notes;
    uint32_t attribute_count;
    const NephAttribute* const* attributes;

    const double* edges_m[2];

    const char* domain;

    uint32_t part_count;
    const char* const* parts;
} NephDescription;

typedef int32_t (*NephProgress)(void* context, double fraction);

typedef struct NephReadRequest {
    NephHeader header;
    uint32_t variable;
    uint32_t time;
    int32_t lower[3];
    int32_t upper[3];
    float* values;
    uint64_t value_count;
    uint64_t values_written;
    NephProgress progress;
    void* progress_context;
} NephReadRequest;

typedef struct NephFile NephFile;

typedef struct NephReader {
    NephHeader header;
    const char* id;
    const char* version;
    const char* title;
    const char* extensions;

    int32_t (*score)(const char* path);

    NephStatus (*open)(const char* path, NephFile** file, NephError* error);
    const NephDescription* (*describe)(NephFile* file);
    NephStatus (*read)(NephFile* file, NephReadRequest* request, NephError* error);
    void (*close)(NephFile* file);
} NephReader;

typedef const NephReader* (*NephReaderEntry)(uint32_t host_abi_version);
#define NEPH_READER_ENTRY_NAME "nephReader"
NEPH_READER_EXPORT const NephReader* nephReader(uint32_t host_abi_version);

#ifdef __cplusplus
}
#endif

#endif
