// What the demos of all engines share: their arguments, and what they print at the end.
//   DEMO OUT.tumblestream [--friction F] [--steps N] [--verify EARLIER.tumblestream]
#pragma once
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "tumble_recorder.h"

struct Demo {
  double friction = 0.5;
  int steps = 240;
  TumbleRecDef def = {};

  Demo(int count, char** words) {
    for (int k = 1; k < count; ++k) {
      const bool has_value = k + 1 < count;
      if (std::strcmp(words[k], "--friction") == 0 && has_value) friction = std::atof(words[++k]);
      else if (std::strcmp(words[k], "--steps") == 0 && has_value) steps = std::atoi(words[++k]);
      else if (std::strcmp(words[k], "--verify") == 0 && has_value) def.verify = words[++k];
      else def.path = words[k];
    }
    def.scene = "demo";
    def.ground = 1;
    def.on_difference = [](void*, const TumbleRecDifference* d) { std::printf("%s\n", d->text); };  // break here
  }

  // 0 recorded, 1 different from the stream of --verify, 2 an error.
  static int end(TumbleRec* rec) {
    const TumbleRecStatus status = tumble_rec_finish(rec);
    if (tumble_rec_message(rec)[0] != 0) std::fprintf(stderr, "%s\n", tumble_rec_message(rec));
    if (tumble_rec_steps_verified(rec) > 0) {
      std::printf("%llu steps verified\n", static_cast<unsigned long long>(tumble_rec_steps_verified(rec)));
    }
    return status == TUMBLE_REC_OK ? 0 : status == TUMBLE_REC_DIFFERENT ? 1 : 2;
  }
};

// Ten cubes that fall aslant onto the ground and onto each other.
inline void demo_cube(int k, double position[3], double* tilt) {
  position[0] = 0.3 * (k % 3), position[1] = 0.2 * (k % 2), position[2] = 0.8 + 1.1 * k;
  *tilt = 0.1 * k;
}
