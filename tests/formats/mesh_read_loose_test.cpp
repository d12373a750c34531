#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/formats/read.h"
#include "snug/formats/read_cloud.h"
#include "snug/words/words.h"

#include "tests/support/random.h"
#include "tests/support/read_checks.h"

// Text files as programs write them, whatever their format's description says.

namespace snug {
namespace {

using test::area;
using test::ascii_ply;
using test::bytes_of;
using test::expect_holds;
using test::good;
using test::Random;
using test::refused;
using test::square_obj;
using test::utf16;

/// Two facets, a unit square together.
const std::vector<std::string> kStlWords{"facet",  "normal", "0", "0", "1",      "outer",   "loop",
                                         "vertex", "0",      "0", "0", "vertex", "1",       "0",
                                         "0",      "vertex", "1", "1", "0",      "endloop", "endfacet",
                                         "facet",  "normal", "0", "0", "1",      "outer",   "loop",
                                         "vertex", "0",      "0", "0", "vertex", "1",       "1",
                                         "0",      "vertex", "0", "1", "0",      "endloop", "endfacet"};

void expect_square(const std::string& file, bool no_end = false) {
    SCOPED_TRACE(file);
    const Mesh mesh = good(read_mesh(bytes_of(file), "a.stl"));
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.vertices.size(), 4u);
    EXPECT_DOUBLE_EQ(area(mesh), 1);
    EXPECT_EQ(mesh.read.no_end, no_end);
    EXPECT_EQ(mesh.read.left_out_faces, 0u);
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
    std::string text;
    for (const std::string& word : words) text += word + between;
    return text;
}

TEST(ReadLoose, AnAsciiStlMayBreakItsLinesAnywhere) {
    expect_square("solid a " + joined(kStlWords, " ") + "endsolid a");
    expect_square("solid " + joined(kStlWords, " ") + "endsolid");
    expect_square("solid a\n" + joined(kStlWords, "\n") + "endsolid a\n");
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        std::string text = "solid a\n";
        for (const std::string& word : kStlWords) {
            std::string shown = word;
            if (random.chance(0.3))
                for (char& c : shown) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
            if (word.substr(0, 3) == "end" && random.chance(0.5))
                shown.insert(3, random.chance(0.5) ? " " : "\t");
            const char* breaks[] = {" ", "\n", "\r\n", "\r", "\t ", "  \n\n"};
            // "end" and its second word stand in one line.
            text += shown + breaks[random.integer(0, 5)];
        }
        expect_square(text + "endsolid a\n");
    }
}

TEST(ReadLoose, NamesOfSolidsMayHoldAnyWords) {
    const std::string facets = "\n" + joined(kStlWords, "\n");
    for (const char* name :
         {"facet", "facet normal", "facet normal 1 2 3", "vertex 1 2 3", "facet normal vertex 1 2 3",
          "outer loop", "outer loop vertex", "endloop", "B\xfcste", "\xe7\x8a\xac", "solid", "a endsolid",
          "# not a comment", "  DEFORM-3D STL FILE    ", "color 1 2 3"})
        expect_square("solid " + std::string(name) + facets + "endsolid " + name + "\n");
}

TEST(ReadLoose, SeveralSolidsInOneLineAreOneMesh) {
    const std::string one = "solid a b " + joined(kStlWords, " ") + "endsolid a b ";
    const Mesh mesh = good(read_stl(bytes_of(one + one + one)));
    EXPECT_EQ(mesh.triangles.size(), 6u);
    EXPECT_FALSE(mesh.read.no_end);
}

