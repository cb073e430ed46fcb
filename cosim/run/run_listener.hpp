// What records, shows or judges a run: a class derived from RunListener that the caller adds to the run.
#pragma once

#include "controller/message/event.hpp"
#include "cosim/kernel/script/script.hpp"
#include "cosim/kernel/signal.hpp"
#include "cosim/report/judge/run_summary.hpp"
#include "cosim/report/measure/run_place.hpp"
#include "cosim/trace/integer_digest.hpp"
#include "cosim/trace/trace_row.hpp"

namespace armature::cosim {

// Is called in the order of simulated time. All listeners hear of one thing before any of them hears of the next. Each
// function may throw, which ends the run, and may call Run::interrupt().
class RunListener {
 public:
  virtual ~RunListener() = default;

  // A tick has ended. The row has its tool point if the scenario needs it. `digest` includes this row and all before
  // it.
  virtual void on_row(const TraceRow&, const IntegerDigest& /*digest*/) {}
  // Of the controller.
  virtual void on_event(const Event&, const RunPlace&) {}
  // The scenario is about to do it: a command, a fault or its end, an input, a set-point of a stream, a part.
  virtual void on_action(const ScriptAction&, const RunPlace&) {}
  // An output, the servo enables, a character on the serial line, a bus abort, a step of the pendant.
  virtual void on_signal(const Signal&, const RunPlace&) {}

  // Every 0.1 s of simulated time: files get what they have so far, so that it remains when this process is killed.
  virtual void write_through() {}

  // At the end of the run, when the summary has all measurements and the verdict of [expect]: adds a verdict.
  virtual void judge(RunSummary&) {}
  // After all verdicts. Nothing follows: a file is closed.
  virtual void on_end(const RunSummary&) {}
};

}  // namespace armature::cosim
