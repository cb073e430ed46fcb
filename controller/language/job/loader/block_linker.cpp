#include "controller/language/job/loader/block_linker.hpp"

#include <string_view>

#include "controller/language/job/loader/printer.hpp"

namespace armature::job {
namespace {

enum class BlockKind : std::uint8_t { kNone, kIf, kWhile, kFor, kSwitch };

BlockKind opens(Op op) {
  switch (op) {
    case Op::kIfthenexp:
    case Op::kIfthen:
      return BlockKind::kIf;
    case Op::kWhileexp:
    case Op::kWhile:
      return BlockKind::kWhile;
    case Op::kFor:
      return BlockKind::kFor;
    case Op::kSwitch:
      return BlockKind::kSwitch;
    default:
      return BlockKind::kNone;
  }
}

BlockKind closes(Op op) {
  switch (op) {
    case Op::kEndif:
      return BlockKind::kIf;
    case Op::kEndwhile:
      return BlockKind::kWhile;
    case Op::kNext:
      return BlockKind::kFor;
    case Op::kEndswitch:
      return BlockKind::kSwitch;
    default:
      return BlockKind::kNone;
  }
}

BlockKind branches(Op op) {
  switch (op) {
    case Op::kElseifexp:
    case Op::kElseif:
    case Op::kElse:
      return BlockKind::kIf;
    case Op::kCase:
    case Op::kDefault:
      return BlockKind::kSwitch;
    default:
      return BlockKind::kNone;
  }
}

std::string_view name_of_block(BlockKind kind) {
  constexpr std::array<std::string_view, 5> kNames{"a block", "IFTHENEXP", "WHILEEXP", "FOR", "SWITCH"};
  return kNames[static_cast<std::size_t>(kind)];
}

bool no_instruction(Op op) {
  return op == Op::kBlank || op == Op::kComment || op == Op::kComm;
}

// What may stand between two points of a run without ending it.
bool keeps_run(Op op) {
  return no_instruction(op) || op == Op::kDout || op == Op::kNop || op == Op::kMsg || !is_supported(op);
}

}  // namespace

void BlockLinker::error(std::uint16_t at, const DiagnosticText& text) noexcept {
  file_.line = record(at).line;
  file_.error(record(at).indent_size + std::size_t{1}, text);
}

void BlockLinker::error_at(std::uint16_t at, std::size_t operand, const DiagnosticText& text) noexcept {
  file_.line = record(at).line;
  file_.error(column_of(memory_, record(at), operand), text);
}

void BlockLinker::link() noexcept {
  check_ends();
  link_labels();
  link_positions();
  link_blocks();
  link_runs();
}

void BlockLinker::check_ends() noexcept {
  bool started = false, ended = false;
  for (std::uint16_t at = 0; at < job_.record_count; ++at) {
    const Op op = record(at).op;
    if (no_instruction(op)) continue;
    if (!started && op != Op::kNop) error(at, "the first instruction must be NOP");
    if (ended) return error(at, "an instruction behind END");
    started = true;
    ended = op == Op::kEnd;
  }
  if (!ended) file_.error(1, "the last instruction must be END");
}

void BlockLinker::link_labels() noexcept {
  for (std::uint16_t at = 0; at < job_.record_count; ++at) {
    const std::span<const Operand> operands = memory_.operands_of(record(at));
    for (std::size_t i = 0; i < operands.size(); ++i) {
      if (operands[i].kind == OperandKind::kLabel) link_label(at, i);
    }
  }
}

// A label itself continues at the first label of this name, which is itself unless it is a second one.
void BlockLinker::link_label(std::uint16_t at, std::size_t operand) noexcept {
  const std::string_view name = memory_.text_at(text_of(memory_.operands_of(record(at))[operand]));
  for (std::uint16_t to = 0; to < job_.record_count; ++to) {
    if (record(to).op != Op::kLabel || memory_.text_at(text_of(memory_.operands_of(record(to))[0])) != name) continue;
    record(at).target = to;
    if (record(at).op == Op::kLabel && to != at) {
      error_at(
          at, operand,
          DiagnosticText{"the label *"} << name << " stands in line " << std::uint32_t{record(to).line} << " already");
    }
    return;
  }
  error_at(at, operand, DiagnosticText{"no label *"} << name << " in this job");
}

void BlockLinker::link_positions() noexcept {
  const std::span<const Position> positions = memory_.positions_of(job_);
  for (std::uint16_t at = 0; at < job_.record_count; ++at) {
    for (std::size_t i = 0; i < record(at).operand_count; ++i) {
      Operand& operand = memory_.operands[record(at).first_operand + i];
      if (operand.kind != OperandKind::kPosition) continue;
      bool found = false;
      for (std::size_t p = 0; p < positions.size() && !found; ++p) {
        found = positions[p].number == operand.a && static_cast<std::uint8_t>(positions[p].letter) == operand.what;
        if (found) operand.number = static_cast<double>(job_.first_position + p);
      }
      if (!found)
        error_at(at, i, DiagnosticText{"the job has no position "} << kPositionNames[operand.what] << operand.a);
    }
  }
}

void BlockLinker::link_blocks() noexcept {
  for (std::uint16_t at = 0; at < job_.record_count; ++at) {
    if (opens(record(at).op) != BlockKind::kNone) open(at);
    if (branches(record(at).op) != BlockKind::kNone) branch(at);
    if (closes(record(at).op) != BlockKind::kNone) close(at);
  }
  while (depth_ > 0) {
    const std::uint16_t at = blocks_[--depth_].start;
    error(at, DiagnosticText{instruction_of(record(at).op).name} << " has no end");
  }
}

void BlockLinker::open(std::uint16_t at) noexcept {
  if (depth_ == kDeepestBlock) return error(at, "more than 32 blocks within each other");
  blocks_[depth_++] = {.start = at, .last = at};
}

void BlockLinker::branch(std::uint16_t at) noexcept {
  const BlockKind kind = branches(record(at).op);
  if (depth_ == 0 || opens(record(blocks_[depth_ - 1].start).op) != kind) {
    return error(at, DiagnosticText{instruction_of(record(at).op).name} << " is not inside of " << name_of_block(kind));
  }
  Block& block = blocks_[depth_ - 1];
  if (block.has_default) {
    return error(at, DiagnosticText{instruction_of(record(at).op).name} << " behind ELSE or DEFAULT");
  }
  block.has_default = record(at).op == Op::kElse || record(at).op == Op::kDefault;
  record(block.last).target = at;
  block.last = at;
}

void BlockLinker::close(std::uint16_t at) noexcept {
  const BlockKind kind = closes(record(at).op);
  if (depth_ == 0 || opens(record(blocks_[depth_ - 1].start).op) != kind) {
    return error(at, DiagnosticText{instruction_of(record(at).op).name} << " does not end " << name_of_block(kind));
  }
  const Block block = blocks_[--depth_];
  record(block.last).target = at;
  if (kind == BlockKind::kFor || kind == BlockKind::kWhile) record(at).partner = block.start;
  if (kind == BlockKind::kFor) {
    const Operand loop = memory_.operands_of(record(block.start))[0];
    const Operand next = memory_.operands_of(record(at))[0];
    if (loop.what != next.what || loop.flags != next.flags || loop.a != next.a) {
      error(at,
            DiagnosticText{"NEXT has another variable than FOR in line "} << std::uint32_t{record(block.start).line});
    }
  }
  if (kind == BlockKind::kIf || kind == BlockKind::kSwitch) close_if_or_switch(block, at);
}

void BlockLinker::close_if_or_switch(const Block& block, std::uint16_t end) noexcept {
  for (std::uint16_t at = block.start; at != end && at != kNowhere; at = record(at).target) record(at).partner = end;
}

void BlockLinker::link_runs() noexcept {
  std::uint16_t first = kNowhere, last = kNowhere;
  const auto finish = [&] {
    if (first != kNowhere) end_run(first, last);
    first = last = kNowhere;
  };
  for (std::uint16_t at = 0; at < job_.record_count; ++at) {
    const Op op = record(at).op;
    const bool point = is_arc(op) || op == Op::kMovs;
    if (!point) {
      if (!keeps_run(op)) finish();
      continue;
    }
    if (first != kNowhere && is_arc(op) != is_arc(record(first).op)) finish();
    if (first == kNowhere) {
      first = at;
      record(at).flags |= Record::kArcFirst;
    } else {
      record(last).target = at;
      record(at).partner = last;
    }
    last = at;
  }
  finish();
}

// Marks the ends of the arcs of a run, and counts the points of each.
void BlockLinker::end_run(std::uint16_t first, std::uint16_t last) noexcept {
  record(last).flags |= Record::kArcEnds;
  std::size_t points = 0;
  std::uint16_t start = first;
  for (std::uint16_t at = first; at != kNowhere; at = record(at).target) {
    ++points;
    bool ends = at == last;
    for (const Operand& operand : memory_.operands_of(record(at))) {
      ends = ends || (operand.kind == OperandKind::kWord && operand.what == static_cast<std::uint8_t>(Word::kFpt));
    }
    if (!ends || at == first) continue;
    record(at).flags |= Record::kArcEnds;
    if (points < 3) too_few_points(start);
    start = at;
    points = 1;  // the next arc starts here
  }
  if (first == last) too_few_points(first);
}

void BlockLinker::too_few_points(std::uint16_t at) noexcept {
  const bool arc = is_arc(record(at).op);
  error(at, DiagnosticText{arc ? std::string_view{"an arc needs three successive MOVC"}
                               : std::string_view{"a curve needs three successive MOVS"}});
}

}  // namespace armature::job
