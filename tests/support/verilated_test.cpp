// Replaces the hooks of the Verilator runtime that would end the process (VL_USER_STOP, VL_USER_FATAL).
#include "tests/support/verilated_test.hpp"

#include <stdexcept>
#include <string>

namespace {

// A broken property fails on thousands of edges; the first few tell everything.
constexpr int kReportedStops = 3;

bool first_stops_of_this_test() {
  static const ::testing::TestInfo* current = nullptr;
  static int reported = 0;
  const ::testing::TestInfo* test = ::testing::UnitTest::GetInstance()->current_test_info();
  if (test != current) {
    current = test;
    reported = 0;
  }
  return reported++ < kReportedStops;
}

}  // namespace

void (*armature::test::at_end_of_model)(VerilatedContext&) = nullptr;

void vl_stop(const char* filename, int linenum, const char* hier) {
  if (first_stops_of_this_test()) ADD_FAILURE_AT(filename, linenum) << "RTL assertion failed " << hier;
}

void vl_fatal(const char* filename, int linenum, const char* /*hier*/, const char* msg) {
  throw std::runtime_error(std::string(filename) + ":" + std::to_string(linenum) + ": " + msg);
}
