# Every library Nephoscope uses, all of them Debian packages; docs/dependencies.md gives the reasons.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(glm REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(OpenEXR REQUIRED)
find_package(PNG REQUIRED)
find_package(glfw3 REQUIRED)
pkg_check_modules(EPOXY REQUIRED IMPORTED_TARGET epoxy)
pkg_check_modules(EGL REQUIRED IMPORTED_TARGET egl)
pkg_check_modules(IMGUI REQUIRED IMPORTED_TARGET imgui)
pkg_check_modules(NETCDF REQUIRED IMPORTED_TARGET netcdf)
# HDF5 comes with NetCDF; it is named for one call, which keeps it from printing on threads that
# NetCDF did not start.
pkg_check_modules(HDF5 REQUIRED IMPORTED_TARGET hdf5)
# Debian's pkg-config file of ecCodes names folders that do not exist, and its CMake package needs
# tools of another package.
find_path(ECCODES_INCLUDE_DIR eccodes.h REQUIRED)
find_library(ECCODES_LIBRARY eccodes REQUIRED)
add_library(eccodes INTERFACE IMPORTED)
target_link_libraries(eccodes INTERFACE ${ECCODES_LIBRARY})
target_include_directories(eccodes SYSTEM INTERFACE ${ECCODES_INCLUDE_DIR})
pkg_check_modules(PROJ REQUIRED IMPORTED_TARGET proj)
pkg_check_modules(UDUNITS REQUIRED IMPORTED_TARGET udunits)
if(NEPHOSCOPE_TESTS)
  find_package(doctest REQUIRED)
endif()
