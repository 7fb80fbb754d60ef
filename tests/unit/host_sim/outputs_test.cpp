#include "model_files.hpp"
#include "tool.hpp"

/// Where results go: names as users write them, and places that cannot take a result, which then leave nothing of it.
namespace spanline::sim::test {
namespace {

class OutputsTest : public ToolTest {
 protected:
  void expect_failed(const std::string& line, const std::vector<std::string>& files_before, int exit_code = 1) const {
    SCOPED_TRACE(line);
    expect_refused(shell(line), exit_code, files_before);
  }
};

TEST_F(OutputsTest, NamesMayFollowAnEqualsSignAndBeginWithADash) {
  make_file("a.obj", cube_obj());
  make_file("-b.obj", cube_obj());
  for (const std::string how : {"-o=-o.png", "-o -o.png", "-o-o.png", "--output=-o.png", "--output -o.png"}) {
    SCOPED_TRACE(how);
    const ToolRun result = shell("\"$SPANLINE\" render a.obj --size 16x16 " + how);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_EQ(files(), (std::vector<std::string>{"-b.obj", "-o.png", "a.obj"}));
    EXPECT_EQ(read_png(in_folder("-o.png")).width, 16);
    std::filesystem::remove(in_folder("-o.png"));
  }
  EXPECT_EQ(shell("\"$SPANLINE\" render --size 16x16 -o=c.png --depth-out=-d.png -- -b.obj").errors, "");
  EXPECT_EQ(shell("\"$SPANLINE\" convert -o=-c.hpp -- -b.obj").errors, "");
  EXPECT_EQ(files(), (std::vector<std::string>{"-b.obj", "-c.hpp", "-d.png", "a.obj", "c.png"}));
}

TEST_F(OutputsTest, AnEmptyNameIsRefusedAndTakesNoOtherWord) {
  make_file("a.obj", cube_obj());
  const auto before = files();
  for (const std::string how : {"-o=", "--output=", "-o ''", "--output ''", "-o x.png --stats=", "-o x.png --stats ''"})
    expect_failed("\"$SPANLINE\" render " + how + " a.obj", before, 2);
}

TEST_F(OutputsTest, AFullStandardOutputLeavesNoResult) {
  make_file("a.obj", cube_obj());
  make_file("old.hpp", "old");
  const auto before = files();
  for (const std::string stream : {">/dev/full", ">&-"}) {
    for (const std::string arguments : {"list", "--version", "--help", "render --help", "convert a.obj -o a.hpp",
                                        "convert a.obj -o old.hpp", "render a.obj -o a.png --stats s.json --pick 3,4"})
      expect_failed("\"$SPANLINE\" " + arguments + " " + stream, before);
  }
  EXPECT_EQ(read_text(in_folder("old.hpp")), "old");
  // What prints nothing needs no stdout, and no file that it writes is taken for it.
  EXPECT_EQ(shell("\"$SPANLINE\" render a.obj -o a.png >&- 2>&-").exit_code, 0);
  EXPECT_EQ(read_png(in_folder("a.png")).width, 320);
}

TEST_F(OutputsTest, FullDisksAndFileLimitsAreErrorLines) {
  make_file("a.obj", cube_obj());
  make_file("old.png", "old");
  const auto before = files();
  for (const std::string arguments :
       {"render a.obj -o a.png", "render a.obj -o old.png", "render a.obj -o a.gif --turntable 3",
        "render a.obj -o a.png --turntable 3", "render a.obj -o a.png --size 8x8 --depth-out d.png --stats s.json",
        "convert a.obj -o a.hpp"})
    expect_failed("(ulimit -f 0; \"$SPANLINE\" " + arguments + " 2>&1 >/dev/null) | cat >&2; exit 1", before);
  EXPECT_EQ(read_text(in_folder("old.png")), "old");
  for (const std::string arguments : {"render a.obj -o /dev/full", "render a.obj -o a.png --stats /dev/full",
                                      "render a.obj -o a.png --depth-out /dev/full", "convert a.obj -o /dev/full"})
    expect_failed("\"$SPANLINE\" " + arguments, before);
}

TEST_F(OutputsTest, AFileLimitEndsTheCommandWithExitOne) {
  make_file("a.obj", cube_obj());
  for (const std::string arguments : {"render a.obj -o a.png", "convert a.obj -o a.hpp", "list >list.txt"})
    EXPECT_EQ(shell("ulimit -f 0; \"$SPANLINE\" " + arguments + " 2>/dev/null").exit_code, 1) << arguments;
}

}  // namespace
}  // namespace spanline::sim::test
