# Headers that are parsed once for many files: the compiler spends more on them than on the code.
# Each file still includes what it uses: builds through ccache, which would not find its objects
# again, and tools/tidy do without (CMAKE_DISABLE_PRECOMPILE_HEADERS).
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES ccache)
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()
# Programs are compiled as libraries are: a precompiled header serves one kind of code.
set(CMAKE_CXX_COMPILE_OPTIONS_PIE ${CMAKE_CXX_COMPILE_OPTIONS_PIC})

set(NEPH_STD_HEADERS <algorithm> <array> <atomic> <chrono> <cmath> <cstdint> <cstring> <filesystem>
  <fstream> <functional> <map> <memory> <mutex> <optional> <set> <span> <string> <string_view>
  <thread> <utility> <vector> <fmt/format.h>)
