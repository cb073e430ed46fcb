#include "cosim/exports/mcap_export.hpp"

#include <string>
#include <utility>

#include "cosim/exports/event_messages.hpp"
#include "cosim/exports/mcap_channels.hpp"
#include "cosim/exports/mcap_writer.hpp"
#include "cosim/exports/row_messages.hpp"

namespace armature::cosim {

void export_mcap(std::ostream& out, const RunRecord& run, const std::vector<RecordedProgram>& programs,
                 const std::optional<TraceTable>& load) {
  McapWriter writer{out, run_channels()};
  const std::vector<TimedMessage> events = event_messages(run, programs);
  auto event = events.begin();
  const RowMessages rows{run, load};
  for (std::size_t row = 0; row < run.trace.rows(); ++row) {
    for (; event != events.end() && event->time_ns < rows.time_ns(row); ++event) {
      writer.write(event->channel, event->time_ns, event->json);
    }
    rows.write(row, writer);
  }
  for (; event != events.end(); ++event) writer.write(event->channel, event->time_ns, event->json);
  writer.finish();
}

}  // namespace armature::cosim
