# The mathematics of the controller against MPFR.
find_library(MPFR_LIBRARY mpfr REQUIRED)
find_library(GMP_LIBRARY gmp REQUIRED)
add_unit_test(controller_math_test
  SOURCES math_test.cpp
  LIBRARIES armature::controller ${MPFR_LIBRARY} ${GMP_LIBRARY})

# Time laws.
target_sources(controller_unit_test PRIVATE
  scurve_motion_test.cpp
  scurve_test.cpp
  time_law_test.cpp)