TEST(ReadLoose, WhatProgramsAddToAnAsciiStlIsPassedOver) {
    const std::string facets = joined(kStlWords, "\n"), end = "endsolid a\n";
    for (const char* before : {"# by a scanner\n", "; by a scanner\n# solid b\n", "// facet normal 0 0 1\n\n",
                               "\xef\xbb\xbf", "\n \n"})
        expect_square(before + ("solid a\n" + facets) + end);
    expect_square("solid a\ncolor 0.5 0.5 0.5\n" + facets + end);
    expect_square("solid a\n" + facets + end + "\x1a");
    expect_square("solid a\n" + facets + end + "\x1a" + std::string(40, '\0'));
    expect_square("solid a\n" + facets + "attribute 7\nCOLOR 1 0 0\n" + end);
    expect_square("solid a\n" + facets, true);
    expect_square(facets, true);
    std::string with_colours, without_facets, without_loops, far_normals = facets;
    for (std::size_t i = 0; i < kStlWords.size(); ++i) {
        const std::string& word = kStlWords[i];
        with_colours += (word == "vertex" ? "color 1 0 0 0.5\n" : "") + word + " ";
        const bool of_loop = word == "outer" || word == "loop" || word == "endloop";
        const bool of_normal = i % 21 < 5 && i < 42;
        if (!of_loop) without_loops += word + " ";
        if (!of_normal && word != "endfacet") without_facets += word + "\n";
    }
    expect_square("solid a\n" + with_colours + end);
    expect_square("solid a\n" + without_facets + end);
    expect_square("solid a\n" + without_loops + "\n" + end);
    for (const char* none : {"nan", "-nan(ind)", "1.#QNAN", "1e999"}) {
        std::string text = "solid a\n" + facets + end;
        for (std::size_t at = 0; (at = text.find("normal\n0", at)) != std::string::npos;)
            text.replace(at + 7, 1, none);
        expect_square(text);
    }
}

TEST(ReadLoose, FacetsWithoutThreeVerticesAreLeftOut) {
    const std::string facets = joined(kStlWords, "\n");
    for (const char* bad :
         {"facet normal 0 0 1\nouter loop\nvertex 1 2 3\nvertex 2 3 4\nendloop\nendfacet\n",
          "facet normal 0 0 1\nouter loop\nendloop\nendfacet\n", "facet normal 0 0 1\nendfacet\n",
          "facet normal 0 0 1\nouter loop\nvertex 1 2 3\n"}) {
        SCOPED_TRACE(bad);
        const Mesh mesh = good(read_stl(bytes_of("solid a\n" + std::string(bad) + facets + "endsolid\n")));
        EXPECT_EQ(mesh.triangles.size(), 2u);
        EXPECT_EQ(mesh.read.left_out_faces, 1u);
        EXPECT_EQ(mesh.read.faces, 3u);
    }
}

TEST(ReadLoose, WhatIsNoStlIsToldByWhatItLooksLike) {
    const std::string filler(200, 'x');
    for (const auto& [text, words] : std::vector<std::pair<std::string, std::string>>{
             {"<!DOCTYPE html><html>", "a web page"},
             {"\n <HTML><body>", "a web page"},
             {"<?xml version=\"1.0\"?>\n<!-- c -->\n<COLLADA>", "COLLADA"},
             {"<?xml version=\"1.0\"?><thing>", "an XML file"},
             {"{\"message\": \"Not Found\"}", "JSON"},
             {"version https://git-lfs.github.com/spec/v1\noid sha256:", "Git LFS"},
             {"\x1f\x8b\x08", "gzip"},
             {"\x89PNG\r\n", "picture"},
             {"%PDF-1.7", "PDF"},
             {"difference() { cube(10); }\n", "begins with \"difference() { cube(10); }\""},
             {"  \nDear diary,\n", "begins with \"Dear diary,\""},
             {"404: Not Found", "this is text but no STL"}}) {
        SCOPED_TRACE(text);
        for (const std::string& file : {text, text + filler}) {
            const std::string sentence = refused(file, "a.stl");
            if (words.substr(0, 6) != "begins" || file == text) expect_holds(sentence, words);
            EXPECT_EQ(sentence.find("triangles"), std::string::npos) << sentence;
        }
    }
}

