#include "io/fit_report.hpp"

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
using tests::tag_error;
using tests::visible_text;
using tests::without_namespaces;

constexpr std::size_t most_bytes = 6'000'000;  // what mail programs take without complaint
constexpr io::PictureSize small_pictures{192, 108};

io::FitReport small_fit() {
  const io::FairReport models = tests::small_report();
  io::FitReport report;
  report.title = "sedan";
  report.words = "sedan.ply: PLY, 3 points.";
  report.status = "The fit ended.";
  report.command = "bodyline fit 'a scan.ply' -o sedan.toml";
  report.before = models.before;
  report.body = models.after;
  report.pose.translation = {1234.5, -6.25, 78.125};
  report.pose.scale = 25.4;
  report.field.caption = "distance of the scan, mm";
  report.field.range = 5.0;
  report.field.faces = {{"hood", 2, {1.0, -2.0, std::nan(""), 4.0}}};
  report.field.values = {1.0, -2.0, 4.0};
  report.distances = {1.0625, 7.375, 31.5, 2.5};
  report.faces = {{"hood", 3, 0.75, {1.0625, 3.75, 4.0, 2.5}},
                  {"roof", 0, 0.0, {}},
                  {"door", 3, 1.0, {2.125, 7.375, 31.5, 3.5}}};
  report.unseen_patches = {"roof"};
  report.history = {{"warp", 80.0, 0.5}, {"warp", 20.0, 1.0}, {"body", 2.0, 2.0}};
  report.points = {{{1500.0, 0.0, 900.0}, 1.0}, {{1600.0, 0.0, 900.0}, -2.0}};
  report.seconds = 2.25;
  return report;
}

class FitReport : public testing::Test {
 protected:
  static const std::string& page() {
    static const std::string made = io::fit_report_page(small_fit(), small_pictures);
    return made;
  }
};

TEST_F(FitReport, EveryTagIsClosedInOrder) { EXPECT_EQ(tag_error(page()), ""); }

TEST_F(FitReport, ShowsAllDigitsOfThePoseAndOfEverySeenFace) {
  const std::string text = visible_text(page());
  for (const char* part : {"1234.5", "-6.25", "78.125", "25.4", "hood", "door", "2.125", "31.5"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
}

TEST_F(FitReport, ListsTheWorstFaceFirst) {
  EXPECT_LT(page().find("scope=\"row\">door"), page().find("scope=\"row\">hood"));
}

TEST_F(FitReport, NamesWhatTheScanHardlyShows) {
  EXPECT_THAT(visible_text(page()), HasSubstr("Hardly seen by the scan: roof."));
}

TEST_F(FitReport, WarningsStandAtTheTop) {
  io::FitReport report = small_fit();
  report.warnings = {"The rear < is not in the scan."};
  const std::string html = io::fit_report_page(report, small_pictures);
  const std::size_t at = html.find("<p class=\"warning\">The rear &lt; is not in the scan.</p>");
  EXPECT_LT(at, html.find("class=\"tiles\""));
}

TEST_F(FitReport, HasFiveMapsAndThreePairsOfPictures) {
  const std::regex picture("<img [^>]{0,200}src=\"data:image/png;base64,iVBOR");
  EXPECT_EQ(std::distance(std::sregex_iterator(page().begin(), page().end(), picture), {}), 11);
}

TEST_F(FitReport, HasTheUsualSectionsUnlessOthersAreChosen) {
  EXPECT_THAT(page(), HasSubstr("<h3>y = 0 mm</h3>"));
  EXPECT_THAT(page(), Not(HasSubstr("<h3>z = 700 mm</h3>")));
  io::FitReport report = small_fit();
  report.sections = {{2, 700.0}, {0, 90000.0}};
  const std::string other = io::fit_report_page(report, small_pictures);
  EXPECT_THAT(other, Not(HasSubstr("<h3>y = 0 mm</h3>")));
  EXPECT_THAT(other, HasSubstr("<h3>z = 700 mm</h3>"));
  EXPECT_THAT(other, HasSubstr("x = 90000 mm misses the body"));
}

TEST_F(FitReport, NeedsNothingFromElsewhere) {
  for (const char* reference : {"http://", "https://", "url(", "@import", "src=\"/", "<link"}) {
    EXPECT_THAT(without_namespaces(page()).find(reference), std::string::npos) << reference;
  }
}

TEST_F(FitReport, TheFileIsNotLarge) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "fit.html";
  io::write_fit_report(small_fit(), path, io::Overwrite::allowed);
  EXPECT_LT(std::filesystem::file_size(path), most_bytes);
}

TEST_F(FitReport, TheSameFitGivesTheSameBytes) {
  EXPECT_TRUE(page() == io::fit_report_page(small_fit(), small_pictures));
}

TEST_F(FitReport, WithoutAFitThereIsNeitherAStartNorARound) {
  io::FitReport report = small_fit();
  report.before.reset();
  report.history.clear();
  const std::string text = visible_text(io::fit_report_page(report, small_pictures));
  EXPECT_THAT(text, Not(HasSubstr("before")));
  EXPECT_THAT(text, Not(HasSubstr("round")));
  EXPECT_THAT(text, HasSubstr("deviation from a scan"));
}

TEST_F(FitReport, NumbersThatDoNotExistAreDashes) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  io::FitReport report = small_fit();
  report.distances = {nan, HUGE_VAL, nan, nan};
  report.faces[0].distances = {nan, nan, nan, nan};
  report.field.values.push_back(nan);
  report.history[1].distance = nan;
  report.points.push_back({{nan, 0.0, nan}, nan});
  const std::string page = io::fit_report_page(report, small_pictures);
  EXPECT_FALSE(std::regex_search(visible_text(page),
                                 std::regex("\\b(nan|inf|infinity)\\b", std::regex::icase)));
  EXPECT_THAT(page, Not(HasSubstr("=\"nan")));
  EXPECT_EQ(tag_error(page), "");
}

