// `tumble render` of bodies that are no boxes: a table with a sphere, a capsule, a cylinder, a hull and a mesh.
#include <gtest/gtest.h>

#include <string>

#include "tests/support/pictures.h"
#include "tests/support/program.h"
#include "tumble/render/png.h"

namespace tumble::test {
namespace {

const std::string kPyramid =
    "v -0.6 -0.6 -0.5\nv 0.6 -0.6 -0.5\nv 0.6 0.6 -0.5\nv -0.6 0.6 -0.5\nv 0 0 0.7\n"
    "f 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";

class RenderShapes : public testing::Test {
 protected:
  /// One step of bodies in a row, 1.8 m apart, each with a shape; seen from the front.
  render::Image drawn(const std::vector<std::string>& shapes, const std::string& name) {
    std::string rows;
    for (const char* step : {"0", "1"}) {
      for (std::size_t k = 0; k < shapes.size(); ++k) {
        const std::string x = std::to_string(1.8 * static_cast<double>(k) - 3.6), id = std::to_string(k + 1);
        rows.append(step).append(",").append(id).append(",").append(x);
        rows.append(",0,0.8,0.965925826289068,0.258819045102521,0,0,0,0,0,0,0,0,1,1,");
        rows.append(k == 1 || k == 2 ? "1.6," : "1,").append(shapes[k]).append("\n");
      }
    }
    shop_.write("pyramid.obj", kPyramid);
    shop_.write(name + ".csv",
                "# engine: shapes\n# dt: 0.1\nstep,id,position.x,position.y,position.z,orientation.w,orientation.x,"
                "orientation.y,orientation.z,velocity.x,velocity.y,velocity.z,spin.x,spin.y,spin.z,size.x,size.y,"
                "size.z,shape\n" +
                    rows);
    const Outcome imported = shop_.run({"import", name + ".csv"});
    EXPECT_EQ(imported.exit, 0) << imported.err;
    const Outcome outcome = shop_.run({"render", name + ".tumble", "--step", "1", "--size", "480x200", "--samples", "2",
                                       "--effects", "shadow,specular", "--camera", "position=0,-9,3", "--camera",
                                       "target=0,0,0.6", "-o", name + ".png"});
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    const Result<render::PngFile> read = render::read_png(shop_.path(name + ".png"));
    EXPECT_TRUE(read.ok());
    return read.ok() ? read->image : render::Image::blank(480, 200);
  }

  Workshop shop_;
};

// tests/data/shapes.png: this picture, looked at. Another driver may change a few pixels, a lost shape changes
// hundreds.
TEST_F(RenderShapes, AreDrawnAsTheyAre) {
  const render::Image image =
      drawn({"sphere", "capsule-z", "cylinder-z", "hull:pyramid.obj", "mesh:pyramid.obj"}, "all");
  const Result<render::PngFile> golden = render::read_png(std::string(TUMBLE_SOURCE_DIR) + "/tests/data/shapes.png");
  ASSERT_TRUE(golden.ok()) << golden.error().message;
  ASSERT_EQ(golden->image.width, image.width);
  EXPECT_LE(difference(golden->image, image).far_off, 100U);
}

// A shape covers a part of its box, and casts a part of its shadow.
TEST_F(RenderShapes, AreNoBoxesAroundThem) {
  const render::Image boxes = drawn({"box", "box", "box", "box", "box"}, "boxes");
  const render::Image ball = drawn({"sphere", "box", "box", "box", "box"}, "ball");
  EXPECT_GT(difference(boxes, ball).far_off, 500U);
}

}  // namespace
}  // namespace tumble::test
