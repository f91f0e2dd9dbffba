#include "tests/io/scan_support.hpp"

namespace bodyline {
namespace {

using testing::bytes_of;
using testing::face;
using testing::lines;
using testing::pcd;
using testing::ply;

/// A file, and the sentence that reading it must end with; the sentence begins behind the name.
struct Refusal {
  std::string test, name, content, sentence;
};

void PrintTo(const Refusal& refusal, std::ostream* stream) { *stream << refusal.sentence; }

class ScanRefused : public testing::ScanFiles, public ::testing::WithParamInterface<Refusal> {};

TEST_P(ScanRefused, WithItsSentence) {
  EXPECT_EQ(refusal(GetParam().name, GetParam().content), GetParam().sentence);
}

const std::vector<Refusal> general{
    {"Extension", "a.las", "x",
     " is of no known format of scans; those are .ply, .stl, .obj, .gltf, .glb, .off, .xyz, .pts, "
     ".asc, .txt, .csv, .pcd."},
    {"Empty", "a.ply", "", " is empty."},
    {"EmptyMesh", "a.stl", "", " is empty."},
    {"TwoPoints", "a.xyz", lines(2),
     " holds 2 usable points, too few for a scan; it takes 100 or more."},
    {"NotFinite", "a.xyz", "nan 1 2\n1 inf 2\n1 2 1e999\n1e13 0 0\n",
     " none of its 4 points can be used: their coordinates are not finite or beyond 1e12."},
    {"Binary", "a.xyz", "1 2 3\n" + std::string(3000, '\1'),
     "2: \"" + std::string(40, '?') + "...\" is no point: it takes three numbers x y z."},
    {"LongLine", "a.xyz", std::string(3 << 20, '1'),
     " holds a line of over 1 MiB, so it is not text."},
};

const std::vector<Refusal> text_files{
    {"TwoNumbers", "a.xyz", "1 2 3\n1 2\n",
     "2: \"1 2\" is no point: it takes three numbers x y z."},
    {"Word", "a.xyz", "1 2 3\n1 two 3\n",
     "2: \"1 two 3\" is no point: it takes three numbers x y z."},
    {"TwoHeadings", "a.csv", "x,y,z\nmm,mm,mm\n1,2,3\n",
     "2: \"mm,mm,mm\" is no point: it takes three numbers x y z."},
    {"UnclearComma", "a.xyz", "1 2 3\n12,34 5\n",
     "2: \"12,34 5\" has commas that may be decimal or part numbers, or are not what they are in "
     "lines before; write decimal points."},
    {"OtherCommas", "a.xyz", "1,5 2,5 3,5\n1,2,3\n",
     "2: \"1,2,3\" has commas that may be decimal or part numbers, or are not what they are in "
     "lines before; write decimal points."},
    {"PtsCutOff", "a.pts", "200\n" + lines(150),
     " is cut off: it announces 200 points but holds 150."},
};

const std::vector<Refusal> ply_heads{
    {"NotPly", "a.ply", "solid x\n", " is not a PLY file: its first line is not \"ply\"."},
    {"PlyNoEnd", "a.ply", "ply\nformat ascii 1.0\n",
     " its head does not end: there is no line \"end_header\"."},
    {"PlyFormat", "a.ply", "ply\nformat morse 1.0\n",
     "2: \"morse\" is not a format of PLY files; those are ascii, binary_little_endian and "
     "binary_big_endian."},
    {"PlyCount", "a.ply", ply("-5"),
     "3: an element needs a name and a count, but the count is \"-5\"."},
    {"PlyType", "a.ply", "ply\nelement vertex 1\nproperty quad x\n",
     "3: \"quad\" is not a type of numbers in a PLY file."},
    {"PlyKeyword", "a.ply", "ply\nelements 3\n",
     "2: \"elements\" is not known in the head of a PLY file."},
    {"PlyProperty", "a.ply", "ply\nproperty float x\n", "2: a property stands before any element."},
    {"PlyNoVertex", "a.ply", "ply\nformat ascii 1.0\nend_header\n", " has no element \"vertex\"."},
    {"PlyNoZ", "a.ply", "ply\nelement vertex 1\nproperty int x\nproperty int y\nend_header\n",
     " its vertices have no property \"z\"."},
    {"PlyNoProperties", "a.ply",
     ply("0", "element edge 4000000000000000\n", "binary_little_endian"),
     " its element \"edge\" has no properties."},
};

const std::vector<Refusal> ply_bodies{
    {"PlyCutOff", "a.ply", ply("500") + lines(312),
     " is cut off: it ends after 312 of 500 elements \"vertex\"."},
    {"PlyHugeCount", "a.ply", ply("4000000000000000", "", "binary_big_endian") + lines(100),
     " is cut off: it ends after " + std::to_string(lines(100).size() / 12) +
         " of 4000000000000000 elements \"vertex\"."},
    {"PlyHugeMesh", "a.ply", ply("4000000000000000", face) + lines(100),
     " is cut off: it ends after 100 of 4000000000000000 elements \"vertex\"."},
    {"PlyHugeList", "a.ply",
     ply("1", "element face 1\nproperty list uint char vertex_index\n", "binary_little_endian") +
         std::string(12, '\0') + "\xff\xff\xff\xff" + std::string(100, '\0'),
     " is cut off: it ends after 0 of 1 elements \"face\"."},
    {"PlyFewNumbers", "a.ply", ply("2") + "1 2 3\n4 5\n",
     "9: holds fewer numbers than \"vertex\" has."},
    {"PlyWord", "a.ply", ply("2") + "1 2 3\n4 five 6\n", "9: \"five\" is not a number."},
    {"PlyIndex", "a.ply", ply("3", face) + lines(3) + "3 0 1 3\n",
     "13: a face uses vertex 3, but there are 3, counted from 0."},
    {"PlyNegativeIndex", "a.ply", ply("3", face) + lines(3) + "3 0 -1 2\n",
     "13: a face uses vertex -1, but there are 3, counted from 0."},
    {"PlyBinaryIndex", "a.ply",
     ply("3", face, "binary_little_endian") + std::string(36, '\0') + "\3" +
         bytes_of<std::int32_t>(7),
     " at byte " + std::to_string(ply("3", face, "binary_little_endian").size() + 36 + 1 + 4) +
         ": a face uses vertex 7, but there are 3, counted from 0."},
    {"PlyListLength", "a.ply", ply("3", face) + lines(3) + "-3 0 1 2\n",
     "13: a list cannot have the length -3."},
    {"PlyFlatMesh", "a.ply", ply("3", face) + "0 0 0\n1 1 1\n2 2 2\n3 0 1 2\n",
     " is a mesh of 1 triangles without any area."},
};

const std::vector<Refusal> pcd_files{
    {"NotPcd", "a.pcd", "ply\n", "1: is not a PCD file: it does not begin with VERSION or FIELDS."},
    {"PcdNoData", "a.pcd", "VERSION .7\nFIELDS x y z\n",
     " its head does not end: there is no line DATA."},
    {"PcdNoFields", "a.pcd", "VERSION .7\nDATA ascii\n", " its head has no line FIELDS."},
    {"PcdNoZ", "a.pcd", "FIELDS x y\nSIZE 4 4\nTYPE F F\nPOINTS 1\nDATA ascii\n",
     " its points have no field \"z\"."},
    {"PcdSize", "a.pcd", "FIELDS x y z\nSIZE 4 4\nTYPE F F F\nDATA ascii\n",
     " its head needs a whole number as entry 3 of SIZE."},
    {"PcdType", "a.pcd", "FIELDS x y z\nSIZE 4 4 3\nTYPE F F F\nDATA ascii\n",
     " its head gives no usable TYPE and SIZE for field 3."},
    {"PcdHugePoint", "a.pcd",
     "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 4000000000\nDATA ascii\n",
     " its points are larger than 64 KiB."},
    {"PcdData", "a.pcd", pcd("1", "morse"),
     "9: \"morse\" is not a kind of DATA; those are ascii, binary and binary_compressed."},
    {"PcdCutOff", "a.pcd", pcd("4000000000000000", "binary") + std::string(1201, '\0'),
     " is cut off: it ends after 100 of 4000000000000000 points."},
    {"PcdCutOffText", "a.pcd", pcd("200") + lines(150),
     " is cut off: it ends after 150 of 200 points."},
    {"PcdFewNumbers", "a.pcd", pcd("2") + "1 2 3\n1 2\n",
     "11: holds 2 numbers, too few for a point."},
    {"PcdWord", "a.pcd", pcd("1") + "1 two 3\n", "10: \"two\" is not a number."},
    {"PcdSizes", "a.pcd",
     pcd("9", "binary_compressed") + bytes_of<std::uint32_t>(3) + bytes_of<std::uint32_t>(12),
     " unpacks to 12 bytes, but its head announces 9 points of 12 bytes."},
    {"PcdPacked", "a.pcd",
     pcd("1", "binary_compressed") + bytes_of<std::uint32_t>(9) + bytes_of<std::uint32_t>(12),
     " is cut off: it ends within its compressed points."},
    {"PcdDamaged", "a.pcd",
     pcd("1", "binary_compressed") + bytes_of<std::uint32_t>(2) + bytes_of<std::uint32_t>(12) +
         "\xe0\xe0",
     " its compressed points are damaged."},
    {"PcdHuge", "a.pcd",
     pcd("1", "binary_compressed") + bytes_of<std::uint32_t>(2) + bytes_of(0xf0000000U),
     " is too large for a compressed file; save it as binary."},
};

const std::vector<Refusal> meshes{
    {"StlNoEnd", "a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n",
     "5: is cut off: an STL file in ASCII ends with \"endsolid\"."},
    {"StlLoop", "a.stl", "solid a\nouter loop\nvertex 0 0 0\nendloop\n",
     "4: a loop ends that does not have three vertices."},
    {"StlWord", "a.stl", "solid a\nouter loop\nvertex 0 zero 0\n",
     "3: \"zero\" is not a coordinate of a vertex."},
    {"StlKeyword", "a.stl", "solid a\nquad\n", "2: \"quad\" is not known in an STL file."},
    {"StlShort", "a.stl", "facet", " is cut off: an STL file has 84 bytes or more."},
    {"StlHuge", "a.stl", std::string(80, ' ') + "\xff\xff\xff\xff" + std::string(120, '\0'),
     " is cut off: it ends after 2 of 4294967295 triangles."},
    {"NotOff", "a.off", "# nothing\n", " is not an OFF file: there is nothing in it."},
    {"OffCounts", "a.off", "OFF BINARY\n3 1 0\n",
     "1: is not an OFF file in text: there are no counts of vertices and faces."},
    {"OffNoCounts", "a.off", "OFF\n", " is cut off: it has no counts."},
    {"OffHuge", "a.off", "OFF\n4000000000 4000000000 0\n0 0 0\n",
     "2: announces more than 20000000 vertices or faces."},
    {"OffCutOff", "a.off", "OFF 20000000 0 0\n0 0 0\n",
     " is cut off: it ends after 1 of 20000000 vertices."},
    {"OffNoFaces", "a.off", "OFF\n1 1 0\n0 0 0\n", " is cut off: it ends after 0 of 1 faces."},
    {"OffWord", "a.off", "OFF\n1 0 0\n0 o 0\n", "3: \"o\" is not a coordinate of a vertex."},
    {"OffIndex", "a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n",
     "6: a face uses vertex \"9\", but there are 3, counted from 0."},
    {"OffFaceLength", "a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n",
     "6: a face does not begin with the number of its vertices."},
    {"OffFewIndices", "a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n",
     "6: a face uses vertex \"\", but there are 3, counted from 0."},
    {"NotGlb", "a.glb", std::string(30, 'x'),
     " is not a GLB file: it does not begin with \"glTF\"."},
    {"GlbCutOff", "a.glb", "glTF" + std::string(8, '\0') + bytes_of(0xffffffffU) + "JSON",
     " is cut off: it lacks 4294967295 bytes."},
    {"GltfArray", "a.gltf", "[1, 2]", " is not a glTF file: its JSON is no object."},
    {"Gltf1", "a.gltf", "{\"nodes\": {}}", " its nodes are no array, as glTF 2.0 wants them."},
    {"ObjWithout", "a.obj", "# none\n", " cannot be read as OBJ: OBJ-file is too small."},
};

const auto name_of = [](const auto& test) { return test.param.test; };
INSTANTIATE_TEST_SUITE_P(General, ScanRefused, ::testing::ValuesIn(general), name_of);
INSTANTIATE_TEST_SUITE_P(Text, ScanRefused, ::testing::ValuesIn(text_files), name_of);
INSTANTIATE_TEST_SUITE_P(PlyHead, ScanRefused, ::testing::ValuesIn(ply_heads), name_of);
INSTANTIATE_TEST_SUITE_P(PlyBody, ScanRefused, ::testing::ValuesIn(ply_bodies), name_of);
INSTANTIATE_TEST_SUITE_P(Pcd, ScanRefused, ::testing::ValuesIn(pcd_files), name_of);
INSTANTIATE_TEST_SUITE_P(Mesh, ScanRefused, ::testing::ValuesIn(meshes), name_of);

}  // namespace
}  // namespace bodyline