TEST(ReadLoose, TextsInUtf16AreReadAsTheSameInUtf8) {
    const std::string obj = square_obj("f 1 2 3 4\n");
    const std::string off = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";
    const std::string stl = "solid B\xfcste\n" + joined(kStlWords, "\n") + "endsolid\n";
    const std::string ply = ascii_ply(4, 1, "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
    for (const std::string& text : {obj, off, stl, ply})
        for (const bool big : {false, true})
            for (const bool mark : {false, true}) {
                SCOPED_TRACE(text);
                EXPECT_DOUBLE_EQ(area(good(read_mesh(bytes_of(utf16(text, big, mark)), "a.stl"))), 1);
                const std::string xyz = utf16("1 2 3\r\n4 5 6\r\n", big, mark);
                EXPECT_EQ(good(read_mesh_or_cloud(bytes_of(xyz), "a.xyz")).vertices.size(), 2u);
            }
    // Half a letter at the end, and a letter beyond 16 bits in a comment.
    std::string odd = utf16("# ", false, true) + "\x3d\xd8\x15\xdd" + utf16("\n" + obj, false, false) + "\n";
    EXPECT_DOUBLE_EQ(area(good(read_mesh(bytes_of(odd), ""))), 1);
}

TEST(ReadLoose, FacesOfAPlyUnderOtherNames) {
    const auto file = [](const std::string& faces, const std::string& row) {
        std::string text = ascii_ply(4, 1, "0 0 0\n1 0 0\n1 1 0\n0 1 0\n" + row + "\n");
        const std::size_t begin = text.find("element face");
        return text.replace(begin, text.find("end_header") - begin, faces);
    };
    const auto list = [&](const std::string& element, const std::string& name) {
        return file("element " + element + " 1\nproperty list uchar int " + name + "\n", "4 0 1 2 3");
    };
    for (const std::string& text :
         {list("face", "vertex_indices"), list("face", "vertex_indexes"), list("face", "vertexIndices"),
          list("face", "vertices"), list("face", "indices"), list("face", "verts"),
          list("faces", "vertex_index"), list("polygon", "corners"), list("face", "f"),
          file("element face 1\nproperty list uchar float texcoord\nproperty list uchar int tex_ids\n"
               "property list uchar int ids\n",
               "1 0.5 2 7 8 4 0 1 2 3"),
          file("element face 1\nproperty uchar red\nproperty int v1\nproperty int v2\nproperty int v3\n"
               "property int v4\n",
               "200 0 1 2 3")}) {
        SCOPED_TRACE(text);
        EXPECT_DOUBLE_EQ(area(good(read_mesh(bytes_of(text), ""))), 1);
    }
    for (const char* names :
         {"a b c", "v0 v1 v2", "vertex1 vertex2 vertex3", "vertex_0 vertex_1 vertex_2", "i j k"}) {
        std::string properties = "element face 1\n", word;
        for (const char c : std::string(names) + " ") {
            if (c != ' ') {
                word += c;
                continue;
            }
            properties += "property int " + word + "\n";
            word.clear();
        }
        EXPECT_DOUBLE_EQ(area(good(read_mesh(bytes_of(file(properties, "0 1 2")), ""))), 0.5) << names;
    }
    std::string capitals = list("face", "vertex_index");
    for (const char* axis : {"float x", "float y", "float z"}) {
        char& letter = capitals[capitals.find(axis) + 6];
        letter = static_cast<char>(letter - 'a' + 'A');
    }
    EXPECT_DOUBLE_EQ(area(good(read_mesh(bytes_of(capitals), ""))), 1);
}

TEST(ReadLoose, APlyMayHaveUnknownHeaderLinesAndCommentsInItsBody) {
    std::string text = ascii_ply(4, 1,
                                 "comment points\n0 0 0\n# c\n1 0 0\n1 1 0 # here\nobj_info o\n0 1 "
                                 "0\ncomment f\n4 0 1 2 3\ncomment end\n");
    text.insert(text.find("element vertex"), "Created by Blender3D 247 - www.blender.org\nmodel 7\n");
    EXPECT_DOUBLE_EQ(area(good(read_mesh(bytes_of(text), ""))), 1);
}

TEST(ReadLoose, APlyMayHaveMoreInItsLinesThanItDeclares) {
    const std::string vertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
    for (const char* data : {"0 0 0 9 9 9\n1 0 0 9 9 9\n1 1 0 9 9 9\n0 1 0 9 9 9\n4 0 1 2 3\n",
                             "0 0 0\n1 0 0\n1 1 0 7\n0 1 0\n4 0 1 2 3 255 0 0\n",
                             "0 0 0 red\n1 0 0 blue\n\n1 1 0 c\ncomment so\n0 1 0 d\n4 0 1 2 3 e f\n",
                             "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 1 1 1\n7 7 7\n"}) {
        SCOPED_TRACE(data);
        EXPECT_DOUBLE_EQ(area(good(read_mesh(bytes_of(ascii_ply(4, 1, data)), ""))), 1);
    }
    for (const char* wrapped :
         {"0 0 0 1 0 0\n1 1 0 0 1 0 4 0 1 2 3\n", "0\n0\n0\n1 0 0 1\n1 0\n0 1 0\n4 0\n1 2 3",
          "0 0 0 1 0 0 1 1 0 0 1 0 4 0 1 2 3"}) {
        SCOPED_TRACE(wrapped);
        EXPECT_DOUBLE_EQ(area(good(read_mesh(bytes_of(ascii_ply(4, 1, wrapped)), ""))), 1);
    }
}

TEST(ReadLoose, RandomLineBreaksDoNotChangeAPlyOrAnOff) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        std::string plain, data;
        for (int v = 0; v < 6; ++v)
            for (int axis = 0; axis < 3; ++axis) plain += std::to_string(random.integer(-9, 99)) + " ";
        plain += "3 0 1 2 4 2 3 4 5 3 5 4 0 ";
        for (const char c : plain) data += c == ' ' && random.chance(0.4) ? '\n' : c;
        const Mesh whole = good(read_ply(bytes_of(ascii_ply(6, 3, plain))));
        const Mesh broken = good(read_ply(bytes_of(ascii_ply(6, 3, data))));
        EXPECT_EQ(broken.vertices, whole.vertices);
        EXPECT_EQ(broken.triangles, whole.triangles);
        const Mesh off = good(read_off(bytes_of("OFF\n6 3 0\n" + data)));
        EXPECT_EQ(off.vertices, whole.vertices) << data;
        EXPECT_EQ(off.triangles, whole.triangles);
    }
}

