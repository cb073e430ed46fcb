# Verilated block models and their GoogleTest programs.
#
#   add_verilated_model(<target> TOP <module> [SOURCES <file>...] [PARAMETERS <Name>=<value>...] [PREFIX <class>]
#                       [NO_ASSERT] [COVERAGE])
#     Static library with class V<module> (or PREFIX), without waveforms; RTL assertions are on unless NO_ASSERT.
#     COVERAGE counts executed lines and the `COVER points. Without SOURCES the model has the sources that <module>
#     uses, from rtl/rtl.f. SOURCES are absolute paths, packages first. A struct port `bus_i` is a port `bus_<member>_i`
#     for each member in C++ (tools/flat_ports.py).
#
#   add_rtl_test(<name> MODELS <target>... SOURCES <file>...)
#     Test program <name> linked with the models; its tests are registered with CTest. They are the recorded gate
#     rtl.<name>, and the program is not a part of the target `all`. ARMATURE_READS of <name>_objects are the arguments
#     of describe_gate, for a gate that runs the same tests.
#
# Needs find_package(verilator) and find_package(GTest).
include_guard(GLOBAL)
include(GoogleTest)

get_filename_component(ARMATURE_ROOT ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)

# rtl_closure_<module>: the sources of each module of rtl/ with everything that it uses; rtl_flat_<module>.
execute_process(COMMAND ${Python3_EXECUTABLE} -B ${ARMATURE_ROOT}/tools/rtl_list.py ${CMAKE_CURRENT_BINARY_DIR}/closures.cmake
                COMMAND_ERROR_IS_FATAL ANY)
include(${CMAKE_CURRENT_BINARY_DIR}/closures.cmake)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ARMATURE_ROOT}/tools/rtl_list.py
             ${ARMATURE_ROOT}/tools/flat_ports.py ${ARMATURE_RTL_SOURCES})

# The Verilator runtime, once for all models, with the hooks that convert $stop and $fatal to test failures.
add_library(verilated_runtime STATIC EXCLUDE_FROM_ALL
  ${VERILATOR_ROOT}/include/verilated.cpp
  ${VERILATOR_ROOT}/include/verilated_threads.cpp
  ${VERILATOR_ROOT}/include/verilated_cov.cpp
  ${ARMATURE_ROOT}/tests/support/verilated_test.cpp)
target_compile_definitions(verilated_runtime
  PRIVATE VL_USER_STOP VL_USER_FATAL
  PUBLIC VM_COVERAGE=0 VM_SC=0 VM_TRACE=0)
target_include_directories(verilated_runtime
  SYSTEM PUBLIC ${VERILATOR_ROOT}/include ${VERILATOR_ROOT}/include/vltstd)
target_include_directories(verilated_runtime PUBLIC ${ARMATURE_ROOT})
target_compile_features(verilated_runtime PUBLIC cxx_std_20)
target_link_libraries(verilated_runtime PUBLIC GTest::gtest)
set_source_files_properties(
  ${VERILATOR_ROOT}/include/verilated.cpp ${VERILATOR_ROOT}/include/verilated_threads.cpp
  ${VERILATOR_ROOT}/include/verilated_cov.cpp
  PROPERTIES COMPILE_OPTIONS "-O2;-w")

# Headers that every model and every test of a model include, precompiled. About sixty models are built and run for a
# short time each, so -O1 is the best trade-off.
add_library(model_flags INTERFACE)
target_compile_options(model_flags INTERFACE -O1 -w)
add_header_library(model_headers)
target_link_libraries(model_headers PRIVATE verilated_runtime model_flags)
target_compile_definitions(model_headers PRIVATE VM_TRACE_FST=0 VM_TRACE_VCD=0)
target_precompile_headers(model_headers PRIVATE <verilated.h>)
add_header_library(rtl_test_headers)
target_link_libraries(rtl_test_headers PRIVATE armature_flags verilated_runtime GTest::gtest)
target_compile_options(rtl_test_headers PRIVATE ${test_options})
target_precompile_headers(rtl_test_headers PRIVATE <gtest/gtest.h> <verilated.h>)
set_target_properties(model_headers rtl_test_headers PROPERTIES EXCLUDE_FROM_ALL ON)

