# One module, src/<wing>/<module>, is one static library; its headers are included as "<module>/<file>.h". Who uses a
# library gets the folder of its wing, so the compiler itself finds no header of a wing that is not used.
#   merker_module(<name> SOURCES <files...> USES <modules or packages...> [APART <files...>] [SINGLE] [TOGETHER <n>] [FAST]
#                 [QUICK] [PRECOMPILED <name>] [NOT_PRECOMPILED] [OPTIONS <compiler options...>])
# APART, SINGLE, TOGETHER: see merker_together. FAST: every instruction of a program passes here; the release build compiles file
# by file, because GCC inlines less in a large unit. QUICK: no program waits for it, so it is built quickly, see
# merker_quick_build. PRECOMPILED: the headers of merker_common(<name>) in place of the usual ones. NOT_PRECOMPILED: the module
# has compiler options of its own.
# The include rule (which module may see which) is checked by tests/architecture, not here.
function(merker_module name)
  cmake_parse_arguments(M "SINGLE;FAST;QUICK;NOT_PRECOMPILED" "PRECOMPILED;TOGETHER" "SOURCES;USES;APART;OPTIONS" ${ARGN})
  if(M_SOURCES)
    add_library(merker_${name} STATIC ${M_SOURCES})
    set(scope PUBLIC)
  else()
    add_library(merker_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  cmake_path(GET CMAKE_CURRENT_SOURCE_DIR PARENT_PATH wing)
  target_include_directories(merker_${name} ${scope} ${wing})
  foreach(used ${M_USES})
    if(TARGET ${used} OR used MATCHES "::")
      target_link_libraries(merker_${name} ${scope} ${used})
    else()
      target_link_libraries(merker_${name} ${scope} merker_${used})
    endif()
  endforeach()
  if(M_SOURCES)
    merker_warnings(merker_${name})
    if(M_QUICK AND CMAKE_BUILD_TYPE STREQUAL "Release")
      list(APPEND M_OPTIONS ${merker_quick_build})
      set(M_PRECOMPILED merker_common_quick)
    endif()
    target_compile_options(merker_${name} PRIVATE ${M_OPTIONS})
    if(NOT M_NOT_PRECOMPILED)
      if(NOT M_PRECOMPILED)
        set(M_PRECOMPILED merker_common)
      endif()
      merker_precompiled(merker_${name} ${M_PRECOMPILED})
    endif()
    if(M_SINGLE OR (M_FAST AND CMAKE_BUILD_TYPE STREQUAL "Release"))
      set_target_properties(merker_${name} PROPERTIES UNITY_BUILD OFF)
    elseif(CMAKE_UNITY_BUILD)
      merker_together(merker_${name} "${M_TOGETHER}" ${M_APART})
    endif()
  endif()
endfunction()

# Ten files in one go compile in the time of two, thirty in that of four:
# merker_together(<target> <n> <files to compile alone...>). The latter have a helper with the name of a helper in another file
# of the target; n: so many files in one go; empty: as many as the preset says. Files with large templates (JSON, command
# line) gain from more, modules with many equal names need less; SINGLE: no unity build. The preset `tidy` compiles each file
# of src/ by itself, without precompiled headers: each includes what it needs.
set(MERKER_TOGETHER 30 CACHE STRING "files that are compiled in one go")
set(MERKER_TOGETHER_MOST 100 CACHE STRING "files that are compiled in one go at most")
function(merker_together target count)
  if(NOT count)
    set(count ${MERKER_TOGETHER})
  endif()
  if(count GREATER MERKER_TOGETHER_MOST)
    set(count ${MERKER_TOGETHER_MOST})
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${count})
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# The headers that nearly every file includes, compiled once for all modules and once for all tests (a precompiled header
# serves targets with the same options): a build takes a quarter less. Each file still names what it uses;
# -DMERKER_PRECOMPILED=OFF finds a file that does not.
option(MERKER_PRECOMPILED "compile the common headers once" ON)
set(merker_common_headers <algorithm> <array> <charconv> <cmath> <cstdint> <functional> <map> <memory> <optional> <set>
  <span> <string> <string_view> <utility> <variant> <vector> <fmt/format.h>)

# For what waits for people, files and sockets: readers of project files, JSON and command lines are large templates; at -Og
# they compile in half of the time that they take at -O3, and what they do takes no time that anybody sees.
set(merker_quick_build "$<$<CONFIG:Release>:-Og>")

# merker_common(<name> [HEADERS <more headers...>] [OPTIONS <of its users...>]): an object library that holds the compiled
# headers.
function(merker_common name)
  cmake_parse_arguments(C "" "" "HEADERS;OPTIONS" ${ARGN})
  if(MERKER_PRECOMPILED)
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/${name}.cpp CONTENT "")
    add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/${name}.cpp)
    target_link_libraries(${name} PRIVATE fmt::fmt)
    merker_warnings(${name})
    target_compile_options(${name} PRIVATE ${C_OPTIONS})
    target_precompile_headers(${name} PRIVATE ${merker_common_headers} ${C_HEADERS})
  endif()
endfunction()

# merker_precompiled(<target> <name>): the target uses the headers of merker_common(<name>).
function(merker_precompiled target name)
  if(MERKER_PRECOMPILED)
    target_link_libraries(${target} PRIVATE fmt::fmt)
    target_precompile_headers(${target} REUSE_FROM ${name})
  endif()
endfunction()

function(merker_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
  # The sanitizers of the debug build make GCC see things; the release build is the judge of warnings.
  if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
    # GCC 12 sees uninitialised and overflowing strings at -O3 where there are none; these stay warnings. The sanitizers
    # find real ones.
    set(imagined maybe-uninitialized stringop-overflow array-bounds)
    target_compile_options(${target} PRIVATE -Werror
                           "$<$<CXX_COMPILER_ID:GNU>:-Wno-error=$<JOIN:${imagined},;-Wno-error=>>")
  endif()
endfunction()
