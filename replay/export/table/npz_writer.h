#pragma once

#include <memory>

#include "replay/export/plan/export_writer.h"
#include "src/files/output_file.h"

namespace tumble::replay {

/// An archive of arrays for numpy (.npz), each value to the bit, NaN and infinity included; `import` reads it back.
///
/// | array | shape | |
/// |---|---|---|
/// | `step`, `time`, `dt` | (steps) | dt: since the exported state before; only where steps differ in length |
/// | `id`, `name`, `size`, `mass`, `static`, `friction`, `friction_dynamic`, `restitution`, `texture`, `shape` |
/// (bodies, …) | | | `position`, `orientation` (w x y z), `velocity`, `spin`, `frozen` | (steps, bodies, …) | NaN where
/// absent | | `present` | (steps, bodies) | only where a body is absent in some step | | `channel.NAME`, `world.NAME` |
/// (steps, bodies), (steps) | of text: numbers of rows of `texts.channel.NAME` | | `present.channel.NAME`, … | likewise
/// | false: no value | | `pair.NAME`, `step.pair.NAME`, `a.pair.NAME`, `b.pair.NAME` | (rows) | a row a value | |
/// `unit.channel.NAME`, … | () | | | `engine`, `up`, … | () | the lines of a table's header |
///
/// Axes: TableFrame's. `file` is no device and outlives the writer.
std::unique_ptr<ExportWriter> make_npz_writer(files::OutputFile& file);

}  // namespace tumble::replay
