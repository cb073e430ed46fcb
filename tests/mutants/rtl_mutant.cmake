# add_rtl_mutant(NAME <name> FILE <file below rtl/> FROM <text> TO <text>
#                TEST <test program> KILLED_BY <gtest filter> [MODEL <target>])
#
# Builds TEST against its model with one line of RTL broken, and registers the CTest mutant.<name>, which passes only if
# every test that KILLED_BY names fails by a check. FROM must occur exactly once in FILE. MODEL is the model that gets
# the mutant; without it, the first one of TEST.
#
# The mutated copy follows its original: CMake runs again when FILE changes. Assertions in the RTL are off, so that the
# test itself has to notice. The test objects are those of TEST; only the mutated model is compiled.
include_guard(GLOBAL)

function(add_rtl_mutant)
  cmake_parse_arguments(PARSE_ARGV 0 MUTANT "" "NAME;FILE;FROM;TO;TEST;KILLED_BY;MODEL" "")
  get_filename_component(ARMATURE_ROOT ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../.. ABSOLUTE)
  set(target mutant_${MUTANT_NAME})
  set(original ${ARMATURE_ROOT}/rtl/${MUTANT_FILE})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${original})

  file(READ ${original} text)
  string(REPLACE "${MUTANT_FROM}" "${MUTANT_TO}" mutated "${text}")
  string(LENGTH "${text}" before)
  string(REPLACE "${MUTANT_FROM}" "" removed "${text}")
  string(LENGTH "${removed}" after)
  string(LENGTH "${MUTANT_FROM}" length)
  math(EXPR removed_length "${before} - ${after}")
  if(NOT removed_length EQUAL length)
    message(FATAL_ERROR "mutant ${MUTANT_NAME}: FROM must occur exactly once in ${MUTANT_FILE}:\n${MUTANT_FROM}")
  endif()
  get_filename_component(file_name ${MUTANT_FILE} NAME)
  set(copy ${CMAKE_CURRENT_BINARY_DIR}/${MUTANT_NAME}/${file_name})
  file(CONFIGURE OUTPUT ${copy} CONTENT "${mutated}" @ONLY)  # leaves an equal file untouched

  get_target_property(models ${MUTANT_TEST}_objects ARMATURE_MODELS)
  if(NOT MUTANT_MODEL)
    list(GET models 0 MUTANT_MODEL)
  endif()
  foreach(property TOP PREFIX SOURCES PARAMETERS HEADER)
    get_target_property(${property} ${MUTANT_MODEL} ARMATURE_${property})
  endforeach()
  if(NOT original IN_LIST SOURCES)
    message(FATAL_ERROR "mutant ${MUTANT_NAME}: ${MUTANT_MODEL} does not contain ${MUTANT_FILE}")
  endif()
  list(TRANSFORM SOURCES REPLACE "^${original}$" "${copy}")
  add_verilated_model(${target}_model NO_ASSERT TOP ${TOP} PREFIX ${PREFIX} SOURCES ${SOURCES}
                      PARAMETERS ${PARAMETERS})

  # The test objects were compiled against the header of the healthy model.
  get_target_property(mutant_header ${target}_model ARMATURE_HEADER)
  file(SHA256 ${HEADER} healthy_hash)
  file(SHA256 ${mutant_header} mutant_hash)
  if(NOT healthy_hash STREQUAL mutant_hash)
    message(FATAL_ERROR "mutant ${MUTANT_NAME} changes the class of the model: ${mutant_header}")
  endif()

  list(REMOVE_ITEM models ${MUTANT_MODEL})
  add_executable(${target} $<TARGET_OBJECTS:${MUTANT_TEST}_objects>)
  target_link_libraries(${target} PRIVATE ${target}_model ${models} GTest::gtest_main)
  add_test(NAME mutant.${MUTANT_NAME}
           COMMAND Python3::Interpreter -B ${ARMATURE_ROOT}/tests/mutants/expect_killed.py
                   $<TARGET_FILE:${target}> ${MUTANT_KILLED_BY})
  set_tests_properties(mutant.${MUTANT_NAME} PROPERTIES LABELS mutant)
endfunction()