function(add_verilated_model TARGET)
  get_filename_component(ARMATURE_ROOT ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../.. ABSOLUTE)
  cmake_parse_arguments(MODEL "NO_ASSERT;COVERAGE" "TOP;PREFIX" "SOURCES;PARAMETERS" ${ARGN})
  if(NOT MODEL_PREFIX)
    set(MODEL_PREFIX V${MODEL_TOP})
  endif()
  set(sources ${MODEL_SOURCES})
  if(NOT sources)
    set(sources ${rtl_closure_${MODEL_TOP}})
  endif()
  if(NOT sources)
    message(FATAL_ERROR "${TARGET}: no source that rtl/rtl.f lists defines the module ${MODEL_TOP}")
  endif()

  set(top ${MODEL_TOP})
  if(rtl_flat_${MODEL_TOP})
    list(APPEND sources ${rtl_flat_${MODEL_TOP}})
    set(top ${MODEL_TOP}_flat)
  endif()

  # -fno-const-bit-op-tree: Verilator 5.006 folds some bit expressions wrongly without it.
  # unique: registers without a reset power up with random bits.
  set(arguments -O3 -fno-const-bit-op-tree --x-assign unique --x-initial unique -I${ARMATURE_ROOT}/rtl/common)
  if(MODEL_NO_ASSERT)
    list(APPEND arguments +define+ASSERT_OFF)
  else()
    list(APPEND arguments --assert)
  endif()
  if(MODEL_COVERAGE)
    # Verilator 5.006 loses counts of lines that it turns into tables.
    list(APPEND arguments --coverage-line --coverage-user -fno-table +define+COVER_ON)
  endif()
  foreach(parameter ${MODEL_PARAMETERS})
    list(APPEND arguments -G${parameter})
  endforeach()

  # Changed RTL may change the set of generated files, which CMake must know before it builds: verilate() runs Verilator
  # while configuring if the command line has changed, so the command line carries a digest of the sources.
  set(digests)
  file(GLOB headers CONFIGURE_DEPENDS ${ARMATURE_ROOT}/rtl/common/*.svh)
  foreach(source ${headers} ${sources})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
    file(SHA256 ${source} digest)
    string(APPEND digests ${digest})
  endforeach()
  string(SHA256 digest "${digests}")
  list(APPEND arguments +define+SOURCES_${digest})

  add_library(${TARGET} STATIC EXCLUDE_FROM_ALL)
  verilate(${TARGET} SOURCES ${sources} TOP_MODULE ${top} PREFIX ${MODEL_PREFIX} VERILATOR_ARGS ${arguments})

  # verilated_runtime contains the runtime.
  get_target_property(all_sources ${TARGET} SOURCES)
  list(FILTER all_sources EXCLUDE REGEX "/include/verilated[a-z_]*\\.cpp$")
  set_property(TARGET ${TARGET} PROPERTY SOURCES ${all_sources})
  target_link_libraries(${TARGET} PUBLIC verilated_runtime PRIVATE model_flags)
  if(NOT MODEL_COVERAGE)  # which has other definitions
    target_precompile_headers(${TARGET} REUSE_FROM model_headers)
  endif()
  set_target_properties(${TARGET} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  # Generated headers are exempt from the warnings of the project.
  get_target_property(includes ${TARGET} INTERFACE_INCLUDE_DIRECTORIES)
  set_property(TARGET ${TARGET} PROPERTY INTERFACE_SYSTEM_INCLUDE_DIRECTORIES ${includes})

  get_target_property(binary_dir ${TARGET} BINARY_DIR)
  set_target_properties(${TARGET} PROPERTIES
    ARMATURE_TOP ${top} ARMATURE_PREFIX ${MODEL_PREFIX} ARMATURE_SOURCES "${sources}"
    ARMATURE_PARAMETERS "${MODEL_PARAMETERS}"
    ARMATURE_HEADER ${binary_dir}/CMakeFiles/${TARGET}.dir/${MODEL_PREFIX}.dir/${MODEL_PREFIX}.h)
endfunction()

# The tests are an object library, so that a mutant links the same objects with another model (tests/mutants).
function(add_rtl_test NAME)
  cmake_parse_arguments(TEST "" "" "MODELS;SOURCES" ${ARGN})
  add_library(${NAME}_objects OBJECT EXCLUDE_FROM_ALL ${TEST_SOURCES})
  set_target_properties(${NAME}_objects PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  target_link_libraries(${NAME}_objects PUBLIC armature_flags ${TEST_MODELS} GTest::gtest)
  target_compile_options(${NAME}_objects PRIVATE ${test_options})
  target_precompile_headers(${NAME}_objects REUSE_FROM rtl_test_headers)
  set_property(TARGET ${NAME}_objects PROPERTY ARMATURE_MODELS ${TEST_MODELS})
  add_executable(${NAME} EXCLUDE_FROM_ALL)
  target_link_libraries(${NAME} PRIVATE ${NAME}_objects GTest::gtest_main)
  gtest_discover_tests(${NAME} DISCOVERY_TIMEOUT 60 PROPERTIES LABELS gate:rtl.${NAME})

  # What the gate reads. The flat wrapper of a module is made from its source.
  get_filename_component(ARMATURE_ROOT ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../.. ABSOLUTE)
  file(GLOB inputs CONFIGURE_DEPENDS ${ARMATURE_ROOT}/rtl/common/*.svh ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/*.cmake)
  foreach(model ${TEST_MODELS})
    get_target_property(sources ${model} ARMATURE_SOURCES)
    list(FILTER sources EXCLUDE REGEX "_flat[.]sv$")
    list(APPEND inputs ${sources})
  endforeach()
  list(REMOVE_DUPLICATES inputs)
  set(test_sources)
  foreach(source ${TEST_SOURCES})
    get_filename_component(path ${source} ABSOLUTE)
    list(APPEND test_sources ${path})
  endforeach()
  set(reads INCLUDES ${test_sources} ${ARMATURE_ROOT}/tests/support/verilated_test.cpp
    INPUTS ${inputs} ${ARMATURE_ROOT}/tools/flat_ports.py ${ARMATURE_ROOT}/tools/rtl_list.py
    PACKAGES verilator clang-14 libgtest-dev libfmt-dev)
  set_property(TARGET ${NAME}_objects PROPERTY ARMATURE_READS ${reads})
  describe_gate(rtl.${NAME} TARGETS ${NAME} ${reads})
endfunction()
