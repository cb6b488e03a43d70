# One interface target with the warnings of the house and, where asked for, a sanitizer.
add_library(neph_flags INTERFACE)
target_compile_options(neph_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow
  $<$<COMPILE_LANGUAGE:CXX>:-Wconversion -Wdouble-promotion -Wnon-virtual-dtor -Woverloaded-virtual>)
if(NEPHOSCOPE_WERROR)
  target_compile_options(neph_flags INTERFACE -Werror)
endif()
if(NEPHOSCOPE_SANITIZE)
  target_compile_options(neph_flags INTERFACE -fsanitize=${NEPHOSCOPE_SANITIZE} -fno-omit-frame-pointer
    -fno-sanitize-recover=all)
  target_compile_definitions(neph_flags INTERFACE NEPH_SANITIZED)
  target_link_options(neph_flags INTERFACE -fsanitize=${NEPHOSCOPE_SANITIZE})
endif()
# Code in which the fuzz targets search tells them where it has been.
add_library(neph_searched INTERFACE)
if(NEPHOSCOPE_FUZZ)
  target_compile_options(neph_searched INTERFACE -fsanitize=fuzzer-no-link)
endif()
