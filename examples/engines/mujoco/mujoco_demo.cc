// Ten cubes and an arm in MuJoCo, recorded, with probes for `tumble diff --zoom`. ../demo.h has the arguments.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "../demo.h"
#include "tumble_mujoco.h"
#include "tumble_probe.h"

namespace {

std::string model_of(double friction) {
  std::string xml = "<mujoco><option timestep='0.005'/><worldbody><geom type='plane' size='0 0 1' friction='" +
                    std::to_string(friction) + " 0.005 0.0001'/>";
  for (int k = 0; k < 10; ++k) {
    double at[3], tilt = 0;
    demo_cube(k, at, &tilt);
    xml += "<body name='cube " + std::to_string(k) + "' pos='" + std::to_string(at[0]) + ' ' + std::to_string(at[1]) +
           ' ' + std::to_string(at[2]) + "' axisangle='1 0 0 " + std::to_string(tilt * 57.29578) +
           "'><freejoint/><geom type='box' size='0.5 0.5 0.5' mass='1' friction='0.1 0.005 0.0001'/></body>";
  }
  xml += "<body name='arm' pos='5 0 2'><joint name='hinge' axis='0 1 0'/>"
         "<geom type='capsule' fromto='0 0 0 1 0 0' size='0.05' mass='1'/></body></worldbody>"
         "<actuator><motor joint='hinge'/></actuator></mujoco>";
  return xml;
}

mjModel* load(const std::string& xml) {
  std::vector<mjVFS> files(1);  // large, so not on the stack
  char problem[500] = "";
  mj_defaultVFS(files.data());
  mj_makeEmptyFileVFS(files.data(), "demo.xml", static_cast<int>(xml.size()));
  std::memcpy(files[0].filedata[0], xml.data(), xml.size());
  mjModel* model = mj_loadXML("demo.xml", files.data(), problem, sizeof problem);
  mj_deleteVFS(files.data());
  if (model == nullptr) std::fprintf(stderr, "%s\n", problem);
  return model;
}

}  // namespace

int main(int count, char** words) {
  Demo demo(count, words);
  tumble_probes_from_environment(&tumble_probes);
  mjModel* model = load(model_of(demo.friction));
  if (model == nullptr) return 2;
  mjData* data = mj_makeData(model);
  MujocoRecorder recorder(model, data, demo.def);
  for (int k = 0; k < demo.steps; ++k) {
    tumble_probes_step(&tumble_probes, static_cast<std::uint64_t>(k) + 1);
    TUMBLE_PROBE(&tumble_probes, "hinge.angle before", 0, data->qpos[model->nq - 1]);
    data->ctrl[0] = std::sin(0.05 * k);
    TUMBLE_PROBE(&tumble_probes, "motor.control", 0, data->ctrl[0]);
    recorder.step();
    TUMBLE_PROBE(&tumble_probes, "hinge.angle after", 0, data->qpos[model->nq - 1]);
  }
  tumble_probes_close(&tumble_probes);
  const int status = Demo::end(recorder.rec);
  mj_deleteData(data);
  mj_deleteModel(model);
  return status;
}
