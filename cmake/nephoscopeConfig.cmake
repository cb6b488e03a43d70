# find_package(nephoscope): what a reader plugin is built against. Headers alone: nothing of the
# program's own dependencies is needed.
include(${CMAKE_CURRENT_LIST_DIR}/nephoscopeTargets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/nephoscope_add_reader.cmake)
