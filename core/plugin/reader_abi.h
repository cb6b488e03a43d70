/* reader_abi.h: the interface between the program and its readers. Plain C, self-contained;
 * docs/readers.md lists what is read.
 *
 * A reader is a shared library that exports one function, nephReader. The host asks every reader
 * for a score, opens the file with the best one, asks for a description (metadata only) and later
 * reads boxes of values into its own buffers. All values are in SI units: the reader converts.
 * Nothing may be thrown across these calls. Every struct starts with NephHeader: whoever creates a
 * struct fills it in, and whoever receives it touches only what struct_size covers. */
#ifndef NEPHOSCOPE_READER_ABI_H
#define NEPHOSCOPE_READER_ABI_H

#include <stddef.h>
#include <stdint.h>

/* NOLINTBEGIN(modernize-use-using): this header is C. */

#ifdef __cplusplus
extern "C" {
#endif

/* Increases with every addition. The host serves readers of all versions so far: structs only grow
 * at their ends, and what a smaller struct_size does not cover is as if zero.
 * 1: the first. 2: place and date (from projection on), roles of vapour and wind, grids that move,
 * reasons, and rows that are stored together. 3: domains of nested runs. */
#define NEPH_READER_ABI_VERSION 3u

#if defined(_WIN32)
#define NEPH_READER_EXPORT __declspec(dllexport)
#else
#define NEPH_READER_EXPORT __attribute__((visibility("default")))
#endif

typedef struct NephHeader {
    uint32_t abi_version; /* NEPH_READER_ABI_VERSION of the side that created the struct */
    uint32_t struct_size; /* sizeof the struct on that side */
} NephHeader;

/* Air that is possible: the host refuses fields with values outside, and names the cell. A reader
 * that derives one of them from others writes NaN where one of those is impossible. */
#define NEPH_LEAST_PRESSURE_PA 1.0
#define NEPH_MOST_PRESSURE_PA 120000.0
#define NEPH_LEAST_TEMPERATURE_K 100.0
#define NEPH_MOST_TEMPERATURE_K 400.0
#define NEPH_LEAST_DENSITY_KG_PER_M3 1e-6
#define NEPH_MOST_DENSITY_KG_PER_M3 2.0
/* Water vapour, kg per kg of dry air: advection leaves small negative values. */
#define NEPH_LEAST_VAPOUR_KG_PER_KG (-0.01)
#define NEPH_MOST_VAPOUR_KG_PER_KG 0.1

/* Result of a call. */
typedef int32_t NephStatus;
#define NEPH_OK 0
#define NEPH_FAILED 1    /* the NephError has the reason */
#define NEPH_CANCELLED 2 /* the progress callback returned 0 */

/* What a variable means to the host. */
typedef int32_t NephRole;
#define NEPH_ROLE_OTHER 0
#define NEPH_ROLE_MIXING_RATIO 1         /* of `species`, kg per kg of dry air */
#define NEPH_ROLE_DRY_AIR_DENSITY 2      /* kg/m3 at cell centres */
#define NEPH_ROLE_INTERFACE_HEIGHT 3     /* m above sea level, nz + 1 levels, increasing with z */
#define NEPH_ROLE_AIR_PRESSURE 4         /* Pa */
#define NEPH_ROLE_AIR_TEMPERATURE 5      /* K */
#define NEPH_ROLE_EFFECTIVE_RADIUS 6     /* of `species`, m */
#define NEPH_ROLE_NUMBER_CONCENTRATION 7 /* of `species`, per kg of dry air */
/* Since version 2; for a host of version 1 NEPH_ROLE_OTHER. With their CF standard names. */
#define NEPH_ROLE_WATER_VAPOUR 8 /* kg per kg of dry air; humidity_mixing_ratio */
#define NEPH_ROLE_X_WIND 9       /* m/s along the grid's x at cell centres; x_wind */
#define NEPH_ROLE_Y_WIND 10      /* the same along y; y_wind */
#define NEPH_ROLE_UPWARD_WIND 11 /* m/s at cell centres; upward_air_velocity */
/* Of aerosol that takes up water, per kg of dry air; particles as core/optics/aerosol.h has them */
#define NEPH_ROLE_HYGROSCOPIC_AEROSOL_NUMBER 12
#define NEPH_ROLE_DUST_NUMBER 13 /* of mineral dust, the same */

typedef int32_t NephSpecies;
#define NEPH_SPECIES_NONE (-1)
#define NEPH_SPECIES_CLOUD 0
#define NEPH_SPECIES_ICE 1
#define NEPH_SPECIES_RAIN 2
#define NEPH_SPECIES_SNOW 3
#define NEPH_SPECIES_GRAUPEL 4
#define NEPH_SPECIES_HAIL 5

/* The scheme whose particle size distributions the hydrometeors follow. docs/physics.md §7 states
 * how the host uses each. */
typedef int32_t NephMicrophysics;
#define NEPH_MICROPHYSICS_UNKNOWN 0
#define NEPH_MICROPHYSICS_LIN 1
#define NEPH_MICROPHYSICS_WSM6 2 /* and the other single-moment schemes of that family */
#define NEPH_MICROPHYSICS_THOMPSON 3
#define NEPH_MICROPHYSICS_MORRISON 4

/* Why something failed, in parts that the host formats. The host owns it and clears it before each
 * call; the reader writes UTF-8, terminates each part with a zero byte and leaves unknown parts
 * empty. */
typedef struct NephError {
    NephHeader header;
    char where[1024];    /* file; the host fills in the path if left empty */
    char what[1024];     /* what is wrong, naming the variable or key */
    char found[1024];    /* what was found */
    char expected[1024]; /* what was expected */
    char hint[1024];     /* the next step for the user */
} NephError;

typedef struct NephTime {
    NephHeader header;
    const char* label; /* as the model writes it */
    double seconds;    /* on one clock that all files of a series share; any origin */
    /* Since version 2. */

    /* How far the grid has moved over the ground, in metres along its x and y, since its
     * south-west corner lay at map_origin_m, or, without a map, since the origin of the clock. 0
     * where the grid stands still. */
    double grid_offset_m[2];
} NephTime;

typedef struct NephVariable {
    NephHeader header;
    const char* name;          /* unique within the file */
    const char* standard_name; /* CF standard name, or empty */
    const char* units;         /* of the values that read() returns */
    const char* description;
    NephRole role;
    NephSpecies species; /* NEPH_SPECIES_NONE where the role has no species */
    /* x, y, z; 1 where the variable lacks the axis. Heights and density of models with flat levels
     * may be profiles, 1 x 1 x n. */
    int32_t size[3];
    /* Since version 2; null where a smaller struct_size does not cover it. */

    /* Why it has its role, one phrase: "the name that CM1 gives cloud water". Null or empty: not
     * stated. */
    const char* reason;
} NephVariable;

typedef struct NephAttribute {
    NephHeader header;
    const char* name;
    const char* value;
} NephAttribute;

/* Everything that is known without reading a field. It and all its strings must stay valid as long
 * as the file handle. */
typedef struct NephDescription {
    NephHeader header;
    const char* model;  /* for example "WRF V4.2.2" */
    const char* scheme; /* name of the microphysics scheme, for display, or empty */
    NephMicrophysics microphysics;
    double cloud_droplets_per_m3; /* where the run prescribes it; 0 if unknown */
    int32_t size[3];     /* cells in x, y, z on the native grid; x runs east, y north, z up */
    double spacing_m[2]; /* of the cells in x and y */
    uint32_t time_count; /* at least 1 */
    const NephTime* const* times;
    uint32_t variable_count;
    const NephVariable* const* variables;
    uint32_t note_count; /* what was skipped or assumed, one sentence each */
    const char* const* notes;
    uint32_t attribute_count; /* global attributes worth showing */
    const NephAttribute* const* attributes;
    /* What follows may be missing (a smaller struct_size) and is then as if zero. */

    /* Faces of the cells along x (size[0] + 1) and y (size[1] + 1), metres from the south-west
     * corner, the first 0, increasing; null where all cells have spacing_m. With faces, spacing_m
     * is that of the even cells which the host makes of them: the smallest step as a rule. */
    const double* edges_m[2];
    /* Which of several domains of one or more runs this is, such as "domain 2 at 35.2 N 97.4 W":
     * the host never puts files with different texts into one series. Files with one text that lie
     * whole cells apart on the earth are one domain that moves. Null or empty: unknown. */
    const char* domain;
    /* Paths of other files that this data set is read from as well, such as the tiles of other MPI
     * ranks: the host does not open them again. */
    uint32_t part_count;
    const char* const* parts;
    /* Since version 2. */

    /* Where the grid lies on the earth: a PROJ string of one projection to metres, without files or
     * pipelines, such as "+proj=lcc +lat_1=30 +lat_2=60 +lat_0=35 +lon_0=-98 +R=6370000". Null or
     * empty: unknown. */
    const char* projection;
    double map_origin_m[2]; /* the grid's south-west corner on that map, in x and y */
    /* Metres on the map per metre of the grid, as spacing_m and edges_m have it; 0 is 1. */
    double map_per_grid[2];
    /* Date and time in UTC at which `seconds` of NephTime are 0, "YYYY-MM-DDThh:mm:ssZ" in the
     * Gregorian calendar. Null or empty: unknown. */
    const char* utc_of_zero;
    /* Why there is no place, where that is as it should be: "the run is idealised". What should be
     * there and cannot be used is a note instead. Null or empty: no reason. */
    const char* no_place;
    /* How many rows of cells along y are stored as one, such as the rows of a compressed chunk: the
     * first read of any of them costs as much as reading them all, and the handle keeps the others
     * for the reads that follow. The host then reads the whole grid through one handle, from south
     * to north. 0 or 1: each row by itself. */
    uint32_t rows_together;
    /* Since version 3. */

    /* Which domain of a nested run this is: its number, from 1, and that of the domain that it lies
     * in, 0 for the outermost. 0: not a nested run. Domains are composed by their places on the
     * earth; where there are none, by the corner and the ratio, below. */
    uint32_t domain_number;
    uint32_t parent_number;
    /* Cells of the parent in x and y between its south-west corner and that of this domain, and
     * cells of this domain along a cell of the parent; a ratio of 0: unknown. */
    int32_t parent_corner[2];
    uint32_t parent_ratio;
} NephDescription;

/* Returns 0 to cancel. `fraction` lies in [0, 1]. */
typedef int32_t (*NephProgress)(void* context, double fraction);

/* One box of one variable at one time. */
typedef struct NephReadRequest {
    NephHeader header;
    uint32_t variable; /* index into the description */
    uint32_t time;     /* index into the description */
    int32_t lower[3];  /* half-open box of cells x, y, z: 0 <= lower < upper <= size */
    int32_t upper[3];
    float* values;           /* the host's buffer, x fastest, then y, then z; NaN where missing */
    uint64_t value_count;    /* size of the buffer, exactly that of the box; never exceed it */
    uint64_t values_written; /* set by the reader; fewer than value_count is a failed read */
    NephProgress progress;   /* may be null; call it between pieces of at most a few megabytes */
    void* progress_context;
} NephReadRequest;

typedef struct NephFile NephFile; /* defined by the reader */

/* A reader. The struct and its strings stay valid as long as the library is loaded. Calls may come
 * from any thread; one handle is used by one thread at a time, but different handles may be used by
 * different threads concurrently. */
typedef struct NephReader {
    NephHeader header;
    const char* id;         /* for example "wrf_netcdf" */
    const char* version;    /* of the reader */
    const char* title;      /* what it reads, for display */
    const char* extensions; /* usual extensions, separated by spaces, for file dialogs; or empty */

    /* How sure the reader is that the content of `path` (a file or a folder) is in its format; the
     * name of the file does not count. 0: unknown format. 1 to 9: the container is known, but open
     * will refuse the content and give the reason. 10 to 100: can be read. Reads a few kilobytes at
     * most. */
    int32_t (*score)(const char* path);

    /* Opens without reading a field and sets *file. */
    NephStatus (*open)(const char* path, NephFile** file, NephError* error);
    const NephDescription* (*describe)(NephFile* file);
    NephStatus (*read)(NephFile* file, NephReadRequest* request, NephError* error);
    void (*close)(NephFile* file);
    /* Since version 2; null where a smaller struct_size does not cover it. */

    /* As open, with a file named by the user that says what the variables of `path` are; the score
     * does not count then. Null: the reader takes no such file. */
    NephStatus (*open_with_map)(const char* path, const char* map, NephFile** file,
                                NephError* error);
} NephReader;

/* The one exported symbol. The host asks with its own version first, then with each older one that
 * it serves. Returns null when the reader cannot serve a host of that version: one older than it
 * was built for. */
typedef const NephReader* (*NephReaderEntry)(uint32_t host_abi_version);
#define NEPH_READER_ENTRY_NAME "nephReader"
NEPH_READER_EXPORT const NephReader* nephReader(uint32_t host_abi_version);

#ifdef __cplusplus
}
#endif

/* NOLINTEND(modernize-use-using) */
#endif
