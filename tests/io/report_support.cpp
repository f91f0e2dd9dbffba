#include "report_support.hpp"

#include <filesystem>
#include <regex>
#include <vector>

#include "io/read_model.hpp"
#include "io/report_page.hpp"

namespace bodyline::tests {
namespace {

constexpr io::PictureSize small_pictures{192, 108};  // large enough for a legend

bool is_raw(const std::string& tag) { return tag == "script" || tag == "style"; }

}  // namespace

io::FairReport small_report() {
  io::FairReport report;
  report.title = "model1, tuned";
  report.status = "The search converged.";
  report.command = "bodyline fair cars/model1.toml -o tuned.toml --vary 'cut.*'";
  report.before = io::read_model(std::filesystem::path(BODYLINE_SOURCE_DIR) / "cars/model1.toml");
  report.after = report.before;
  for (model::Joint& joint : report.after.joints) {
    for (double& fullness : joint.fullness) fullness = 1.25;
  }
  report.terms = {{"bending", 1.0, 4935.0625, 97.53125}, {"fold (body)", 100.0, 0.71875, 0.0}};
  report.variables = {{"shape.hood.u[0]", 1.0, -3.5625, -12.0, 12.0},
                      {"cut.hood.u_lo", 0.05, 0.1, 0.01, 0.1},
                      {"fullness.hood__windshield.a", 1.5, 1.25, 0.3, 2.7}};
  report.history = {{1, 4935.0625, 812.5, 0.01}, {20, 97.53125, 0.03125, 0.5}};
  report.value_before = 5006.9375;
  report.value_after = 97.53125;
  report.evaluations = 23;
  report.seconds = 0.515625;
  return report;
}

std::string page_of(const io::FairReport& report) {
  return io::fair_report_page(report, small_pictures);
}

std::string tag_error(const std::string& page) {
  std::vector<std::string> open;
  std::size_t at = page.find("<html");
  while ((at = page.find('<', at)) != std::string::npos) {
    const std::size_t end = page.find('>', at);
    if (end == std::string::npos) return "a tag does not end";
    const bool closing = page[at + 1] == '/';
    const std::size_t name_at = at + (closing ? 2 : 1);
    const std::string name = page.substr(name_at, page.find_first_of(" \t\n/>", name_at) - name_at);
    if (name.empty() || !std::isalpha(static_cast<unsigned char>(name[0])))
      return "a stray < at " + page.substr(at, 40);
    if (closing) {
      if (open.empty() || open.back() != name)
        return "</" + name + "> closes " + (open.empty() ? "nothing" : open.back());
      open.pop_back();
    } else if (page[end - 1] != '/') {
      open.push_back(name);
    }
    at = !closing && is_raw(name) ? page.find("</" + name, end) : end + 1;
  }
  return open.empty() ? "" : "<" + open.back() + "> is not closed";
}

std::string visible_text(const std::string& page) {
  std::string text;
  std::size_t at = 0;
  const std::regex title("title=\"([^\"]*)\"");
  while (at < page.size()) {
    const std::size_t begin = page.find('<', at);
    text += page.substr(at, begin - at);
    if (begin == std::string::npos) break;
    const std::size_t end = page.find('>', begin);
    const std::string tag = page.substr(begin, std::min<std::size_t>(end - begin, 400));
    std::smatch match;
    if (std::regex_search(tag, match, title)) text += " " + match[1].str() + " ";
    text += " ";
    const std::string name = tag.substr(1, tag.find(' ') - 1);
    at = is_raw(name) ? page.find("</" + name, end) : end + 1;
  }
  return text;
}

std::string without_namespaces(std::string page) {
  const std::string name = "http://www.w3.org/1999/xhtml";
  for (std::size_t at; (at = page.find(name)) != std::string::npos;) page.erase(at, name.size());
  return page;
}

}  // namespace bodyline::tests
