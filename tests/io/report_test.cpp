#include "io/report.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <regex>

#include "report_support.hpp"

namespace bodyline {
namespace {

using testing::HasSubstr;
using testing::Not;
using tests::page_of;
using tests::small_report;
using tests::tag_error;
using tests::visible_text;
using tests::without_namespaces;

constexpr std::size_t most_bytes =
    6'000'000;  // what mail programs and old laptops take without complaint

class Report : public testing::Test {
 protected:
  static const std::string& page() {
    static const std::string made = page_of(small_report());
    return made;
  }
};

TEST_F(Report, EveryTagIsClosedInOrder) { EXPECT_EQ(tag_error(page()), ""); }

TEST_F(Report, TheCheckOfTagsFindsABrokenPage) {
  EXPECT_NE(tag_error("<html><p><b>x</p></b></html>"), "");
  EXPECT_NE(tag_error("<html><p>x</html>"), "");
  EXPECT_NE(tag_error("<html>1 < 2</html>"), "");
}

TEST_F(Report, ShowsAllDigitsOfEveryTerm) {
  const std::string text = visible_text(page());
  for (const io::ReportTerm& term : small_report().terms) {
    EXPECT_THAT(text, HasSubstr(term.name));
  }
  for (const char* number : {"4935.0625", "97.53125", "0.71875", "5006.9375"}) {
    EXPECT_THAT(text, HasSubstr(number));
  }
}

TEST_F(Report, ShowsEveryVariableAndMarksBounds) {
  const std::string text = visible_text(page());
  for (const char* part :
       {"shape.hood.u[0]", "-3.5625", "cut.hood.u_lo", "fullness.hood__windshield.a", "1.25"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
  EXPECT_THAT(text, HasSubstr("upper bound"));
  EXPECT_THAT(text, Not(HasSubstr("lower bound")));
}

TEST_F(Report, ShowsTheCommandLine) {
  EXPECT_THAT(page(),
              HasSubstr("bodyline fair cars/model1.toml -o tuned.toml --vary &#39;cut.*&#39;"));
}

TEST_F(Report, HasFourPairsOfPictures) {
  const std::regex picture("<img [^>]{0,200}src=\"data:image/png;base64,iVBOR");
  EXPECT_EQ(std::distance(std::sregex_iterator(page().begin(), page().end(), picture), {}), 8);
}

TEST_F(Report, NeedsNothingFromElsewhere) {
  for (const char* reference : {"http://", "https://", "url(", "@import", "src=\"/", "<link"}) {
    EXPECT_THAT(without_namespaces(page()).find(reference), std::string::npos) << reference;
  }
}

TEST_F(Report, TheFileIsNotLarge) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "large.html";
  io::write_fair_report(small_report(), path, io::Overwrite::allowed);
  EXPECT_LT(std::filesystem::file_size(path), most_bytes);
}

TEST_F(Report, TheSameRunGivesTheSameBytes) { EXPECT_TRUE(page() == page_of(small_report())); }

// Whatever a search meets, readers see no "nan".
TEST_F(Report, NumbersThatDoNotExistAreDashes) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = HUGE_VAL;
  io::FairReport report = small_report();
  report.terms[0].before = inf;
  report.terms[1].after = nan;
  report.value_before = nan;
  report.history.insert(report.history.begin(), {{0, nan, inf, 0.0}, {0, 0.0, -1.0, 0.0}});
  report.variables.push_back({"curve.free[0].x", 1.0, 2.0, -inf, inf});
  report.variables.push_back({"curve.broken[0].x", nan, inf, nan, nan});
  const std::string page = page_of(report);
  const std::regex number("\\b(nan|inf|infinity)\\b", std::regex::icase);
  const std::string text = visible_text(page);
  std::smatch match;
  EXPECT_FALSE(std::regex_search(text, match, number))
      << match.prefix().str().substr(0, 0) << match.str();
  EXPECT_THAT(page, Not(HasSubstr("=\"nan")));
  EXPECT_THAT(page, Not(HasSubstr("nan%")));
  EXPECT_EQ(tag_error(page), "");
}

TEST_F(Report, HostileNamesAreText) {
  const std::string hostile = "<script>alert('x')</script>&\"";
  io::FairReport report = small_report();
  report.title = report.status = report.command = hostile;
  report.before.name = report.after.name = hostile;
  report.terms[0].name = hostile;
  report.variables[0].name = hostile;
  report.folded_faces = {hostile};
  const std::string page = page_of(report);
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(page, HasSubstr("&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt;&amp;&quot;"));
  EXPECT_EQ(tag_error(page), "");
}

TEST_F(Report, ARunThatFoundNothingAndHasNoHistoryHasAPage) {
  io::FairReport report = small_report();
  report.after = report.before;
  report.history.clear();
  report.variables.clear();
  report.terms.clear();
  EXPECT_EQ(tag_error(page_of(report)), "");
}

TEST_F(Report, AnExistingFileIsKeptUnlessAsked) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "kept.html";
  std::filesystem::remove(path);
  io::write_file(path, "mine");
  EXPECT_THROW(io::write_fair_report(small_report(), path), std::runtime_error);
  EXPECT_EQ(std::filesystem::file_size(path), 4u);
}

}  // namespace
}  // namespace bodyline
