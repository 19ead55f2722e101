// An engine that writes through the recorder: boxes that fall, with a channel of each scope and inputs by name. It can
// also do wrong in many ways, which the tests of replay, check and bisect run as a user's broken engine.
//
//   stream_engine --log FILE [--inputs FILE] [--kick STEP:BODY:VALUE]… [--steps N] [--dt S] [--pause MS]
//                 [--angle STEP:VALUE] [--seed STEP:VALUE] [--grip STEP:VALUE] [--move STEP:VALUE] [--extra]
//                 [--nan STEP] [--stretched STEP] [--crash STEP] [--hang STEP] [--open] [--table]
//                 [--sphere BODY] [--late] [--poke STEP]
//
// --angle, --seed, --grip, --move: another value of a channel, or of a position, in that step. --extra: a channel more.
// --stretched: an orientation of length 2 in that step, which no log can hold. --crash, --hang: in that step. --open:
// ends well without closing the recorder. --table: rows instead of a stream. --sphere: that body is one. --late: a
// third body, which stands, appears before step 5. --poke: one more input by name in that step.
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "replay/recorder/tumble_recorder.h"

namespace tumble::toy {
namespace {

struct At {
  std::uint64_t step = ~std::uint64_t{0};
  double value = 0;
};

struct Kick {
  std::uint64_t step = 0;
  std::uint64_t body = 0;
  double value = 0;
};

struct Options {
  std::string log, inputs;
  std::uint64_t steps = 40, nan = 0, stretched = 0, crash = 0, hang = 0, pause_ms = 0, sphere = 0, poke = 0;
  double dt = 0.015625;
  At angle, seed, grip, move;
  std::vector<Kick> kicks;
  bool extra = false, open = false, table = false, late = false;
};

[[noreturn]] void stop(const std::string& message) {
  std::cerr << "stream_engine: " << message << '\n';
  std::exit(2);
}

At at_of(const std::string& text) {
  At at;
  char colon = 0;
  std::istringstream(text) >> at.step >> colon >> at.value;
  return at;
}

Options read_options(int argc, char** argv) {
  Options o;
  std::map<std::string, std::string*> texts = {{"--log", &o.log}, {"--inputs", &o.inputs}};
  std::map<std::string, std::uint64_t*> numbers = {
      {"--steps", &o.steps}, {"--nan", &o.nan},        {"--stretched", &o.stretched}, {"--crash", &o.crash},
      {"--hang", &o.hang},   {"--pause", &o.pause_ms}, {"--sphere", &o.sphere},       {"--poke", &o.poke}};
  std::map<std::string, At*> ats = {
      {"--angle", &o.angle}, {"--seed", &o.seed}, {"--grip", &o.grip}, {"--move", &o.move}};
  std::map<std::string, bool*> flags = {
      {"--extra", &o.extra}, {"--open", &o.open}, {"--table", &o.table}, {"--late", &o.late}};
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (flags.contains(word)) {
      *flags[word] = true;
      continue;
    }
    if (i + 1 >= argc) stop(word + " wants a value");
    const std::string value = argv[++i];
    if (texts.contains(word)) {
      *texts[word] = value;
    } else if (numbers.contains(word)) {
      *numbers[word] = std::stoull(value);
    } else if (ats.contains(word)) {
      *ats[word] = at_of(value);
    } else if (word == "--dt") {
      o.dt = std::stod(value);
    } else if (word == "--kick") {
      Kick kick;
      char colon = 0;
      std::istringstream(value) >> kick.step >> colon >> kick.body >> colon >> kick.value;
      o.kicks.push_back(kick);
    } else {
      stop("unknown argument " + word);
    }
  }
  if (o.log.empty()) stop("--log is missing");
  return o;
}

/// The eight bytes of a double, as {inputs} has them.
double double_in(const std::string& hex) {
  std::uint64_t bits = 0;
  for (int byte = 7; byte >= 0; --byte)
    bits = bits << 8U | std::stoul(hex.substr(2 * static_cast<std::size_t>(byte), 2), nullptr, 16);
  double value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

void read_inputs(Options& options) {
  std::ifstream file(options.inputs);
  for (std::string line; std::getline(file, line);) {
    const nlohmann::json json = nlohmann::json::parse(line);
    if (json.value("kind", "") != "input" || json.at("name") != "kick") continue;
    options.kicks.push_back({json.at("step"), json.value("id", std::uint64_t{0}), double_in(json.at("hex"))});
  }
}

class Engine {
 public:
  explicit Engine(const Options& options) : options_(options) {
    if (options.table) {
      table_.open(options.log);
      table_ << std::setprecision(17) << "# engine: falling\n# dt: " << options.dt
             << "\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z,"
                "velocity.x,velocity.y,velocity.z,spin.x,spin.y,spin.z,channel.hinge.angle (rad),world.random.seed\n";
      write(0);
      return;
    }
    TumbleRecDef def = {};
    def.engine = "falling";
    def.path = options.log.c_str();
    def.precision_bits = 53;
    def.gravity[2] = -9.81;
    rec_ = tumble_rec_create(&def);
    for (std::uint64_t id = 1; id <= 2; ++id) add_body(id, state(id), false);
    tumble_rec_channel(rec_, "hinge.angle", TUMBLE_REC_OF_BODY, TUMBLE_REC_F64, &angle_);
    tumble_rec_channel(rec_, "random.seed", TUMBLE_REC_WORLD, TUMBLE_REC_I64, &seed_);
    tumble_rec_channel(rec_, "grip", TUMBLE_REC_OF_PAIR, TUMBLE_REC_F64, &grip_);
    if (options.extra) tumble_rec_channel(rec_, "extra", TUMBLE_REC_WORLD, TUMBLE_REC_F64, &extra_);
  }

  void step(std::uint64_t k) {
    if (options_.late && k == 5 && rec_ != nullptr) {
      TumbleRecState stands = {};
      stands.position[0] = -50;
      stands.orientation[0] = 1;
      add_body(3, stands, true);
    }
    if (options_.poke == k && rec_ != nullptr) tumble_rec_input(rec_, "poke", 0, "x", 1);
    for (const Kick& kick : options_.kicks) {
      if (kick.step != k) continue;
      speed_[kick.body - 1] += kick.value;
      if (rec_ != nullptr) tumble_rec_input(rec_, "kick", kick.body, &kick.value, sizeof kick.value);
    }
    for (int i = 0; i < 2; ++i) {
      x_[i] += speed_[i] * options_.dt;
      if (options_.move.step == k) x_[i] += options_.move.value;
    }
    if (options_.nan == k) x_[0] = std::nan("");
    write(k);
  }

  int finish() {
    if (rec_ == nullptr) return 0;
    if (options_.open) std::_Exit(0);
    const std::string message = tumble_rec_message(rec_);
    if (tumble_rec_close(rec_) == TUMBLE_REC_OK) return 0;
    std::cerr << message << '\n';
    return 1;
  }

 private:
  void add_body(std::uint64_t id, const TumbleRecState& state, bool is_static) {
    TumbleRecBody body = {};
    body.id = id;
    body.mass = 1;
    body.shape = options_.sphere == id ? TUMBLE_REC_SPHERE : TUMBLE_REC_BOX;
    body.size[0] = body.size[1] = body.size[2] = 1;
    if (options_.sphere == id) body.size[0] = 0.5;  // the box around it is that of a cube
    body.is_static = is_static ? 1 : 0;
    body.state = state;
    tumble_rec_body(rec_, &body);
  }

  [[nodiscard]] double time(std::uint64_t k) const { return static_cast<double>(k) * options_.dt; }

  [[nodiscard]] TumbleRecState state(std::uint64_t id) const {
    TumbleRecState state = {};
    state.position[0] = x_[id - 1];
    state.position[1] = static_cast<double>(3 * id);
    state.position[2] = 5;
    state.orientation[0] = 1;
    state.velocity[0] = speed_[id - 1];
    return state;
  }

  [[nodiscard]] double angle(std::uint64_t k, std::uint64_t id) const {
    return options_.angle.step == k && id == 2 ? options_.angle.value : std::sqrt(time(k)) * static_cast<double>(id);
  }
  [[nodiscard]] std::int64_t seed(std::uint64_t k) const {
    return options_.seed.step == k ? static_cast<std::int64_t>(options_.seed.value)
                                   : static_cast<std::int64_t>(7 * k + 1);
  }

  void write(std::uint64_t k) {
    if (rec_ == nullptr) {
      for (std::uint64_t id = 1; id <= 2; ++id) {
        table_ << k << ',' << id << ',' << x_[id - 1] << ',' << 3 * id << ",5,1,0,0,0," << speed_[id - 1]
               << ",0,0,0,0,0," << angle(k, id) << ',' << seed(k) << '\n';
      }
      table_.flush();
      return;
    }
    tumble_rec_step_begin(rec_, options_.dt);
    for (std::uint64_t id = 1; id <= 2; ++id) {
      TumbleRecState now = state(id);
      if (options_.stretched == k) now.orientation[0] = 2;
      tumble_rec_state(rec_, id, &now);
      tumble_rec_f64(rec_, angle_, id, angle(k, id));
    }
    tumble_rec_i64(rec_, seed_, 0, seed(k));
    const double grip = options_.grip.step == k ? options_.grip.value : 0.5;
    tumble_rec_value(rec_, grip_, 1, 2, &grip, 1);
    if (options_.extra) tumble_rec_f64(rec_, extra_, 0, time(k));
    tumble_rec_step_end(rec_);
  }

  const Options& options_;
  TumbleRec* rec_ = nullptr;
  std::ofstream table_;
  std::uint32_t angle_ = 0, seed_ = 0, grip_ = 0, extra_ = 0;
  double x_[2] = {0, 0};
  double speed_[2] = {1, -1};
};

int run(Options options) {
  read_inputs(options);
  Engine engine(options);
  for (std::uint64_t k = 1; k <= options.steps; ++k) {
    if (options.crash == k) std::abort();
    while (options.hang == k) std::this_thread::sleep_for(std::chrono::seconds(1));
    engine.step(k);
    if (options.pause_ms > 0) std::this_thread::sleep_for(std::chrono::milliseconds(options.pause_ms));
  }
  return engine.finish();
}

}  // namespace
}  // namespace tumble::toy

int main(int argc, char** argv) { return tumble::toy::run(tumble::toy::read_options(argc, argv)); }
