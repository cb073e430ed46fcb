// The controller in libraries of its own: it needs nothing of its host but the memory and the bus. Two copies of one
// library run at the same time and report, byte for byte, what the linked controller reports.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "controller/host_memory/wire.hpp"
#include "tests/controller/app/library/controller_library.hpp"
#include "tests/controller/support/controller_rig.hpp"
#include "tests/controller/support/path_rig.hpp"

namespace armature {
namespace {

namespace fs = std::filesystem;
using host_memory::BootProgram;
using host_memory::HostMemory;
using test::BusFunctions;
using test::ControllerMains;
using test::ControllerRig;

RegisterBus& of(void* bus) {
  return *static_cast<RegisterBus*>(bus);
}
BusFunctions functions_of(RegisterBus& bus) {
  return {
      .bus = &bus,
      .read32 = [](void* to, std::uint32_t addr) { return of(to).read32({addr}); },
      .write32 = [](void* to, std::uint32_t addr, std::uint32_t value) { of(to).write32({addr}, value); },
      .wait_for_interrupt =
          [](void* to, std::uint32_t mask) {
            return static_cast<std::uint32_t>(of(to).wait_for_interrupt(static_cast<Interrupts>(mask)));
          },
      .send_event = [](void* to) { of(to).send_event(); },
      .now = [](void* to) { return of(to).now().value(); },
      .charge = [](void* to, std::uint8_t work, std::int64_t times) { of(to).charge(static_cast<Work>(work), times); }};
}

// A copy of the library with a controller. Files of two names are two libraries for the loader, even if they are equal.
class Copy {
 public:
  explicit Copy(const std::string& name)
      : file_{fs::path{testing::TempDir()} / (name + std::to_string(getpid()) + ".so")} {
    fs::copy_file(CONTROLLER_LIBRARY, file_, fs::copy_options::overwrite_existing);
    library_ = dlopen(file_.c_str(), RTLD_NOW | RTLD_LOCAL);
    EXPECT_NE(library_, nullptr) << dlerror();
    construct_ = symbol<test::ControllerConstruct>("armature_controller_construct");
    main_ = symbol<test::ControllerMain>("armature_controller_main");
    controller_.resize(symbol<test::ControllerSize>("armature_controller_size")() / sizeof(std::uint64_t) + 1);
  }
  Copy(const Copy&) = delete;
  Copy& operator=(const Copy&) = delete;
  ~Copy() {
    dlclose(library_);
    fs::remove(file_);
  }

  ControllerMains start(HostMemory& memory) {
    construct_(controller_.data(), &memory);
    const auto main_of = [this](int core) {
      return [this, core](RegisterBus& bus) {
        const BusFunctions functions = functions_of(bus);
        main_(controller_.data(), core, &functions);
      };
    };
    return {.core0 = main_of(0), .core1 = main_of(1)};
  }
  [[nodiscard]] const std::vector<std::uint64_t>& object() const { return controller_; }
  [[nodiscard]] const fs::path& file() const { return file_; }

 private:
  template <class Function>
  [[nodiscard]] Function* symbol(const char* name) const {
    void* const found = dlsym(library_, name);
    EXPECT_NE(found, nullptr) << dlerror();
    Function* function = nullptr;
    std::memcpy(&function, &found, sizeof(function));
    return function;
  }

