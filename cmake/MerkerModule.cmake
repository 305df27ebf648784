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

# g++ 12 at -O3 takes a std::optional that was tested for one that may be empty: -Wmaybe-uninitialized stays off, the
# sanitizers of the debug preset look for the real ones.
function(merker_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
    -Wno-maybe-uninitialized)
  if(PROJECT_IS_TOP_LEVEL)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
