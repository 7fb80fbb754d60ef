// Lecture 002 (Crawfis): the scan lines that it works through, with the AET and IPL sequences that it prints, by its
// own algorithm; and what the algorithms that are listed here make of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "brute_force.hpp"
#include "generators.hpp"
#include "lectures/lecture_triangle.hpp"
#include "recording_shaders.hpp"
#include "support/effort.hpp"
#include "textbook.hpp"
#include "verdict.hpp"

namespace spanline::contract {
namespace {

/// A figure of the lecture: letters for the corners of polygons S and T.
struct Figure {
  Scene scene;
  std::vector<std::string> letters;

  /// The AET, "x0 ba bc xN"; an edge's letters in the order of the alphabet, since the lecture writes one and the same
  /// edge as ca and ac.
  [[nodiscard]] std::string edges(const Textbook::Row& row) const {
    std::string text = "x0";
    for (std::size_t i = 1; i + 1 < row.edges.size(); ++i) {
      const Textbook::ActiveEdge& edge = row.edges[i];
      std::string name = "ce";  // the only false edge of the figures
      if (!edge.is_false) {
        const std::string& corners = letters[edge.polygon - 1];
        name = {corners[edge.upper], corners[edge.lower]};
        std::sort(name.begin(), name.end());
      }
      text += ' ' + name;
    }
    return text + " xN";
  }
  /// The IPL span by span, "BG BG+S BG".
  [[nodiscard]] static std::string inside(const Textbook::Row& row) {
    std::string text;
    for (std::vector<std::uint32_t> list : row.inside) {
      std::sort(list.begin(), list.end());
      text += text.empty() ? "BG" : " BG";
      for (const std::uint32_t id : list) text += id == 1 ? "+S" : "+T";
    }
    return text;
  }
};

std::vector<Span> spans_on(const Scene& scene, int row) {
  std::vector<Span> spans = spans_of(scene);
  spans.erase(std::remove_if(spans.begin(), spans.end(), [row](const Span& s) { return s.row != row; }), spans.end());
  return spans;
}

/// "Spanning Scan-Line: Example". S = abc ends in c between II and III, T = 123 begins between I and II and has 2
/// between III and IV.
class SpanningExample : public ::testing::Test {
 protected:
  SpanningExample() {
    figure_.scene.width = figure_.scene.height = 64;
    const auto at = [](int x, int y, std::int32_t z) { return Corner{16 * x, 16 * y, z}; };
    figure_.scene.triangles = {{at(10, 52, 40000), at(14, 4, 40000), at(38, 24, 40000)},
                               {at(48, 56, 90000), at(24, 36, 90000), at(52, 10, 90000)}};
    figure_.letters = {"abc", "123"};
  }
  Figure figure_;
  static constexpr int line_1 = 7, line_2 = 18, line_3 = 30, line_4 = 44;
};

TEST_F(SpanningExample, TheTextbookGivesTheSequencesOfLinesIToIV) {
  const Textbook textbook(figure_.scene);
  const auto edges = [&](int y) { return figure_.edges(textbook.row(y)); };
  const auto inside = [&](int y) { return Figure::inside(textbook.row(y)); };
  EXPECT_EQ(edges(line_1), "x0 ab bc xN");
  EXPECT_EQ(inside(line_1), "BG BG+S BG");
  EXPECT_EQ(edges(line_2), "x0 ab bc 23 13 xN");
  EXPECT_EQ(inside(line_2), "BG BG+S BG BG+T BG");
  EXPECT_EQ(edges(line_3), "x0 ab 23 ac 13 xN");
  EXPECT_EQ(inside(line_3), "BG BG+S BG+S+T BG+T BG");
  EXPECT_EQ(edges(line_4), "x0 ab ac 12 13 xN");
  EXPECT_EQ(inside(line_4), "BG BG+S BG BG+T BG");
}

TEST_F(SpanningExample, TheSpansBeginAtTheEdgesThatCountAndNowhereElse) {
  const Textbook textbook(figure_.scene);
  for (const int y : {line_1, line_2, line_4}) {
    const Textbook::Row row = textbook.row(y);
    std::vector<Span> want;
    for (std::size_t i = 0; i + 1 < row.edges.size(); ++i)
      want.push_back(
          {y, row.edges[i].column, row.edges[i + 1].column, row.inside[i].empty() ? 0 : row.inside[i].front()});
    EXPECT_EQ(spans_on(figure_.scene, y), want);
  }
  // III: S hides T up to its edge ca, so that edge 32 begins no span.
  const Textbook::Row row = textbook.row(line_3);
  const int ba = row.edges[1].column, ca = row.edges[3].column, last = row.edges[4].column;
  EXPECT_EQ(spans_on(figure_.scene, line_3),
            (std::vector<Span>{{line_3, 0, ba, 0}, {line_3, ba, ca, 1}, {line_3, ca, last, 2}, {line_3, last, 64, 0}}));
  // With T in front, edge ca begins none.
  for (Corner& c : figure_.scene.triangles[1]) c.z = 20000;
  const int edge_32 = row.edges[2].column;
  EXPECT_EQ(spans_on(figure_.scene, line_3),
            (std::vector<Span>{
                {line_3, 0, ba, 0}, {line_3, ba, edge_32, 1}, {line_3, edge_32, last, 2}, {line_3, last, 64, 0}}));
}

TEST_F(SpanningExample, EveryAlgorithmDrawsIt) {
  EXPECT_EQ(difference(Textbook(figure_.scene).draw(), reference(figure_.scene)), "");
  EXPECT_EQ(fault_in(figure_.scene, {}), "");
}

/// "Penetrating Polygons": S = abd sinks behind T = 123 towards the right. They cross in the false edge ec, which line
/// I does not meet and line I′ does.
class PenetratingPolygons : public ::testing::Test {
 protected:
  PenetratingPolygons() {
    figure_.scene.width = figure_.scene.height = 64;
    const auto depth_of_s = [](int x) { return 1'000'000 + 10'000 * (x - 34); };
    const auto s = [&](int x, int y) { return Corner{16 * x, 16 * y, depth_of_s(x)}; };
    const auto t = [](int x, int y) { return Corner{16 * x, 16 * y, 1'000'000}; };
    figure_.scene.triangles = {{s(24, 4), s(4, 56), s(44, 56)}, {t(60, 58), t(16, 58), t(40, 2)}};
    figure_.letters = {"abd", "123"};
  }
  Figure figure_;
  static constexpr int line_1 = 27, line_1_dash = 44, false_edge = 34;
};

TEST_F(PenetratingPolygons, TheTextbookGivesTheSequencesOfLinesIAndIDash) {
  const Textbook textbook(figure_.scene);
  EXPECT_EQ(figure_.edges(textbook.row(line_1)), "x0 ab 23 ad 13 xN");
  EXPECT_EQ(Figure::inside(textbook.row(line_1)), "BG BG+S BG+S+T BG+T BG");
  EXPECT_EQ(figure_.edges(textbook.row(line_1_dash)), "x0 ab 23 ce ad 13 xN");
  EXPECT_EQ(Figure::inside(textbook.row(line_1_dash)), "BG BG+S BG+S+T BG+S+T BG+T BG");
}

TEST_F(PenetratingPolygons, TheListTurnsRoundAtTheFalseEdge) {
  const Textbook::Row row = Textbook(figure_.scene).row(line_1_dash);
  ASSERT_EQ(row.edges.size(), 7U);
  EXPECT_TRUE(row.edges[3].is_false);
  EXPECT_NEAR(row.edges[3].column, false_edge, 1);
  EXPECT_EQ(row.inside[2], (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(row.inside[3], (std::vector<std::uint32_t>{2, 1}));
}

TEST_F(PenetratingPolygons, SpansAreCutAtTheColumnOfTheFalseEdge) {
  const Textbook textbook(figure_.scene);
  const Textbook::Row first = textbook.row(line_1), dash = textbook.row(line_1_dash);
  const auto columns = [](const Textbook::Row& row, std::size_t i) { return row.edges[i].column; };
  EXPECT_EQ(spans_on(figure_.scene, line_1), (std::vector<Span>{{line_1, 0, columns(first, 1), 0},
                                                                {line_1, columns(first, 1), columns(first, 3), 1},
                                                                {line_1, columns(first, 3), columns(first, 4), 2},
                                                                {line_1, columns(first, 4), 64, 0}}));
  EXPECT_EQ(spans_on(figure_.scene, line_1_dash),
            (std::vector<Span>{{line_1_dash, 0, columns(dash, 1), 0},
                               {line_1_dash, columns(dash, 1), columns(dash, 3), 1},
                               {line_1_dash, columns(dash, 3), columns(dash, 5), 2},
                               {line_1_dash, columns(dash, 5), 64, 0}}));
}

TEST_F(PenetratingPolygons, ACrossingIsCountedForEveryRowThatTheFalseEdgeMeets) {
  const Textbook textbook(figure_.scene);
  std::uint64_t rows = 0;
  for (int y = 0; y < figure_.scene.height; ++y) {
    const Textbook::Row row = textbook.row(y);
    rows += static_cast<std::uint64_t>(
        std::count_if(row.edges.begin(), row.edges.end(), [](const auto& edge) { return edge.is_false; }));
  }
  EXPECT_GT(rows, 20U);
  EXPECT_EQ(draw(algorithm("span"), figure_.scene, {}).counters.named("crossings"), rows);
}

TEST_F(PenetratingPolygons, EveryAlgorithmDrawsThem) {
  EXPECT_EQ(difference(Textbook(figure_.scene).draw(), reference(figure_.scene)), "");
  EXPECT_EQ(fault_in(figure_.scene, {}), "");
}

// "Z-buffer - Example": both 8 × 8 runs, by every algorithm and by the textbook. Background is −1 here.
TEST(EightByEightTables, AreDrawnByEveryAlgorithm) {
  constexpr int unit = 1 << 20, o = -1;
  using Table = std::vector<int>;
  const test::LectureTriangle level{{{{0, 1, 5}, {0, 7, 5}, {6, 7, 5}}}}, slope{{{{0, 1, 2}, {0, 6, 7}, {5, 1, 7}}}};
  const Table first{5, 5, 5, 5, 5, 5, 5, o, 5, 5, 5, 5, 5, 5, o, o, 5, 5, 5, 5, 5, o, o, o, 5, 5, 5, 5, o, o, o, o,
                    5, 5, 5, o, o, o, o, o, 5, 5, o, o, o, o, o, o, 5, o, o, o, o, o, o, o, o, o, o, o, o, o, o, o};
  const Table second{5, 5, 5, 5, 5, 5, 5, o, 5, 5, 5, 5, 5, 5, o, o, 5, 5, 5, 5, 5, o, o, o, 5, 5, 5, 5, o, o, o, o,
                     4, 5, 5, 7, o, o, o, o, 3, 4, 5, 6, 7, o, o, o, 2, 3, 4, 5, 6, 7, o, o, o, o, o, o, o, o, o, o};
  const auto table_of = [](const Drawing& drawing) {
    Table table;
    for (const std::uint32_t word : drawing.depths)
      table.push_back(word == Depth24<>::clear ? o : static_cast<int>(std::lround(word / (256.0 * unit))));
    return table;
  };
  Scene scene(8, 8);
  for (const bool both : {false, true}) {
    scene.triangles = {level.grown(8, unit)};
    if (both) scene.triangles.push_back(slope.grown(8, unit));
    EXPECT_EQ(table_of(Textbook(scene).draw()), both ? second : first);
    EXPECT_EQ(table_of(brute_force(scene)), both ? second : first);
    for (const AlgorithmEntry& entry : algorithms_for(scene))
      for (const int lines : {0, 1, 3}) {
        if (entry.exactness != Exactness::exact) continue;
        Manner manner;
        manner.band_lines = lines;
        EXPECT_EQ(table_of(draw(entry, scene, manner)), both ? second : first) << entry.name;
      }
  }
}

/// The textbook's form is an oracle of its own: it shares neither records, bounds nor sleep with the real one.
class TextbookForm : public ::testing::TestWithParam<Generator> {};

TEST_P(TextbookForm, AgreesWithEveryAlgorithm) {
  const Generator& generator = GetParam();
  for (int i = 0; i < test::rounds(2 + generator.rounds / 16); ++i) {
    const int round = i + 7'000'000;
    Random random(seed_of(generator, round));
    const Scene scene = generator.make(random);
    const Drawing want = Textbook(scene).draw();
    for (const AlgorithmEntry& entry : algorithms_for(scene))
      ASSERT_EQ(fault_of(entry.exactness, want, draw(entry, scene, {}), want, scene), "")
          << entry.name << ", seed " << seed_of(generator, round) << '\n'
          << text_of(scene);
  }
}

// One decision a span: where one ends, another polygon begins.
TEST_P(TextbookForm, NoTwoNeighbouringSpansAreOfOnePolygon) {
  const Generator& generator = GetParam();
  for (int i = 0; i < test::rounds(generator.rounds / 4); ++i) {
    const int round = i + 8'000'000;
    Random random(seed_of(generator, round));
    const Scene scene = generator.make(random);
    const std::vector<Span> spans = spans_of(scene);
    for (std::size_t k = 1; k < spans.size(); ++k)
      ASSERT_FALSE(spans[k].row == spans[k - 1].row && spans[k].id == spans[k - 1].id)
          << spans[k - 1] << ", then " << spans[k] << ", seed " << seed_of(generator, round) << '\n'
          << text_of(scene);
  }
}

std::string name_of(const ::testing::TestParamInfo<Generator>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(OnScreen, TextbookForm, ::testing::ValuesIn(screen_generators()), name_of);

}  // namespace
}  // namespace spanline::contract