  fs::path file_;
  void* library_;
  test::ControllerConstruct* construct_;
  test::ControllerMain* main_;
  std::vector<std::uint64_t> controller_;
};

constexpr const char* kJob = R"(/JOB
//NAME MAIN
//POS
///NPOS 2,0,0,0,0,0
///TOOL 0
///POSTYPE PULSE
///PULSE
C00000=0,0,0,0,0,0
C00001=10000,-5000,5000,0,20000,0
//INST
NOP
SET I001 7
MOVJ C00001 VJ=50.00
MSG "there"
PULSE OT#(3) T=0.05
MOVJ C00000 VJ=50.00
CALL JOB:WAIT
END
)";
constexpr const char* kWait = "/JOB\n//NAME WAIT\n//POS\n///NPOS 0,0,0,0,0,0\n//INST\nNOP\nTIMER T=0.10\nEND\n";
constexpr const char* kGcode =
    "G21 G64 P0.5 F3000\nG91 G1 X-20\nG3 X-10 Y10 I-10\nM62 P0\nG1 Z5\n(MSG, there)\nG4 P0.05\nM2\n";

// What a controller executes.
struct Run {
  const char* name;
  ControllerConfig config;
  BootProgram program;
};
std::ostream& operator<<(std::ostream& out, const Run& run) {
  return out << run.name;
}
const std::array kRuns{
    Run{"job",
        {.flange_T_tool = {.position_mm = {0, 0, 100}}, .program_start = Ticks{2'000}},
        {ProgramLanguage::kJob, {{.name = "main.jbi", .text = kJob}, {.name = "wait.jbi", .text = kWait}}}},
    Run{"gcode",
        {.flange_T_tool = {.position_mm = {0, 0, 100}}, .program_start = Ticks{15'000}},
        {ProgramLanguage::kGcode, {{.name = "part.ngc", .text = kGcode}}}},
    Run{"moves", {.feedback = false, .program_start = std::nullopt}, {}},
};

// Moves of the host, and whatever the program does.
void execute(ControllerRig& rig) {
  rig.move_at(100, {0, 20, 10, 0, 60, 0});
  rig.submit_at(12'000, SetOutput{.pin = 2, .level = true});
  rig.submit_at(40'000, Stop{.kind = Stop::Kind::kSoft});
  rig.run(45'000);
}
void expect_equal(ControllerRig& a, ControllerRig& b) {
  ASSERT_EQ(a.rows.size(), b.rows.size());
  ASSERT_GT(a.rows.size(), 40'000u);
  EXPECT_GE(a.moves.size(), 1u);
  EXPECT_EQ(a.moves.size(), b.moves.size());
  for (std::size_t i = 0; i < a.rows.size(); ++i) {
    std::array<host_memory::Block<Telemetry>, 2> bytes{};
    host_memory::put(bytes[0].data(), 0, a.rows[i]);
    host_memory::put(bytes[1].data(), 0, b.rows[i]);
    ASSERT_EQ(bytes[0], bytes[1]) << "tick " << i;
  }
  // All events since the start are still in the rings.
  ASSERT_LT(a.memory().core0_events.written, host_memory::Core0Events::kCapacity);
  ASSERT_LT(a.memory().core1_events.written, host_memory::Core1Events::kCapacity);
  EXPECT_EQ(std::memcmp(&a.memory(), &b.memory(), a.memory().bytes), 0);
}

struct ControllerLibrary : testing::TestWithParam<Run> {};

TEST_P(ControllerLibrary, TwoCopiesAtOnceReportWhatTheLinkedControllerReports) {
  const auto& [name, config, program] = GetParam();
  const RobotModel robot = test::irb120();
  ControllerRig linked{robot, config, program};
  execute(linked);
  EXPECT_EQ(linked.memory().boot.problem, 0u);
  EXPECT_EQ(linked.notes.empty(), program.files.empty());

  Copy first{"first_" + std::string{name}}, second{"second_" + std::string{name}};
  ControllerRig a{robot, config, program, [&](HostMemory& memory) { return first.start(memory); }};
  ControllerRig b{robot, config, program, [&](HostMemory& memory) { return second.start(memory); }};
  std::thread other{[&b] { execute(b); }};
  execute(a);
  other.join();
  expect_equal(linked, a);
  expect_equal(linked, b);
}

INSTANTIATE_TEST_SUITE_P(Programs, ControllerLibrary, testing::ValuesIn(kRuns),
                         [](const auto& run) { return std::string{run.param.name}; });

// ---- addresses

struct Range {
  std::uint64_t begin = 0, end = 0;
  [[nodiscard]] bool has(std::uint64_t address) const { return address >= begin && address < end; }
};
template <class T>
Range range_of(const T& first, std::size_t bytes) {
  const void* const address = &first;
  Range range;
  std::memcpy(&range.begin, &address, sizeof(address));
  range.end = range.begin + bytes;
  return range;
}
// What is mapped into this process, with its file.
std::vector<std::pair<Range, std::string>> mappings() {
  std::vector<std::pair<Range, std::string>> all;
  std::ifstream maps{"/proc/self/maps"};
  for (std::string line; std::getline(maps, line);) {
    std::size_t dash = 0;
    Range range{.begin = std::stoull(line, &dash, 16)};
    range.end = std::stoull(line.substr(dash + 1), nullptr, 16);
    const std::size_t file = line.find('/');
    all.emplace_back(range, file == std::string::npos ? "" : line.substr(file));
  }
  return all;
}

TEST(ControllerAddresses, TheControllerHasOnlyItsOwnAndThoseOfTheMemory) {
  Copy copy{"addresses"};
  const ControllerConfig config{.pendant = pendant::PendantConfig{}, .conveyor = ConveyorConfig{.to_mm = 1.0}};
  host_memory::BootMemory boot{test::irb120(), config, kRuns[1].program};
  copy.start(boot.memory());
  ASSERT_EQ(boot.memory().boot.problem, 0u);

  const Range shared = range_of(boot.memory(), boot.memory().bytes);
  const Range own = range_of(copy.object().front(), copy.object().size() * sizeof(std::uint64_t));
  const auto all = mappings();
  int of_memory = 0, of_library = 0;
  for (std::size_t i = 0; i < copy.object().size(); ++i) {
    const std::uint64_t word = copy.object()[i];
    of_memory += shared.has(word) ? 1 : 0;
    if (shared.has(word) || own.has(word)) continue;
    for (const auto& [range, file] : all) {
      if (!range.has(word)) continue;
      EXPECT_EQ(file, copy.file().string()) << "byte " << i * sizeof(word);
      ++of_library;
    }
  }
  EXPECT_GT(of_memory, 0);
  EXPECT_GT(of_library, 0);
}

TEST(ControllerAddresses, TheMemoryHasNone) {
  Copy copy{"memory"};
  ControllerRig rig{test::irb120(), kRuns[0].config, kRuns[0].program,
                    [&](HostMemory& memory) { return copy.start(memory); }};
  execute(rig);
  const auto all = mappings();
  const std::size_t words = sizeof(HostMemory) / sizeof(std::uint64_t);
  std::vector<std::uint64_t> memory(words);
  std::memcpy(memory.data(), &rig.memory(), words * sizeof(std::uint64_t));
  for (std::size_t i = 0; i < words; ++i) {
    for (const auto& [range, file] : all)
      EXPECT_FALSE(range.has(memory[i])) << i * sizeof(std::uint64_t) << ' ' << file;
  }
}

}  // namespace
}  // namespace armature
