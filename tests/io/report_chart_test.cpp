#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/report_html.hpp"
#include "io/svg_chart_axis.hpp"
#include "io/svg_chart_bars.hpp"
#include "io/svg_chart_lines.hpp"

namespace bodyline::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr double rounding = 1e-12;  // of the logarithms

TEST(ChartAxis, ValuesAndTicksHaveTheirPlacesOverManySizes) {
  for (const auto scale : {ChartAxis::Scale::linear, ChartAxis::Scale::logarithmic}) {
    for (int low = -12; low <= 9; ++low) {
      for (int decades = 0; decades <= 15; ++decades) {
        const double a = 1.7 * std::pow(10.0, low), b = a * std::pow(10.0, decades);
        const ChartAxis axis({a, b}, scale);
        ASSERT_GE(axis.ticks().size(), 2u);
        EXPECT_LE(axis.ticks().size(), 9u) << a << " " << b;
        EXPECT_TRUE(std::is_sorted(axis.ticks().begin(), axis.ticks().end()));
        EXPECT_GT(axis.position(a), 0.0);
        EXPECT_LT(axis.position(b), 1.0);
        EXPECT_LE(axis.position(a), axis.position(b));
      }
    }
  }
}

TEST(ChartAxis, EqualRatiosAreEqualStepsOnALogarithmicScale) {
  const ChartAxis axis({1.0, 1e4}, ChartAxis::Scale::logarithmic);
  EXPECT_NEAR(axis.position(1e2) - axis.position(1e1), axis.position(1e4) - axis.position(1e3),
              rounding);
  EXPECT_THAT(axis.ticks(), ElementsAre(1.0, 10.0, 100.0, 1000.0, 10000.0));
}

TEST(ChartAxis, ValuesWithoutAPlaceAreNotShown) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const ChartAxis axis({nan, -1.0, 0.0, HUGE_VAL, 5.0}, ChartAxis::Scale::logarithmic);
  EXPECT_FALSE(axis.shows(nan));
  EXPECT_FALSE(axis.shows(0.0));
  EXPECT_FALSE(axis.shows(HUGE_VAL));
  EXPECT_TRUE(axis.shows(5.0));
}

TEST(LineChart, AnInterruptedLineBeginsAnew) {
  const std::string svg = svg_line_chart({"x", "y", {{0, 1}, {1, -1}, {2, 10}, {3, 100}}, 200});
  EXPECT_THAT(svg, testing::ContainsRegex("d=\"M[0-9. ]+M[0-9. ]+L[0-9. ]+\""));
}

TEST(LineChart, OnePointAndNoUsablePointAreCharts) {
  EXPECT_THAT(svg_line_chart({"x", "y", {{0, 1}}, 200}), HasSubstr("<circle"));
  EXPECT_THAT(svg_line_chart({"x", "y", {{0, HUGE_VAL}}, 200}), Not(HasSubstr("<circle")));
}

TEST(ChangeBars, NamesAreEscaped) {
  const std::string svg = svg_change_bars({{"<hood>", 1.0, 2.0}}, "\"bending\"");
  EXPECT_THAT(svg, HasSubstr(">&lt;hood&gt;<"));
  EXPECT_THAT(svg, HasSubstr("aria-label=\"&quot;bending&quot;\""));
  EXPECT_THAT(svg, Not(HasSubstr("<hood>")));
}

TEST(ChangeBars, EveryRowShowsThreeDigitsAndFourWhenPointedAt) {
  const std::string svg = svg_change_bars({{"a", 1234.56, 0.25061}, {"b", 0.0, HUGE_VAL}}, "t");
  EXPECT_THAT(svg, HasSubstr("<title>a: 1235 before, 0.2506 after</title>"));
  EXPECT_THAT(svg, HasSubstr(">1235 → 0.251</text>"));
  EXPECT_THAT(svg, HasSubstr("<title>b: 0 before, – after</title>"));
  EXPECT_THAT(svg, HasSubstr(">0 → –</text>"));
}

TEST(ChangeBars, OnlyPositiveFiniteValuesHaveMarks) {
  const auto marks = [](double before, double after) {
    const std::string svg = svg_change_bars({{"a", before, after}, {"b", 1.0, 2.0}}, "t");
    int count = -2;  // those of the second row
    for (std::size_t at = svg.find("<circle"); at != svg.npos; at = svg.find("<circle", at + 1))
      ++count;
    return count;
  };
  EXPECT_EQ(marks(3.0, 4.0), 2);
  EXPECT_EQ(marks(0.0, 4.0), 1);
  EXPECT_EQ(marks(3.0, HUGE_VAL), 1);
  EXPECT_EQ(marks(-1.0, std::nan("")), 0);
}

TEST(HtmlNumber, IsShortAndExactWhereItCanBe) {
  EXPECT_EQ(html_number(4935.06), "4935");
  EXPECT_EQ(html_number(97.53125), "97.53");
  EXPECT_EQ(html_number(-0.5), "−0.5");
  EXPECT_EQ(html_number(0.0), "0");
  EXPECT_EQ(html_number(2.1e-13, 2), "2.1&#8239;·&#8239;10<sup>−13</sup>");
  EXPECT_EQ(html_number(-1e-12), "−1&#8239;·&#8239;10<sup>−12</sup>");
  EXPECT_EQ(html_number(1e-12), "10<sup>−12</sup>");
  EXPECT_EQ(html_number(std::nan("")), "–");
  EXPECT_EQ(exact_number(0.1), "0.1");
}

TEST(Base64, EncodesTheVectorsOfTheStandard) {
  const auto encoded = [](const std::string& text) {
    return base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  };
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
}

}  // namespace
}  // namespace bodyline::io
