# The page of the workbench as the library merker_page. It is built from web/ by npm, once for all build folders (in
# build/web, shared by release, sanitizers and fuzzers); MERKER_PAGE=OFF, or a clone without web/, takes a page that
# only says so.
option(MERKER_PAGE "build the page in web/ (Node.js and npm)" ON)

set(page_folder ${PROJECT_SOURCE_DIR}/apps/page)
set(page_inputs ${page_folder}/index.html)
if(MERKER_PAGE AND EXISTS ${PROJECT_SOURCE_DIR}/web/package-lock.json)
  file(GLOB_RECURSE page_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/web/src/* ${PROJECT_SOURCE_DIR}/web/public/*)
  file(GLOB page_settings CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/web/*.json ${PROJECT_SOURCE_DIR}/web/*.html
       ${PROJECT_SOURCE_DIR}/web/*.ts)
  set(page_folder ${PROJECT_SOURCE_DIR}/build/web/dist)
  set(page_inputs ${PROJECT_SOURCE_DIR}/build/web/stamp)
  add_custom_command(
    OUTPUT ${page_inputs}
    COMMAND ${PROJECT_SOURCE_DIR}/tools/page ${PROJECT_SOURCE_DIR}/web ${PROJECT_SOURCE_DIR}/build/web
    DEPENDS ${page_sources} ${page_settings} ${PROJECT_SOURCE_DIR}/tools/page
    COMMENT "Building the page of the workbench" VERBATIM)
endif()

set(page_made ${CMAKE_CURRENT_BINARY_DIR}/page)
file(MAKE_DIRECTORY ${page_made})
add_custom_command(
  OUTPUT ${page_made}/page.S ${page_made}/page.cpp
  COMMAND ${PROJECT_SOURCE_DIR}/tools/embed ${page_folder} ${page_made}/page.S ${page_made}/page.cpp
  DEPENDS ${page_inputs} ${PROJECT_SOURCE_DIR}/tools/embed
  COMMENT "Embedding the page" VERBATIM)
set_source_files_properties(${page_made}/page.S PROPERTIES OBJECT_DEPENDS "${page_inputs}")
add_library(merker_page STATIC ${page_made}/page.S ${page_made}/page.cpp)
target_include_directories(merker_page PUBLIC ${PROJECT_SOURCE_DIR}/apps/merker)
target_link_libraries(merker_page PUBLIC merker_server)
