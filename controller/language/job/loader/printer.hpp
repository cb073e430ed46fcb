// Writes encoded jobs as text again.
#pragma once

#include <cstddef>

#include "controller/language/job/memory/program_memory.hpp"
#include "controller/language/text/text_sink.hpp"

namespace armature::job {

// The whole job, each line with the line end of controllers, CR LF. Apart from line ends it is equal to the text that
// was loaded.
void print_job(const ProgramMemory& memory, const JobInfo& job, TextSink& out) noexcept;

// One line without its end.
void print_record(const ProgramMemory& memory, const Record& record, TextSink& out) noexcept;

// The column, from 1, at which an operand of a record stands in its line.
[[nodiscard]] std::size_t column_of(const ProgramMemory& memory, const Record& record, std::size_t operand) noexcept;

// One line for each record: its number, line, operation, flags, where it continues, and its operands; with a heading.
void list_job(const ProgramMemory& memory, const JobInfo& job, TextSink& out) noexcept;

}  // namespace armature::job
