#include "tools/arguments/live_options.h"

#include "tools/output/text.h"

namespace tumble::tools {

void declare_arguments(Arguments& arguments, LiveArguments& target) {
  const Argument scene = arguments.positional(
      "SCENE", target.scene, "A scene file (.toml), or the name of a golden case ('tumble scenes' lists them)");
  arguments.option("-o,--output", "LOG", target.log,
                   "The log; <scene>_live.tumble in the current folder if not given, with a number if that exists");
  const Argument from =
      arguments
          .option("--from", "LOG:STEP", target.from,
                  "Play on from the state after step STEP of LOG instead of beginning a scene; into <log>_from_<step>")
          .excludes(scene);
  arguments.flag("--no-inputs", target.no_inputs, "With --from: leave out the inputs that LOG has after STEP")
      .needs(from);
  arguments
      .option("--set", "KEY=VALUE", target.overrides, "Set a value of the scene, as in 'grid.rows=7'; may be repeated")
      .excludes(from);
  arguments.flag("--even", target.even, "Steps of exactly the scene's dt, instead of steps as long as the clock's");
  arguments.threads(target.threads);
  arguments.option("--states", "MODE", target.states, "States in the log: all (if not given), every:N or hashes")
      .offers({"all", "every:2", "hashes"});
  arguments.option("--size", "WxH", target.size, "Width and height of the window in pixels (default: 960x600)");
  arguments.whole("--samples", "N", target.samples, 1, 4,
                  "Samples a pixel along each edge (1): more are smooth and slow");
  arguments.option("--effects", "LIST", target.effects, "Effects at the start, as for 'tumble render'")
      .offers({"all", "none", "specular", "shadow", "bloom", "dof", "motion", "vertex"});
  arguments.positive("--measure", "S", target.measure, 3600,
                     "Play by itself for S seconds: throw a box every half second, turn the camera, then close and "
                     "report frames a second; for 'tumble bench live'");
  arguments.json(target.json);
  arguments.footer(
      "Left button: hold, and let go to throw (1), push (2), remove (3), wake (4) or follow (5) what is under the "
      "pointer.\n"
      "Right button: turn the camera; middle button: shift it; wheel: nearer, farther. F1 shows all keys.\n"
      "The log has every input, replays bit for bit, and is complete however the window is closed.\n"
      "Needs a display. 'tumble view LOG -o FILE.html' shows a recorded session in a browser.\n\n"
      "Examples:\n"
      "  tumble live brick_wall\n"
      "  tumble live tilted_grid -o played.tumble --set grid.rows=10 --size 1280x720\n"
      "  tumble live --from played.tumble:600\n"
      "  tumble render played.tumble --as-seen -o played.mp4");
}

std::vector<std::string> words_of(const LiveArguments& arguments) {
  std::vector<std::string> words;
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) words.push_back(std::string(name) + '=' + value);  // a value may begin with a dash
  };
  add("--output", arguments.log);
  add("--from", arguments.from);
  for (const std::string& setting : arguments.overrides) add("--set", setting);
  if (arguments.threads) add("--threads", std::to_string(*arguments.threads));
  if (arguments.samples) add("--samples", std::to_string(*arguments.samples));
  if (arguments.measure) add("--measure", exact(*arguments.measure));
  add("--states", arguments.states);
  add("--size", arguments.size);
  add("--effects", arguments.effects);
  if (arguments.no_inputs) words.emplace_back("--no-inputs");
  if (arguments.even) words.emplace_back("--even");
  if (arguments.json) words.emplace_back("--json");
  if (!arguments.scene.empty()) words.insert(words.end(), {"--", arguments.scene});
  return words;
}

}  // namespace tumble::tools