TEST(ReadLoose, OffWithCountsGluedToItsWordOrInOneLineOrWithoutItsWord) {
    const std::string vertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n", face = "4 0 1 2 3";
    for (const std::string& text :
         {"OFF4 1 0\n" + vertices + face,
          "\t  OFF4 1 12 # or so\n\n" + vertices + "# c\n" + face + " 1.0 0.5 0.5\n",
          "off\n4 1 0\n" + vertices + face,
          "coff 4 1 0\n0 0 0 1 1 1 1\n1 0 0 1 1 1 1\n1 1 0 1 1 1 1\n0 1 0 1 1 1 1\n" + face,
          "OFF 4 1 0 0 0 0 1 0 0 1 1 0 0 1 0 " + face,
          "OFF\n4 1 0\n0 0 0 1 0 0\n1 1 0 0 1 0\n" + face + " 7 7 7\n",
          "NOFF 4 1 0 0 0 0 5 5 5 1 0 0 5 5 5 1 1 0 5 5 5 0 1 0 5 5 5 " + face,
          "OFF 4 1 0 # a\n0 0 0 # b\n1 0 0 # c\n1 1 0 # d\n0 1 0 # e\n" + face + " # f\n"}) {
        SCOPED_TRACE(text);
        EXPECT_DOUBLE_EQ(area(good(read_mesh(bytes_of(text), "a.off"))), 1);
    }
    EXPECT_DOUBLE_EQ(area(good(read_mesh(bytes_of("4 1 0\n" + vertices + face), "a.off"))), 1);
    for (const char* word : {"4OFF", "nOFF", "C4nOFF", "STN4OFF"})
        expect_holds(refused(std::string(word) + "\n3 1 0\n0 0 0 1\n", "a.off"),
                     "\"" + std::string(word) + "\" is no kind");
    expect_holds(refused("OFF\n4 1 0\n" + vertices + "4 0 1 2 9\n"), "line 7: \"9\" is no vertex");
}

TEST(ReadLoose, AnObjOfVerticesAloneIsACloudAndOneOfLinesIsNot) {
    EXPECT_EQ(good(read_mesh_or_cloud(bytes_of("v 1 2 3\nv 4 5 6 255 0 0\n"), "")).vertices.size(), 2u);
    EXPECT_EQ(
        good(read_mesh_or_cloud(bytes_of("o a\nv 1 2 3\nvn 0 0 1\nv 4 5 6\np 1 2\n"), "")).vertices.size(),
        2u);
    for (const char* curves : {"l 1 2\n", "curv 0 1 1 2\n", "surf 0 1 0 1 1 2\n"}) {
        const auto mesh = read_mesh_or_cloud(bytes_of("v 1 2 3\nv 4 5 6\n" + std::string(curves)), "");
        ASSERT_FALSE(mesh);
        expect_holds(snug::text(mesh.error().message), "no faces");
    }
}

}  // namespace
}  // namespace snug
