# Gates whose passes tests/passes.txt records by content (tools/gates/recorded.py).
#
#   describe_gate(<gate> [TARGETS <target>...] [INCLUDES <source>...] [INPUTS <file>...] [PACKAGES <package>...])
#     Writes the description of a gate for tools/test: the programs that it needs, the C++ sources and the other files
#     that it reads, and the Debian packages that run it. Its tests have the label gate:<gate>. Relative
#     paths are those of the caller's folder.
include_guard(GLOBAL)

file(REMOVE_RECURSE ${PROJECT_BINARY_DIR}/gates)
add_custom_target(recorded_gates)  # the programs of all recorded gates

function(describe_gate gate)
  cmake_parse_arguments(arg "" "" "TARGETS;INCLUDES;INPUTS;PACKAGES" ${ARGN})
  if(arg_TARGETS)  # the options that compile them
    list(APPEND arg_INPUTS ${PROJECT_SOURCE_DIR}/CMakeLists.txt ${PROJECT_SOURCE_DIR}/CMakePresets.json
      ${PROJECT_SOURCE_DIR}/tests/CMakeLists.txt)
  endif()
  set(text "")
  foreach(target ${arg_TARGETS})
    string(APPEND text "target ${target}\n")
    add_dependencies(recorded_gates ${target})
  endforeach()
  foreach(kind include input)
    string(TOUPPER ${kind}S files)
    foreach(file ${arg_${files}})
      get_filename_component(path ${file} ABSOLUTE)
      string(APPEND text "${kind} ${path}\n")
    endforeach()
  endforeach()
  foreach(package ${arg_PACKAGES})
    string(APPEND text "package ${package}\n")
  endforeach()
  file(WRITE ${PROJECT_BINARY_DIR}/gates/${gate}.gate "${text}")
endfunction()
