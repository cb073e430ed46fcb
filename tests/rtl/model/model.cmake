# Each model of cosim/model against its verilated block, and broken models that this must find.
set(woven_models ${CMAKE_CURRENT_BINARY_DIR}/woven_models)
file(GLOB model_sources CONFIGURE_DEPENDS ${ARMATURE_ROOT}/cosim/model/*.?pp ${ARMATURE_ROOT}/cosim/model/*/*.?pp)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${model_sources} ${CMAKE_CURRENT_LIST_DIR}/mutants.toml
             ${CMAKE_CURRENT_LIST_DIR}/weave.py)
execute_process(COMMAND ${Python3_EXECUTABLE} -B ${CMAKE_CURRENT_LIST_DIR}/weave.py ${woven_models}
                COMMAND_ERROR_IS_FATAL ANY)

# add_block_lockstep(<block> MODEL <verilated model>... SOURCES <source below cosim/model>...)
#   The test program <block>_lockstep_test from model/<block>_lockstep_test.cpp. model_mutants_<block> is the same program
#   with the broken models.
function(add_block_lockstep BLOCK)
  cmake_parse_arguments(BLOCK "" "" "MODEL;SOURCES" ${ARGN})
  set(sources bus_port.cpp ${BLOCK_SOURCES})
  list(TRANSFORM sources PREPEND ${ARMATURE_ROOT}/cosim/model/ OUTPUT_VARIABLE healthy)
  list(TRANSFORM sources PREPEND ${woven_models}/cosim/model/ OUTPUT_VARIABLE woven)
  set(test ${CMAKE_CURRENT_SOURCE_DIR}/model/${BLOCK}_lockstep_test.cpp)
  add_rtl_test(${BLOCK}_lockstep_test MODELS ${BLOCK_MODEL} SOURCES ${test} ${healthy})

  add_executable(model_mutants_${BLOCK} EXCLUDE_FROM_ALL ${test} ${woven})
  target_include_directories(model_mutants_${BLOCK} BEFORE PRIVATE ${woven_models})
  target_link_libraries(model_mutants_${BLOCK} PRIVATE armature_flags ${BLOCK_MODEL} GTest::gtest_main)
  target_compile_options(model_mutants_${BLOCK} PRIVATE ${test_options} -Wno-shadow -Wno-parentheses)
  get_target_property(reads ${BLOCK}_lockstep_test_objects ARMATURE_READS)
  describe_gate(model_mutants.${BLOCK} TARGETS model_mutants_${BLOCK} ${reads} PACKAGES python3.11
    INPUTS ${CMAKE_CURRENT_SOURCE_DIR}/model/mutants.toml ${CMAKE_CURRENT_SOURCE_DIR}/model/weave.py
           ${ARMATURE_ROOT}/tests/mutants/expect_killed.py)
endfunction()

# The test of whole ticks and of cores that run ahead, with the broken models in the simulation. The program has the woven
# copies beside the library, which has the healthy ones: the linker takes the first.
set(whole_ticks_test ${ARMATURE_ROOT}/tests/cosim/kernel/whole_ticks_test.cpp)
set(woven ${woven_models}/cosim/model)
add_executable(model_mutants_whole_ticks EXCLUDE_FROM_ALL ${whole_ticks_test} ${woven}/model_soc.cpp
  ${woven}/encoder/encoder.cpp ${woven}/pulse_train/pulse_axis.cpp ${woven}/pulse_train/pulse_train.cpp)
target_include_directories(model_mutants_whole_ticks BEFORE PRIVATE ${woven_models})
target_link_libraries(model_mutants_whole_ticks PRIVATE armature_cosim GTest::gmock GTest::gtest_main)
target_include_directories(model_mutants_whole_ticks SYSTEM PRIVATE $<TARGET_PROPERTY:model_arm_soc,INTERFACE_INCLUDE_DIRECTORIES>)
target_compile_options(model_mutants_whole_ticks PRIVATE ${test_options} -Wno-shadow -Wno-parentheses)
target_link_options(model_mutants_whole_ticks PRIVATE -Wl,--allow-multiple-definition)
# What it finds depends on when the controller accesses the logic, so on all sources of the simulation.
set(simulation_sources "")
foreach(library armature_controller_input armature_controller armature_input armature_loop armature_cosim)
  get_target_property(library_sources ${library} SOURCES)
  get_target_property(folder ${library} SOURCE_DIR)
  list(FILTER library_sources EXCLUDE REGEX "^\\$<|^${PROJECT_BINARY_DIR}")
  list(TRANSFORM library_sources REPLACE "^([^/].*)" "${folder}/\\1")
  list(APPEND simulation_sources ${library_sources})
endforeach()
file(GLOB rtl_headers CONFIGURE_DEPENDS ${ARMATURE_ROOT}/rtl/common/*.svh)
describe_gate(model_mutants.whole_ticks TARGETS model_mutants_whole_ticks PACKAGES python3.11
  INCLUDES ${whole_ticks_test} ${simulation_sources}
  INPUTS ${CMAKE_CURRENT_LIST_DIR}/mutants.toml ${CMAKE_CURRENT_LIST_DIR}/weave.py ${ARMATURE_RTL_SOURCES} ${rtl_headers}
         ${ARMATURE_ROOT}/rtl/lint.vlt ${ARMATURE_ROOT}/tools/direct_eval ${ARMATURE_ROOT}/tools/flops
         ${ARMATURE_ROOT}/tests/mutants/expect_killed.py)

# add_model_mutant(<name> <number> <block> <GoogleTest filter>): passes if lock-step finds the mutant.
function(add_model_mutant NAME NUMBER BLOCK KILLED_BY)
  add_test(NAME model_mutant.${NAME} COMMAND Python3::Interpreter -B ${ARMATURE_ROOT}/tests/mutants/expect_killed.py
                                             $<TARGET_FILE:model_mutants_${BLOCK}> ${NUMBER} ${KILLED_BY})
  set_tests_properties(model_mutant.${NAME} PROPERTIES LABELS "mutant;gate:model_mutants.${BLOCK}")
endfunction()

foreach(block bus_port timer gpio uart encoder pulse_train pulse_width ik_cordic policy_mlp)
  include(model/${block}.cmake)
endforeach()
include(${woven_models}/mutants.cmake)
