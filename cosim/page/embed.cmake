# embed_page(<source>): writes a C++ source with the parts of the page as EmbeddedPage. A change of one of the files
# configures again.
set(page_web ${CMAKE_CURRENT_LIST_DIR}/web)
# Order matters: a file uses what stands before it.
set(page_scripts
  dom colors decode decimate kinematics run timeline address path_error plots lanes
  frames meshes arm tool_path program_text header tables time_bar keys reload main)
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

# embed_parts(<source> <function> <folder>): writes a C++ source with the files page, style, libraries and scripts of the
# folder as an EmbeddedPage, which the function returns.
function(embed_parts source function folder)
  set(EMBEDDED_BLOCKS "")
  set(EMBEDDED_VALUES "")
  foreach(part IN ITEMS page style libraries scripts)
    set(name armature_${function}_${part})
    string(APPEND EMBEDDED_BLOCKS
      "asm(\".section .rodata\\n.global ${name}, ${name}_end\\n${name}: .incbin \\\"${folder}/${part}\\\"\\n\"\n"
      "    \"${name}_end: .byte 0\\n.previous\\n\");\n"
      "extern \"C\" const char ${name}[], ${name}_end[];\n")
    string(APPEND EMBEDDED_VALUES "text(${name}, ${name}_end), ")
    list(APPEND parts ${folder}/${part})
  endforeach()
  set(EMBEDDED_FUNCTION ${function})
  configure_file(${PROJECT_SOURCE_DIR}/cosim/page/embedded_files.cpp.in ${source} @ONLY)
  set_source_files_properties(${source} PROPERTIES
    OBJECT_DEPENDS "${parts}" SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
endfunction()

function(embed_page source)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/page)
  join_files(${folder}/page ${page_web}/page.html)
  join_files(${folder}/style ${dygraphs_js}/dygraph.min.css ${page_web}/page.css)
  join_files(${folder}/libraries ${dygraphs_js}/dygraph.min.js ${three_js}/three.min.js
    ${three_js}/examples/js/controls/OrbitControls.js)
  join_files(${folder}/scripts ${page_scripts})
  embed_parts(${source} embedded_page ${folder})
endfunction()

# The page of `armature live`: the style and the arm of the report, and its own files. The program takes the libraries of
# the report.
set(live_web ${PROJECT_SOURCE_DIR}/cosim/live/web)
set(live_scripts
  ${page_web}/dom.js ${page_web}/colors.js ${page_web}/decode.js ${page_web}/kinematics.js ${page_web}/frames.js
  ${page_web}/meshes.js ${page_web}/arm.js)
foreach(file IN ITEMS connection live_arm live_plots lamps jog drive program hand faults past status live_main)
  list(APPEND live_scripts ${live_web}/${file}.js)
endforeach()

function(embed_live_page source)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/live_page)
  join_files(${folder}/page ${live_web}/live.html)
  join_files(${folder}/style ${dygraphs_js}/dygraph.min.css ${page_web}/page.css ${live_web}/live.css)
  join_files(${folder}/libraries)
  join_files(${folder}/scripts ${live_scripts})
  embed_parts(${source} embedded_live_page ${folder})
endfunction()
