#pragma once

#include "golden/canaries/canary_roll.h"

namespace tumble::golden {

/// Questions whose answers are known, beside cases that no scene of a suite asks: which characters are shown, which
/// files no output may replace, which body lies under a pixel, what a scene with a slip is told, and whether every path
/// of the arithmetic gives the same bits on this machine. A canary that is not caught gave another answer.
void run_known_answers(CanaryRoll& roll);

/// Scenes with a slip each, and the whole message that refuses them.
void run_known_refusals(CanaryRoll& roll);

/// Scenes and what is read from them: every key, given and left out, every generator, --set.
void run_known_scenes(CanaryRoll& roll);

/// The least and the greatest value of every key of a scene, and values beyond, which are refused.
void run_known_limits(CanaryRoll& roll);

/// How outputs are written, replaced and guarded.
void run_known_files(CanaryRoll& roll);

/// How programs and jobs end, and what a command takes over of its process and gives back; programs where the machine
/// has a shell at its usual place.
void run_known_processes(CanaryRoll& roll);

/// Stages, effects and markers of a small picture; none where the machine has no OpenGL.
void run_known_drawings(CanaryRoll& roll);

/// Textures, movements of the camera, meshes and views of pictures that no case draws.
void run_known_pictures(CanaryRoll& roll);

/// Worlds, inputs and cameras with a slip each that no file of a scene can have, and what they are told.
void run_known_worlds(CanaryRoll& roll);

/// Snapshots with a slip each that no session wrote, and what they are told.
void run_known_snapshots(CanaryRoll& roll);

/// Small sessions computed in two ways that must agree to the bit: with lanes of every width of this machine, by
/// threads, step by step from snapshots, and through a log. And two sessions that are not within bounds of one another.
void run_known_sessions(CanaryRoll& roll);

}  // namespace tumble::golden
