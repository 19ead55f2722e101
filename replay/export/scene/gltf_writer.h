#pragma once

#include <memory>

#include "replay/export/plan/export_writer.h"
#include "src/files/output_file.h"

namespace tumble::replay {

/// A glTF 2.0 file in one piece (.glb): every body a node with its shape, its material as `tumble render` draws it, and
/// an animation of all states; camera, light and ground. Numbers are floats; a node `world` turns our z up into
/// glTF's y up. Times count from the first exported state. A body is scaled to nothing while it is absent.
/// Format: https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html
///
/// Refuses what is not finite, with body and step; a file of more than 4 GiB; times that floats do not tell apart.
/// `file` is no device and outlives the writer.
std::unique_ptr<ExportWriter> make_gltf_writer(files::OutputFile& file);

}  // namespace tumble::replay
