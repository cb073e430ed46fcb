#include "controller/language/job/loader/printer.hpp"

#include <span>
#include <string_view>

#include "controller/language/job/memory/number_text.hpp"
#include "controller/language/text/fixed_text.hpp"

namespace armature::job {
namespace {

void write_blanks(TextSink& out, std::size_t count) {
  for (; count > 0; --count) out.write(" ");
}

void write_digits(TextSink& out, std::uint32_t number, int digits) {
  out.write(FixedText<8>{}.append_digits(number, digits).view());
}

void write_number(const Operand& operand, TextSink& out) {
  const auto exponent = static_cast<std::int16_t>(operand.a == 0 ? 0 : operand.a - 1'000);
  out.write(number_digits(operand.number, operand.form, exponent, operand.b).view());
}

// Writes one operand with those that belong to it. Returns the place behind them.
class OperandWriter {
 public:
  OperandWriter(const ProgramMemory& memory, std::span<const Operand> operands, TextSink& out)
      : memory_{memory}, operands_{operands}, out_{out} {}

  std::size_t write(std::size_t at) {
    const Operand& operand = operands_[at];
    write_blanks(out_, operand.gap);
    switch (operand.kind) {
      case OperandKind::kNumber:
        write_number(operand, out_);
        return at + 1;
      case OperandKind::kVariable:
        return write_variable(at);
      case OperandKind::kPosition:
        out_.write(name_of<PositionLetter>(kPositionNames, operand.what));
        write_digits(out_, operand.a, operand.b);
        return at + 1;
      case OperandKind::kIo:
        out_.write(name_of<IoType>(kIoNames, operand.what));
        out_.write("#(");
        return write_index(at + 1, ")");
      case OperandKind::kWord:
        out_.write(name_of<Word>(kWordNames, operand.what));
        return at + 1;
      case OperandKind::kTag:
        return write_tag(at);
      case OperandKind::kLabel:
        return write_text(at, "*", "");
      case OperandKind::kJob:
        return write_text(at, "JOB:", "");
      case OperandKind::kQuoted:
        return write_text(at, "\"", "\"");
      case OperandKind::kText:
        return write_text(at, "", "");
    }
    return at + 1;
  }

 private:
  std::size_t write_text(std::size_t at, std::string_view before, std::string_view after) {
    out_.write(before);
    out_.write(memory_.text_at(text_of(operands_[at])));
    out_.write(after);
    return at + 1;
  }

  std::size_t write_index(std::size_t at, std::string_view close) {
    const std::size_t next = at < operands_.size() ? write(at) : at;
    out_.write(close);
    return next;
  }

  std::size_t write_variable(std::size_t at) {
    const Operand& operand = operands_[at];
    if ((operand.flags & Operand::kSystem) != 0) out_.write("$");
    if ((operand.flags & Operand::kLocal) != 0) out_.write("L");
    out_.write(name_of<VariableType>(kVariableNames, operand.what));
    if ((operand.flags & Operand::kWithX) != 0) out_.write("X");
    if ((operand.flags & Operand::kIndexed) != 0) {
      out_.write("[");
      return write_index(at + 1, "]");
    }
    if (operand.b > 0) write_digits(out_, operand.a, operand.b);
    return at + 1;
  }

  std::size_t write_tag(std::size_t at) {
    const Operand& operand = operands_[at];
    out_.write(name_of<TagName>(kTagNames, operand.what));
    out_.write("=");
    if ((operand.flags & Operand::kBlankAfter) != 0) out_.write(" ");
    if ((operand.flags & Operand::kIndexed) != 0) return at + 1 < operands_.size() ? write(at + 1) : at + 1;
    write_number(operand, out_);
    return at + 1;
  }

  const ProgramMemory& memory_;
  std::span<const Operand> operands_;
  TextSink& out_;
};

// Writes the line up to an operand, with the blanks before it.
void write_up_to(const ProgramMemory& memory, const Record& record, std::size_t end, TextSink& out) {
  out.write({memory.text.data() + record.indent_start, record.indent_size});
  // A label is its operand, which writes the star.
  if (record.op != Op::kLabel) out.write(instruction_of(record.op).name);
  const std::span<const Operand> operands = memory.operands_of(record);
  OperandWriter writer{memory, operands, out};
  for (std::size_t at = 0; at < operands.size();) {
    if (at >= end) return write_blanks(out, operands[at].gap);
    at = writer.write(at);
  }
}

void write_position(const Position& position, TextSink& out) {
  out.write(kPositionNames[static_cast<std::size_t>(position.letter)]);
  write_digits(out, position.number, position.digits);
  out.write("=");
  for (std::size_t i = 0; i < position.count; ++i) {
    if (i > 0) out.write(",");
    write_blanks(out, position.gap[i]);
    out.write(number_digits(position.value[i], position.form[i]).view());
  }
  write_blanks(out, position.blanks_after);
}

constexpr std::string_view kLineEnd = "\r\n";

}  // namespace

void print_record(const ProgramMemory& memory, const Record& record, TextSink& out) noexcept {
  write_up_to(memory, record, record.operand_count, out);
  write_blanks(out, record.blanks_after);
}

std::size_t column_of(const ProgramMemory& memory, const Record& record, std::size_t operand) noexcept {
  TextLength length;
  write_up_to(memory, record, operand, length);
  return length.size() + 1;
}

void print_job(const ProgramMemory& memory, const JobInfo& job, TextSink& out) noexcept {
  for (std::size_t i = 0; i < job.header_count; ++i) {
    const HeaderLine& line = memory.headers[job.first_header + i];
    if (line.is_position) {
      write_position(memory.positions[line.position], out);
    } else {
      out.write(memory.text_at(line.text));
    }
    out.write(kLineEnd);
  }
  for (const Record& record : memory.records_of(job)) {
    print_record(memory, record, out);
    out.write(kLineEnd);
  }
}

void list_job(const ProgramMemory& memory, const JobInfo& job, TextSink& out) noexcept {
  out.write("record  line  operation   flags  target  partner  operands\n");
  std::uint32_t number = 0;
  for (const Record& record : memory.records_of(job)) {
    const auto column = [&out](std::string_view text, std::size_t width) {
      write_blanks(out, width > text.size() ? width - text.size() : 0);
      out.write(text);
    };
    const auto place = [&column](std::uint16_t at, std::size_t width) {
      column(at == kNowhere ? std::string_view{"-"} : (FixedText<8>{} << std::uint32_t{at}).view(), width);
    };
    column((FixedText<8>{} << number++).view(), 6);
    column((FixedText<8>{} << std::uint32_t{record.line}).view(), 6);
    const std::string_view name = instruction_of(record.op).name;
    out.write("  ");
    out.write(name);
    write_blanks(out, name.size() < 12 ? 12 - name.size() : 1);
    FixedText<8> flags;
    if ((record.flags & Record::kUnsupported) != 0) flags << 'u';
    if ((record.flags & Record::kArcFirst) != 0) flags << 'f';
    if ((record.flags & Record::kArcEnds) != 0) flags << 'e';
    out.write(flags.view());
    write_blanks(out, 5 - flags.view().size());
    place(record.target, 8);
    place(record.partner, 9);
    const std::span<const Operand> operands = memory.operands_of(record);
    OperandWriter writer{memory, operands, out};
    for (std::size_t at = 0; at < operands.size();) {
      out.write(" |");
      at = writer.write(at);
    }
    out.write("\n");
  }
}

}  // namespace armature::job
