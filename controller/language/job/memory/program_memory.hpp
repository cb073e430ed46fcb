// The program memory: encoded jobs in arrays of a fixed size.
//
// All jobs share the pools. An instruction is a Record of 16 bytes with operands of 16 bytes each. Texts (comments,
// labels, header lines) are kept as they are.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "controller/language/job/memory/instruction.hpp"
#include "controller/language/job/memory/operand.hpp"
#include "controller/language/job/memory/words.hpp"

namespace armature::job {

inline constexpr std::size_t kMaxJobs = 32;
inline constexpr std::size_t kMaxRecords = 8'192;
inline constexpr std::size_t kMaxOperands = 16'384;
inline constexpr std::size_t kMaxPositions = 3'072;
inline constexpr std::size_t kMaxHeaderLines = 4'096;
inline constexpr std::size_t kMaxTextBytes = 65'535;
inline constexpr std::size_t kMaxLine = 65'535;       // number of the last line of a file
inline constexpr std::size_t kMaxLineLength = 1'024;  // characters

inline constexpr std::uint16_t kNowhere = 0xFFFF;

struct Record {
  static constexpr std::uint8_t kUnsupported = 1;  // a form of the instruction that cannot be executed
  static constexpr std::uint8_t kArcFirst = 2;     // of a run of MOVC or MOVS: its first point
  static constexpr std::uint8_t kArcEnds = 4;      // the last point of a run, or of an arc of it

  Op op = Op::kBlank;
  std::uint8_t flags = 0;
  std::uint8_t operand_count = 0;
  std::uint8_t blanks_after = 0;
  std::uint16_t first_operand = 0;
  // A record of the same job: where a jump, or a condition that is false, continues; of a run of MOVC or MOVS its next
  // point. kNowhere: none.
  std::uint16_t target = kNowhere;
  // The other end of a block: ENDIF of ELSE and ELSEIF, WHILE of ENDWHILE, FOR of NEXT, ENDSWITCH of CASE; the point
  // before in a run of MOVC or MOVS.
  std::uint16_t partner = kNowhere;
  std::uint16_t line = 0;
  std::uint16_t indent_start = 0;  // the blanks before the instruction, in the pool of texts
  std::uint8_t indent_size = 0;
};
static_assert(sizeof(Record) == 16);

enum class Frame : std::uint8_t { kPulse, kAngle, kRobot, kBase, kUser, kTool, kMasterTool };

struct Position {
  static constexpr std::uint8_t kHasRconf = 0x80;

  std::array<double, 6> value{};  // pulses; degrees; or mm and degrees
  std::array<NumberForm, 6> form{};
  std::array<std::uint8_t, 6> gap{};  // blanks before each value
  PositionLetter letter = PositionLetter::kC;
  std::uint8_t digits = 0;  // of the number, as written
  std::uint16_t number = 0;
  std::uint8_t count = 0;  // of values: 6, or fewer for BC and EC
  Frame frame = Frame::kPulse;
  std::uint8_t user = 0;
  std::uint8_t tool = 0;
  std::uint8_t rconf = 0;  // fields 1 to 6 of RCONF in bits 0 to 5, and kHasRconf
  std::uint8_t blanks_after = 0;
  std::uint16_t line = 0;
};
static_assert(sizeof(Position) == 72);

// A line above the instructions: a text, or a position.
struct HeaderLine {
  bool is_position = false;
  std::uint16_t position = 0;
  TextRef text{};
};

struct JobInfo {
  TextRef file{}, name{};
  std::uint16_t first_header = 0, header_count = 0;
  std::uint16_t first_record = 0, record_count = 0;
  std::uint16_t first_position = 0, position_count = 0;
  std::array<std::uint16_t, 8> locals{};  // of ///LVARS: B I D R S P BP EX
};

struct ProgramMemory {
  std::array<JobInfo, kMaxJobs> jobs{};
  std::array<Record, kMaxRecords> records{};
  std::array<Operand, kMaxOperands> operands{};
  std::array<Position, kMaxPositions> positions{};
  std::array<HeaderLine, kMaxHeaderLines> headers{};
  std::array<char, kMaxTextBytes> text{};
  // How much of each is in use.
  std::size_t job_count = 0, record_count = 0, operand_count = 0, position_count = 0, header_count = 0, text_size = 0;

  [[nodiscard]] std::string_view text_at(TextRef ref) const noexcept { return {text.data() + ref.start, ref.size}; }
  [[nodiscard]] std::span<const Record> records_of(const JobInfo& job) const noexcept {
    return {records.data() + job.first_record, job.record_count};
  }
  [[nodiscard]] std::span<const Position> positions_of(const JobInfo& job) const noexcept {
    return {positions.data() + job.first_position, job.position_count};
  }
  [[nodiscard]] std::span<const Operand> operands_of(const Record& record) const noexcept {
    return {operands.data() + record.first_operand, record.operand_count};
  }
  // The number of the job with this name; job_count if there is none.
  [[nodiscard]] std::size_t job_named(std::string_view name) const noexcept {
    for (std::size_t i = 0; i < job_count; ++i) {
      if (text_at(jobs[i].name) == name) return i;
    }
    return job_count;
  }
  void clear() noexcept { job_count = record_count = operand_count = position_count = header_count = text_size = 0; }
};
static_assert(sizeof(ProgramMemory) < 720'000, "the README states the size");  // NOLINT: a size is meant

}  // namespace armature::job
