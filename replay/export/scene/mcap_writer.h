#pragma once

#include <memory>

#include "replay/export/plan/export_writer.h"
#include "src/files/output_file.h"

namespace tumble::replay {

/// An MCAP file for Foxglove, Rerun and others; messages of schema/export/*.proto in Protobuf. Holds every double to
/// the bit, NaN and infinity too. SI units, z up; times in ns from the first state of the log on.
///
/// | topic | message | when |
/// |---|---|---|
/// | `/scene` | `foxglove.SceneUpdate`: all bodies, each fixed to its frame, and the ground | at the start, and where a
/// body comes or goes | | `/tf` | `foxglove.FrameTransforms`: world to the frame of each body | every state | |
/// `/poses` | `foxglove.PosesInFrame` | every state | | `/bodies` | `tumble.Bodies`: ids, velocities, spins, frozen, in
/// the order of the poses | every state | | `/channel/NAME` | `tumble.Values`, also of pairs | every state with values
/// |
///
/// `file` outlives the writer.
std::unique_ptr<ExportWriter> make_mcap_writer(files::OutputFile& file);

}  // namespace tumble::replay
