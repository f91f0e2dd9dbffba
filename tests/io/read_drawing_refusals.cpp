#include "tests/io/drawing_support.hpp"

namespace bodyline {
namespace {

using testing::svg;

/// A file, and the sentence that reading it must end with; the sentence begins behind the name.
struct Refusal {
  std::string test, name, content, sentence;
};

void PrintTo(const Refusal& refusal, std::ostream* stream) { *stream << refusal.sentence; }

class DrawingRefused : public testing::DrawingFiles,
                       public ::testing::WithParamInterface<Refusal> {};

TEST_P(DrawingRefused, WithItsSentence) {
  EXPECT_EQ(refusal(GetParam().name, GetParam().content), GetParam().sentence);
}

std::string repeated(const std::string& text, int count) {
  std::string result;
  for (int k = 0; k < count; ++k) result += text;
  return result;
}

// Each element uses the one before ten times.
std::string doubling_uses() {
  std::string text = "<path id='u0' d='M 0 0 H 1'/>";
  for (int k = 1; k < 12; ++k) {
    const std::string use = "<use href='#u" + std::to_string(k - 1) + "'/>";
    text += "<g id='u" + std::to_string(k) + "'>" + repeated(use, 10) + "</g>\n";
  }
  return text;
}

std::string nested_groups() { return repeated("<g>", 5000) + repeated("</g>", 5000); }

const std::vector<Refusal> general{
    {"Extension", "a.dxf", "x",
     " is of no known format of drawings; those are .svg, .png, .csv and .txt."},
    {"Empty", "a.svg", "", " is empty."},
    {"NothingDrawn", "a.svg", svg("<text>words</text>"), " draws nothing."},
    {"AllHidden", "a.svg", svg("<path display='none' d='M 0 0 H 1'/>"), " draws nothing."},
    {"NoLength", "a.svg", svg("<path d='M 3 3'/><circle r='0'/>"), " draws nothing."},
};

const std::vector<Refusal> documents{
    {"NotXml", "a.svg", "<svg>\n<g>\n</svg>",
     "3: is not well-formed XML: Start-end tags mismatch."},
    {"CutOff", "a.svg", "<svg><path d='M 0 0",
     "1: is not well-formed XML: Error parsing element "
     "attribute."},
    {"NotSvg", "a.svg", "<html></html>", " is no SVG file: its outermost element is not svg."},
    {"Compressed", "a.svg", "\x1f\x8b\x08 x", " is compressed; save it as plain SVG."},
    {"Deep", "a.svg", svg(nested_groups()), "2: elements lie over 200 deep within each other."},
    {"UseOfItself", "a.svg", svg("<g id='a'><use href='#a'/></g>"),
     "2: elements lie over 200 deep within each other."},
    {"UseOfUses", "a.svg", svg(doubling_uses()), "2: there are over 262144 elements."},
    {"UseOfNothing", "a.svg", svg("\n<use id='u' href='#missing'/>"),
     "3: use \"u\": there is no element \"missing\"."},
    {"UseElsewhere", "a.svg", svg("<use href='other.svg#a'/>"),
     "2: use: it refers to nothing in this file."},
    {"UseOfViewBox", "a.svg",
     svg("<symbol id='s' viewBox='0 0 1 1'><path d='M 0 0 H 1'/></symbol><use href='#s'/>"),
     "2: use: it refers to a symbol with a viewBox, which is not read."},
    {"ViewBox", "a.svg", svg("<path d='M 0 0 H 1'/>", "width='1' viewBox='0 0 10'"),
     "1: svg: a number is missing at the end."},
    {"FlatViewBox", "a.svg", svg("<path d='M 0 0 H 1'/>", "width='1' viewBox='0 0 10 0'"),
     "1: svg: the viewBox takes x, y, width and height, the last two above 0."},
    {"NoWidth", "a.svg", svg("", "width='0' viewBox='0 0 1 1'"),
     "1: svg: the drawing has no width or no height."},
};

const std::vector<Refusal> elements{
    {"Word", "a.svg", svg("\n\n<path id='roof' d='M 1 2 L 3 four'/>"),
     "4: path \"roof\": a number is missing before \"four\"."},
    {"HalfPoint", "a.svg", svg("<path d='M 1 2 L 3'/>"),
     "2: path: a number is missing at the end."},
    {"NoMove", "a.svg", svg("<path d='L 3 4'/>"), "2: path: the path does not begin with M."},
    {"Command", "a.svg", svg("<path d='M 1 2 B 3 4'/>"), "2: path: \"B\" is no command of a path."},
    {"Nan", "a.svg", svg("<path d='M 1 2 L nan 4'/>"),
     "2: path: a number is missing before \"nan 4\"."},
    {"SignedNan", "a.svg", svg("<path d='M 1 2 L -inf 4'/>"),
     "2: path: a number is missing before \"-inf 4\"."},
    {"TooLarge", "a.svg", svg("<path d='M 1 2 L 1e999 4'/>"),
     "2: path: \"1e999 4\" begins with a number out of range."},
    {"Flag", "a.svg", svg("<path d='M 0 0 A 1 1 0 2 0 3 3'/>"),
     "2: path: a flag of an arc is neither 0 nor 1 at \"2 0 3 3\"."},
    {"Far", "a.svg", svg("<path d='M 0 0 L 2e9 0'/>"),
     "2: path: it is drawn beyond all bounds, at coordinates over 1e9."},
    {"FarByTransform", "a.svg", svg("<g transform='scale(1e300)'><path d='M 0 0 H 1e300'/></g>"),
     "2: path: it is drawn beyond all bounds, at coordinates over 1e9."},
    {"FarArc", "a.svg", svg("<path d='M 0 0 A 1e-300 1e300 0 0 1 5 5'/>"),
     "2: path: it is drawn beyond all bounds, at coordinates over 1e9."},
    {"Transform", "a.svg", svg("<g id='a' transform='turn(3)'/>"),
     "2: g \"a\": \"turn\" with 1 numbers is no transform."},
    {"TransformCount", "a.svg", svg("<g transform='rotate(3 4)'/>"),
     "2: g: \"rotate\" with 2 numbers is no transform."},
    {"TransformOpen", "a.svg", svg("<g transform='rotate 3'/>"),
     "2: g: the transform lacks a '(' before \"\"."},
    {"TransformClose", "a.svg", svg("<g transform='rotate(3'/>"),
     "2: g: the transform lacks a ')' after \"rotate\"."},
    {"TransformOrigin", "a.svg", svg("<g style='transform-origin: 3px 4px'/>"),
     "2: g: transform-origin is not read; use the attribute transform alone."},
    {"Percent", "a.svg", svg("<rect width='50%' height='3'/>"),
     "2: rect: \"50%\" is no length that can be read: a number with mm, cm, in, pt, pc, px or no "
     "unit."},
    {"Points", "a.svg", svg("<polyline points='1 2 3'/>"),
     "2: polyline: a number is missing at the end."},
};

const std::vector<Refusal> polylines{
    {"CsvWord", "a.csv", "1,2\nthree,4\n",
     "2: \"three,4\" is no point: it takes two numbers x y and may have a name."},
    {"CsvTwoHeadings", "a.csv", "x,y\nmm,mm\n1,2\n",
     "2: \"mm,mm\" is no point: it takes two numbers x y and may have a name."},
    {"CsvOneNumber", "a.csv", "1,2\n3\n",
     "2: \"3\" is no point: it takes two numbers x y and may have a name."},
    {"CsvNan", "a.csv", "1,2\nnan,4\n", "2: coordinates are finite numbers up to 1e9."},
    {"CsvHuge", "a.csv", "1,2\n1e999,4\n", "2: coordinates are finite numbers up to 1e9."},
    {"CsvOnePoint", "a.csv", "1,2\n2,3\n\n4,5\n4,5\n\n1,2\n",
     "4: begins a line of a single point; a line takes two or more."},
    {"CsvNothing", "a.csv", "x,y\n", " draws nothing."},
};

const auto name_of = [](const auto& test) { return test.param.test; };
INSTANTIATE_TEST_SUITE_P(General, DrawingRefused, ::testing::ValuesIn(general), name_of);
INSTANTIATE_TEST_SUITE_P(Documents, DrawingRefused, ::testing::ValuesIn(documents), name_of);
INSTANTIATE_TEST_SUITE_P(Elements, DrawingRefused, ::testing::ValuesIn(elements), name_of);
INSTANTIATE_TEST_SUITE_P(Polylines, DrawingRefused, ::testing::ValuesIn(polylines), name_of);

}  // namespace
}  // namespace bodyline
