# embed_page(<source>): writes a C++ source with the parts of the page as EmbeddedPage. A change of one of the files
# configures again.
set(page_web ${CMAKE_CURRENT_LIST_DIR}/web)
# Order matters: a file uses what stands before it.
set(page_scripts
  dom colors decode decimate kinematics run timeline address path_error plots lanes
  arm header tables time_bar reload main)
list(TRANSFORM page_scripts REPLACE "(.+)" "${page_web}/\\1.js")

find_path(dygraphs_js dygraph.min.js PATHS /usr/share/javascript/dygraphs NO_DEFAULT_PATH REQUIRED)
find_path(three_js three.min.js PATHS /usr/share/javascript/three NO_DEFAULT_PATH REQUIRED)

# The texts of files after each other. Lines that name a source map are left out: the page must not look for other
# files.
function(join_files joined)
  set(text "")
  foreach(file IN LISTS ARGN)
    file(READ ${file} part)
    string(REGEX REPLACE "\n/[/*]# sourceMappingURL=[^\n]*" "" part "${part}")
    string(APPEND text "${part}\n")
  endforeach()
  if(EXISTS ${joined})
    file(READ ${joined} before)
  endif()
  if(NOT EXISTS ${joined} OR NOT before STREQUAL text)
    file(WRITE ${joined} "${text}")
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ARGN})
endfunction()

function(embed_page source)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/page)
  join_files(${folder}/page ${page_web}/page.html)
  join_files(${folder}/style ${dygraphs_js}/dygraph.min.css ${page_web}/page.css)
  join_files(${folder}/libraries ${dygraphs_js}/dygraph.min.js ${three_js}/three.min.js
    ${three_js}/examples/js/controls/OrbitControls.js)
  join_files(${folder}/scripts ${page_scripts})
  set(EMBEDDED_BLOCKS "")
  set(EMBEDDED_VALUES "")
  foreach(part IN ITEMS page style libraries scripts)
    set(name armature_page_${part})
    string(APPEND EMBEDDED_BLOCKS
      "asm(\".section .rodata\\n.global ${name}, ${name}_end\\n${name}: .incbin \\\"${folder}/${part}\\\"\\n\"\n"
      "    \"${name}_end: .byte 0\\n.previous\\n\");\n"
      "extern \"C\" const char ${name}[], ${name}_end[];\n")
    string(APPEND EMBEDDED_VALUES "text(${name}, ${name}_end), ")
    list(APPEND parts ${folder}/${part})
  endforeach()
  configure_file(${PROJECT_SOURCE_DIR}/cosim/page/embedded_files.cpp.in ${source} @ONLY)
  set_source_files_properties(${source} PROPERTIES
    OBJECT_DEPENDS "${parts}" SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
endfunction()
