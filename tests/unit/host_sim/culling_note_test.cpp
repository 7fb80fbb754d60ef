#include <algorithm>

#include "model_files.hpp"
#include "tool.hpp"

/// The note that a mesh is no closed surface, whose backs may be missed.
namespace spanline::sim::test {
namespace {

class CullingNoteTest : public ToolTest {
 protected:
  [[nodiscard]] ToolRun draw(const std::string& model, std::vector<std::string> options = {}) const {
    options.insert(options.begin(), {"render", model, "-o", in_folder("out.png"), "--size", "64x48"});
    const ToolRun result = run(options);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_EQ(result.output, "");
    return result;
  }
  static void expect_note(const ToolRun& run, const std::string& counts) {
    EXPECT_TRUE(run.errors.starts_with("spanline: note: ")) << run.errors;
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    EXPECT_NE(run.errors.find("(" + counts + ")"), std::string::npos) << run.errors;
    EXPECT_NE(run.errors.find("--cull none"), std::string::npos) << run.errors;
  }
};

/// The cube without its face at the front: its inside shows from there.
std::string open_box() {
  std::string text = cube_obj();
  const std::size_t face = text.find("f 5 6 7 8\n");
  EXPECT_NE(face, std::string::npos);
  return text.erase(face, 10);
}

std::string turned_face() {
  std::string text = cube_obj();
  const std::size_t face = text.find("f 5 6 7 8\n");
  EXPECT_NE(face, std::string::npos);
  return text.replace(face, 10, "f 8 7 6 5\n");
}

TEST_F(CullingNoteTest, ClosedMeshesHaveNone) {
  const std::string model = make_file("a.obj", cube_obj());
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{}, {"--cull", "back"}, {"--cull", "none"}, {"--shade", "gouraud"}})
    EXPECT_EQ(draw(model, options).errors, "");
}

TEST_F(CullingNoteTest, OpenAndTurnedEdgesAreCounted) {
  const std::string box = make_file("box.obj", open_box()), turned = make_file("turned.obj", turned_face());
  expect_note(draw(box, {"--cull", "back"}), "4 open edges");
  expect_note(draw(turned, {"--cull", "back"}), "4 edges between faces that turn opposite ways");
  expect_note(draw(make_file("one.obj", triangle_obj()), {"--cull", "back"}), "3 open edges");
  // A leaf on a cube's edge has two edges of its own, and makes three faces of the edge.
  expect_note(draw(make_file("leaf.obj", cube_obj() + "v 0 0 9\nf 5 6 9\n"), {"--cull", "back"}), "3 open edges");
}

TEST_F(CullingNoteTest, FacesWithoutAreaOpenNothing) {
  const std::string line = make_file("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  EXPECT_EQ(draw(line, {"--cull", "back"}).errors, "");
  // One side of the cube's front is divided; a face that is a line lies in the crack.
  std::string divided = cube_obj() + "v 0 -1 1\nf 5 9 8\nf 9 6 7\nf 9 7 8\n";
  divided.erase(divided.find("f 5 6 7 8\n"), 10);
  expect_note(draw(make_file("crack.obj", divided), {"--cull", "back"}), "3 open edges");
  EXPECT_EQ(draw(make_file("filled.obj", divided + "f 5 6 9\n"), {"--cull", "back"}).errors, "");
}

TEST_F(CullingNoteTest, WhoeverDrawsBacksNeedsNone) {
  const std::string box = make_file("box.obj", open_box());
  EXPECT_EQ(draw(box, {"--cull", "none"}).errors, "");
  EXPECT_EQ(draw(box, {"--cull", "front"}).errors, "");
}

TEST_F(CullingNoteTest, UnaskedForItAppearsWhereThePictureLacksABack) {
  const std::string box = make_file("box.obj", open_box());
  EXPECT_EQ(draw(box, {"--eye", "0,0,-5"}).errors, "");
  expect_note(draw(box, {"--eye", "2,2,5"}), "4 open edges");
  expect_note(draw(box, {"--eye", "0,0,-5", "--turntable", "5"}), "4 open edges");
  EXPECT_EQ(draw(make_file("one.obj", triangle_obj()), {"--eye", "0,0,5"}).errors, "");
  expect_note(draw(in_folder("one.obj"), {"--eye", "0,0,-5"}), "3 open edges");
  // An old output is no worse for it, and the picture is there.
  EXPECT_EQ(read_png(in_folder("out.png")).width, 64);
}

TEST_F(CullingNoteTest, AFailureHasItsOneLineAlone) {
  const std::string box = make_file("box.obj", open_box());
  const auto before = files();
  expect_refused(run({"render", box, "-o", "/dev/full", "--cull", "back"}), 1, before);
}

}  // namespace
}  // namespace spanline::sim::test
