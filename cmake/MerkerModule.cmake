# One module of src/ is one static library; its headers are included as "<module>/<file>.h".
#   merker_module(<name> SOURCES <files...> USES <modules or packages...>)
# The include rule (which module may see which) is checked by tests/architecture, not here.
function(merker_module name)
  cmake_parse_arguments(M "" "" "SOURCES;USES" ${ARGN})
  if(M_SOURCES)
    add_library(merker_${name} STATIC ${M_SOURCES})
    set(scope PUBLIC)
  else()
    add_library(merker_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(merker_${name} ${scope} ${PROJECT_SOURCE_DIR}/src)
  foreach(used ${M_USES})
    if(TARGET ${used} OR used MATCHES "::")
      target_link_libraries(merker_${name} ${scope} ${used})
    else()
      target_link_libraries(merker_${name} ${scope} merker_${used})
    endif()
  endforeach()
  if(M_SOURCES)
    merker_warnings(merker_${name})
  endif()
endfunction()

function(merker_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
  # The sanitizers of the debug build make GCC see things; the release build is the judge of warnings.
  if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
    # GCC 12 sees uninitialised strings at -O3 where there are none; that one warning stays a warning.
    target_compile_options(${target} PRIVATE -Werror
                           $<$<CXX_COMPILER_ID:GNU>:-Wno-error=maybe-uninitialized>)
  endif()
endfunction()
