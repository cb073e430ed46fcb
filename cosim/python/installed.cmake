# Whether the packages of tools/packages-python.txt are installed.
# The module is for the Python of Debian, to which these packages belong, or for the one that ARMATURE_PYTHON_PROGRAM names.
find_program(ARMATURE_PYTHON_PROGRAM python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_path(ARMATURE_PYBIND11_INCLUDE pybind11/pybind11.h)
set(missing "")
if(ARMATURE_PYTHON_PROGRAM)
  execute_process(
    COMMAND ${ARMATURE_PYTHON_PROGRAM} -c
      "import sysconfig as s, numpy; print(s.get_path('include'), s.get_config_var('EXT_SUFFIX'), sep=';', end='')"
    OUTPUT_VARIABLE python_facts RESULT_VARIABLE failed ERROR_QUIET)
endif()
if(NOT ARMATURE_PYTHON_PROGRAM OR failed)
  list(APPEND missing python3-numpy)
else()
  list(GET python_facts 0 ARMATURE_PYTHON_INCLUDE)
  list(GET python_facts 1 ARMATURE_PYTHON_SUFFIX)
  if(NOT EXISTS ${ARMATURE_PYTHON_INCLUDE}/Python.h)
    list(APPEND missing python3-dev)
  endif()
endif()
if(NOT ARMATURE_PYBIND11_INCLUDE)
  list(APPEND missing pybind11-dev)
endif()
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  list(APPEND missing "clang, whose code can be part of a shared library")
endif()
include(cosim/if_installed.cmake)
if_installed(ARMATURE_PYTHON "${missing}" "tools/python installs tools/packages-python.txt")
