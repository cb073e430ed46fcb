#include "controller/language/job/loader/loader.hpp"

#include <algorithm>

#include "controller/language/job/loader/block_linker.hpp"
#include "controller/language/job/loader/operand_grammar.hpp"
#include "controller/language/job/loader/printer.hpp"

namespace armature::job {
namespace {

// The length of the first line, and of its end.
struct LineEnd {
  std::size_t size = 0, end = 0;
};

LineEnd first_line(std::string_view text) {
  const std::size_t size = place_where(text, [](char character) { return character == '\r' || character == '\n'; });
  if (size == text.size()) return {size, 0};
  const bool both = text[size] == '\r' && size + 1 < text.size() && text[size + 1] == '\n';
  return {size, both ? std::size_t{2} : std::size_t{1}};
}

// How much of each pool is in use.
struct Marks {
  std::size_t records, operands, positions, headers, text;
};

Marks marks_of(const ProgramMemory& memory) {
  return {memory.record_count, memory.operand_count, memory.position_count, memory.header_count, memory.text_size};
}

void go_back(ProgramMemory& memory, const Marks& marks) {
  memory.record_count = marks.records;
  memory.operand_count = marks.operands;
  memory.position_count = marks.positions;
  memory.header_count = marks.headers;
  memory.text_size = marks.text;
}

// Whether an earlier position with the same name has other values.
bool replaces_another(const ProgramMemory& memory, std::size_t position) noexcept {
  const Position& later = memory.positions[position];
  for (std::size_t i = 0; i < position; ++i) {
    const Position& earlier = memory.positions[i];
    if (earlier.letter == later.letter && earlier.number == later.number && earlier.value != later.value) return true;
  }
  return false;
}

const JobInfo* job_with_position(const ProgramMemory& memory, std::size_t position) noexcept {
  for (std::size_t i = 0; i < memory.job_count; ++i) {
    const JobInfo& job = memory.jobs[i];
    if (position >= job.first_position && position < std::size_t{job.first_position} + job.position_count) return &job;
  }
  return nullptr;
}

}  // namespace

void Loader::error(std::size_t column, const DiagnosticText& text) noexcept {
  file_.error(column, text);
}

bool Loader::load(std::string_view file, std::string_view text) noexcept {
  file_.name = file;
  file_.line = 0;
  file_.errors = 0;
  full_ = false;
  if (memory_.job_count == memory_.jobs.size()) {
    error(1, DiagnosticText{"the program memory has room for "} << kMaxJobs << " jobs");
    return false;
  }
  const Marks marks = marks_of(memory_);
  job_ = {.first_header = static_cast<std::uint16_t>(memory_.header_count),
          .first_record = static_cast<std::uint16_t>(memory_.record_count),
          .first_position = static_cast<std::uint16_t>(memory_.position_count)};
  header_.begin(job_);
  const auto name = add_text(memory_, file);
  if (name) job_.file = *name;
  while (!text.empty() && !full_) {
    const LineEnd end = first_line(text);
    const std::string_view line = part(text, 0, end.size);
    text.remove_prefix(end.size + end.end);
    ++file_.line;
    if (file_.line > kMaxLine) {
      error(1, "a job has at most 65535 lines");
      break;
    }
    if (line.size() > kMaxLineLength) {
      error(kMaxLineLength + 1, "a line has at most 1024 characters");
      continue;
    }
    read_line(line);
  }
  finish_job();
  if (file_.errors > 0) {
    go_back(memory_, marks);
    return false;
  }
  memory_.jobs[memory_.job_count++] = job_;
  return true;
}

void Loader::read_line(std::string_view line) noexcept {
  const bool strange =
      std::any_of(line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
  const bool in_instructions = memory_.record_count > job_.first_record;
  if (in_instructions && part(line, 0, 1) == "/") {
    error(1, "a line of the header behind the first instruction");
  } else if (in_instructions || !header_.read(line)) {
    read_instruction(line);
  } else if (strange) {
    file_.warn(1, "the line has characters that are not ASCII");
  }
}

void Loader::read_instruction(std::string_view line) noexcept {
  const std::size_t indent = place_where(line, [](char character) { return !is_blank(character); });
  lexed_.count = 0;
  lexed_.blanks_after = 0;
  lexed_.unsupported = false;
  const std::string_view text = part(line, indent);
  Op op = Op::kBlank;
  std::size_t size = 0;
  if (text.empty()) {
    return add_record(op, line, indent, lexed_);
  }
  if (text.front() == '\'') {
    op = Op::kComment;
    size = 1;
  } else if (text.front() == '*') {
    op = Op::kLabel;
  } else {
    size = place_where(text, is_blank);
    const auto named_op = op_named(part(text, 0, size));
    if (!named_op && text.front() == '+')
      return error(indent + 1, "'+' moves a station, and stations are not supported");
    if (!named_op) {
      return error(indent + 1,
                   DiagnosticText{"unknown instruction '"} << part(text, 0, std::min<std::size_t>(size, 32)) << "'");
    }
    op = *named_op;
  }
  const Instruction& instruction = instruction_of(op);
  LineLexer lexer{memory_, line, op};
  const bool lexed =
      instruction.pattern == "w" ? lexer.lex_text(indent + size, lexed_) : lexer.lex(indent + size, lexed_);
  if (!lexed) return error(lexer.problem().column, lexer.problem().text);
  OperandGrammar grammar{lexed_, line.size() + 1};
  if (op == Op::kLabel ? lexed_.count != 1 || lexed_.operands[0].kind != OperandKind::kLabel
                       : instruction.pattern != "w" && !grammar.matches(instruction)) {
    if (op == Op::kLabel) return error(indent + 1, "expected *NAME alone");
    return error(grammar.problem().column, grammar.problem().text);
  }
  add_record(op, line, indent, lexed_);
}

void Loader::add_record(Op op, std::string_view line, std::size_t indent, const LexedLine& lexed) noexcept {
  if (memory_.record_count == memory_.records.size()) {
    full_ = true;
    return error(1, DiagnosticText{"the program memory has room for "} << kMaxRecords << " instructions");
  }
  if (lexed.count > memory_.operands.size() - memory_.operand_count) {
    full_ = true;
    return error(1, DiagnosticText{"the program memory has room for "} << kMaxOperands << " operands");
  }
  if (indent > 255) return error(256, "more than 255 blanks before an instruction");
  Record record{.op = op,
                .flags = lexed.unsupported ? Record::kUnsupported : std::uint8_t{0},
                .operand_count = static_cast<std::uint8_t>(lexed.count),
                .blanks_after = lexed.blanks_after,
                .first_operand = static_cast<std::uint16_t>(memory_.operand_count),
                .line = static_cast<std::uint16_t>(file_.line),
                .indent_size = static_cast<std::uint8_t>(indent)};
  if (indent > 0) {
    // Successive lines share their blanks.
    const bool same = memory_.record_count > job_.first_record &&
                      memory_.text_at({memory_.records[memory_.record_count - 1].indent_start,
                                       memory_.records[memory_.record_count - 1].indent_size}) == part(line, 0, indent);
    if (same) {
      record.indent_start = memory_.records[memory_.record_count - 1].indent_start;
    } else {
      const auto blanks = add_text(memory_, part(line, 0, indent));
      if (!blanks) return error(1, "the program memory has no room for more text");
      record.indent_start = blanks->start;
    }
  }
  std::copy_n(lexed.operands.begin(), lexed.count,
              memory_.operands.begin() + static_cast<std::ptrdiff_t>(memory_.operand_count));
  memory_.operand_count += lexed.count;
  memory_.records[memory_.record_count++] = record;
}

void Loader::finish_job() noexcept {
  job_.header_count = static_cast<std::uint16_t>(memory_.header_count - job_.first_header);
  job_.record_count = static_cast<std::uint16_t>(memory_.record_count - job_.first_record);
  job_.position_count = static_cast<std::uint16_t>(memory_.position_count - job_.first_position);
  const std::uint32_t last = file_.line;
  header_.finish();
  file_.line = last;
  if (!full_ && header_.in_instructions()) BlockLinker{memory_, job_, file_}.link();
}

bool Loader::link() noexcept {
  std::size_t errors = 0;
  for (std::size_t i = 0; i < memory_.job_count; ++i) {
    const JobInfo& job = memory_.jobs[i];
    file_.name = memory_.text_at(job.file);
    file_.errors = 0;
    for (std::size_t r = 0; r < job.record_count; ++r) {
      const Record& record = memory_.records[job.first_record + r];
      for (std::size_t o = 0; o < record.operand_count; ++o) {
        Operand& operand = memory_.operands[record.first_operand + o];
        if (operand.kind != OperandKind::kJob) continue;
        const std::string_view name = memory_.text_at(text_of(operand));
        const std::size_t called = memory_.job_named(name);
        operand.number = static_cast<double>(called);
        if (called < memory_.job_count) continue;
        file_.line = record.line;
        error(column_of(memory_, record, o), DiagnosticText{"no job named "} << name << " is loaded");
      }
    }
    errors += file_.errors;
  }
  compare_position_variables();
  return errors == 0;
}

void Loader::compare_position_variables() noexcept {
  for (std::size_t i = 0; i < memory_.position_count; ++i) {
    const Position& position = memory_.positions[i];
    if (position.letter != PositionLetter::kP || !replaces_another(memory_, i)) continue;
    if (const JobInfo* job = job_with_position(memory_, i)) file_.name = memory_.text_at(job->file);
    file_.line = position.line;
    file_.warn(1,
               DiagnosticText{"another job gives P"} << std::uint32_t{position.number} << " other values; these apply");
  }
}

}  // namespace armature::job