TEST_F(FitReport, HostileNamesAreText) {
  const std::string hostile = "<script>alert('x')</script>&\"";
  io::FitReport report = small_fit();
  report.title = report.words = report.status = report.command = hostile;
  report.faces[0].name = hostile;
  report.unseen_patches = report.folded_faces = {hostile};
  report.history[0].phase = hostile;
  const std::string page = io::fit_report_page(report, small_pictures);
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  EXPECT_EQ(tag_error(page), "");
}

io::FitReport outline_fit() {
  io::FitReport report;
  const io::FitReport with_scan = small_fit();
  report.title = "drawn";
  report.words = "Outlines in side.";
  report.scan = false;
  report.body = with_scan.body;
  report.before = with_scan.before;
  report.history = with_scan.history;
  report.outlines = {{"side",
                      0.4375,
                      2.125,
                      {{0.0, 0.0}, {5.0, 0.0}, {10.0, 3.0}},
                      {0.5, -9.0, 9.0},
                      {{{0.0, 0.0}, {4000.0, 0.0}, {4000.0, 1200.0}, {0.0, 0.0}}}}};
  report.lines = {{"windshield__roof", 0.0625, 0.25}};
  return report;
}

TEST(FitReportOfOutlines, ShowsThemAndNothingOfAScan) {
  const std::string page = io::fit_report_page(outline_fit(), small_pictures);
  EXPECT_EQ(tag_error(page), "");
  const std::string text = visible_text(page);
  for (const char* part : {"fit to outlines", "0.438 mm", "2.12", "windshield__roof", "0.0625"})
    EXPECT_THAT(text, HasSubstr(part));
  EXPECT_THAT(page, HasSubstr("aria-label=\"Outline from side\""));
  for (const char* part : {"Where the scan lies", "Face by face", "the scan"})
    EXPECT_THAT(text, Not(HasSubstr(part)));
}

TEST(FitReportOfOutlines, HasDotsInThreeColours) {
  // Near, inside and outside.
  const std::string page = io::fit_report_page(outline_fit(), small_pictures);
  const std::regex dots("<path class=\"dots\" stroke=\"(#[0-9a-f]{6})\"");
  EXPECT_EQ(std::distance(std::sregex_iterator(page.begin(), page.end(), dots), {}), 3);
}

TEST(FitReportOfOutlines, ComesBesideAScanToo) {
  io::FitReport report = small_fit();
  EXPECT_THAT(io::fit_report_page(report, small_pictures), Not(HasSubstr("id=\"outlines\"")));
  report.outlines = outline_fit().outlines;
  report.outlines[0].view = "<b>side</b>";
  const std::string page = io::fit_report_page(report, small_pictures);
  EXPECT_THAT(page, HasSubstr("id=\"outlines\""));
  EXPECT_THAT(page, Not(HasSubstr("<b>side")));
  EXPECT_EQ(tag_error(page), "");
}

}  // namespace
}  // namespace bodyline
