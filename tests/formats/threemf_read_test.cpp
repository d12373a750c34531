#include "snug/formats/threemf_read.h"

#include <string>

#include <gtest/gtest.h>

#include "snug/fabricate/printing/threemf.h"
#include "snug/mesh/measure.h"
#include "snug/words/words.h"

#include "cli/inflate.h"
#include "tests/support/random.h"
#include "tests/support/read_checks.h"
#include "tests/support/threemf_builder.h"

namespace snug::test {
namespace {

Result<Mesh> read(const std::string& file) {
    SceneTools tools;
    tools.inflate = cli::inflate;
    return read_3mf(bytes_of(file), tools);
}

Vec3d extent_of(const Mesh& mesh) {
    return bounds(mesh).size();
}

/// Box of a mesh at its true place.
Box3d box_of(const Mesh& mesh) {
    Box3d box;
    for (const Vec3f& v : mesh.vertices) box.include(vec_cast<double>(v) + mesh.origin);
    return box;
}

double volume_of(const Mesh& mesh) {
    double six = 0;
    for (const Triangle& t : mesh.triangles) {
        const auto at = [&](int i) {
            return vec_cast<double>(mesh.vertices[t[static_cast<std::size_t>(i)]]);
        };
        six += dot(at(0), cross(at(1), at(2)));
    }
    return six / 6;
}

void expect_box(const Mesh& mesh, Vec3d low, Vec3d high) {
    const Box3d box = box_of(mesh);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(box.min[axis], low[axis], 1e-4) << axis;
        EXPECT_NEAR(box.max[axis], high[axis], 1e-4) << axis;
    }
}

std::string sentence(const std::string& file) {
    const auto mesh = read(file);
    EXPECT_FALSE(mesh.has_value());
    return mesh ? "" : snug::text(mesh.error().message);
}

std::string with_body(const std::string& body, const std::string& build = "<item objectid=\"1\"/>") {
    return threemf_of(model_of(body, build));
}

TEST(ThreeMfRead, WhatOurWriterWritesComesBack) {
    const Mesh shape = tetrahedron();
    Solid solid;
    solid.vertices = shape.vertices;
    solid.triangles = shape.triangles;
    const ThreeMfItem items[] = {{"one & two", kLowerBlue, &solid, {0, 0, 0}},
                                 {"two", kUpperOrange, &solid, {100, 0, 0}}};
    const PackContainer container = three_mf("a.3mf", "title", items);
    std::vector<ZipPart> parts;
    for (const PackFile& member : container.members)
        parts.push_back(
            {member.name, {reinterpret_cast<const char*>(member.bytes.data()), member.bytes.size()}});
    const Mesh mesh = good(read(zip_of(parts)));
    EXPECT_TRUE(mesh.read.in_mm);
    EXPECT_EQ(mesh.triangles.size(), 8u);
    expect_box(mesh, {0, 0, 0}, {160, 60, 60});
    EXPECT_NEAR(volume_of(mesh), 2 * 36000, 1e-6);
}

TEST(ThreeMfRead, LengthsAreInMillimetresWhateverTheUnitAndWhateverACommentSays) {
    const std::pair<const char*, double> units[] = {{"micron", 0.001}, {"millimeter", 1}, {"centimeter", 10},
                                                    {"inch", 25.4},    {"foot", 304.8},   {"meter", 1000}};
    for (const auto& [unit, mm] : units) {
        for (const char* front : {"", "<!-- a 3D model unit=\"meter\" -->"}) {
            std::string model = model_of(object_of(1, tetrahedron_mesh("2")),
                                         "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 3 0 0\"/>",
                                         std::string("unit=\"") + unit + "\"");
            model.insert(model.find("<model"), front);
            const Mesh mesh = good(read(threemf_of(model)));
            const Box3d box = box_of(mesh);
            EXPECT_NEAR(box.min.x, 3 * mm, 1e-6 * mm) << unit;
            EXPECT_NEAR(box.max.x, 5 * mm, 1e-6 * mm) << unit;
            EXPECT_TRUE(mesh.read.in_mm);
        }
    }
    EXPECT_EQ(extent_of(good(read(
                  threemf_of(model_of(object_of(1, tetrahedron_mesh("2")), "<item objectid=\"1\"/>", ""))))),
              (Vec3d{2, 2, 2}));
    expect_holds(sentence(threemf_of(model_of("", "", "unit=\"cubit\""))), "cubit");
}

TEST(ThreeMfRead, ComponentsAndItemsArePlacedOneInTheOther) {
    // Rows times the matrix: x goes to y, y to -x; then the item shifts.
    const Mesh mesh = good(read(with_body(
        object_of(1, tetrahedron_mesh("10")) +
            object_of(2,
                      "<components><component objectid=\"1\" transform=\"0 1 0 -1 0 0 0 0 1 7 0 0\"/>"
                      "<component objectid=\"1\"/></components>"),
        "<item objectid=\"2\" transform=\"2 0 0 0 1 0 0 0 1 0 0 100\"/>")));
    EXPECT_EQ(mesh.triangles.size(), 8u);
    expect_box(mesh, {-6, 0, 100}, {20, 10, 110});
    EXPECT_NEAR(volume_of(mesh), 2 * 2 * 1000 / 6.0, 1e-3);
}

TEST(ThreeMfRead, MirroredPlacesStillFaceOutward) {
    for (const char* transform :
         {"-1 0 0 0 1 0 0 0 1 0 0 0", "0 1 0 1 0 0 0 0 1 0 0 0", "-1 0 0 0 -1 0 0 0 -1 0 0 0"})
        EXPECT_GT(volume_of(good(read(
                      with_body(object_of(1, tetrahedron_mesh("6")),
                                std::string("<item objectid=\"1\" transform=\"") + transform + "\"/>")))),
                  35.9)
            << transform;
    const std::string twice =
        "<components><component objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/></components>";
    EXPECT_GT(
        volume_of(good(read(with_body(object_of(1, tetrahedron_mesh("6")) + object_of(2, twice),
                                      "<item objectid=\"2\" transform=\"1 0 0 0 -1 0 0 0 1 0 0 0\"/>")))),
        35.9);
}

TEST(ThreeMfRead, OnlyWhatTheBuildPlacesCounts) {
    const std::string two = object_of(1, tetrahedron_mesh("10")) + object_of(2, tetrahedron_mesh("50"));
    EXPECT_EQ(extent_of(good(read(with_body(two)))), (Vec3d{10, 10, 10}));
    EXPECT_EQ(good(read(with_body(two + object_of(3, "<mesh><vertices/><triangles/></mesh>"),
                                  "<item objectid=\"1\"/><item objectid=\"3\"/>")))
                  .triangles.size(),
              4u);
    // What no program prints is on the plate all the same.
    EXPECT_EQ(
        extent_of(good(read(with_body(two, "<item objectid=\"1\"/><item objectid=\"2\" printable=\"0\"/>")))),
        (Vec3d{50, 50, 50}));
}

TEST(ThreeMfRead, AnEmptyBuildIsTakenForTheOneObjectThatThereIs) {
    const std::string body = object_of(1, tetrahedron_mesh("10"));
    EXPECT_EQ(extent_of(good(read(with_body(body, "")))), (Vec3d{10, 10, 10}));
    EXPECT_EQ(extent_of(good(read(with_body(
                  body + object_of(2, "<components><component objectid=\"1\"/></components>"), "")))),
              (Vec3d{10, 10, 10}));
    expect_holds(sentence(with_body(body + object_of(2, tetrahedron_mesh("50")), "")),
                 "which of its 2 objects");
    expect_holds(sentence(with_body("", "")), "its build is empty");
}

TEST(ThreeMfRead, SupportsCountWhereNothingElseIsPlacedAndOthersNever) {
    const std::string thing = object_of(1, tetrahedron_mesh("10"), "type=\"model\"");
    for (const char* type : {"support", "solidsupport"}) {
        const std::string support =
            object_of(2, tetrahedron_mesh("50"), std::string("type=\"") + type + "\"");
        EXPECT_EQ(
            extent_of(good(read(with_body(thing + support, "<item objectid=\"2\"/><item objectid=\"1\"/>")))),
            (Vec3d{10, 10, 10}));
        EXPECT_EQ(extent_of(good(read(with_body(support, "<item objectid=\"2\"/>")))), (Vec3d{50, 50, 50}));
    }
    // Slicers keep the shapes that only change how a part is printed beside it, as components of this type.
    const std::string other =
        object_of(2, tetrahedron_mesh("50"), "type=\"other\"") +
        object_of(3, "<components><component objectid=\"1\"/><component objectid=\"2\"/></components>");
    EXPECT_EQ(extent_of(good(read(with_body(thing + other, "<item objectid=\"3\"/>")))), (Vec3d{10, 10, 10}));
    expect_holds(sentence(with_body(other + thing, "<item objectid=\"2\"/>")), "no triangles");
    const std::string surface = object_of(1, tetrahedron_mesh("10"), "type=\"surface\"");
    EXPECT_EQ(good(read(with_body(surface))).triangles.size(), 4u);
}

TEST(ThreeMfRead, PartsOfOtherModelsKeepTheirOwnIds) {
    const std::string root =
        model_of(object_of(1, tetrahedron_mesh("1")) +
                     object_of(2,
                               "<components><component p:path=\"/3D/Objects/a.model\" objectid=\"1\"/>"
                               "<component p:path=\"/3D/Objects/b%20c.model\" objectid=\"1\" transform=\"1 0 "
                               "0 0 1 0 0 0 1 20 0 0\"/>"
                               "</components>"),
                 "<item objectid=\"2\"/><item objectid=\"7\" p:path=\"/3D/Objects/A.model\" transform=\"1 0 "
                 "0 0 1 0 0 0 1 0 40 0\"/>",
                 "requiredextensions=\"p\"");
    const std::string a = model_of(object_of(1, tetrahedron_mesh("10")) +
                                       object_of(7, "<components><component objectid=\"1\"/></components>"),
                                   "");
    const std::string b = model_of(object_of(1, tetrahedron_mesh("0.5")), "", "unit=\"centimeter\"");
    const Mesh mesh =
        good(read(threemf_of(root, {{"3D/Objects/a.model", a}, {"3D\\Objects\\b c.model", b}})));
    EXPECT_EQ(mesh.triangles.size(), 12u);
    expect_box(mesh, {0, 0, 0}, {25, 50, 10});
    expect_holds(sentence(threemf_of(root, {{"3D/Objects/a.model", a}})),
                 "\"3d/objects/b c.model\" is not in it");
}

TEST(ThreeMfRead, TheRootIsTheModelThatTheRelationshipsNameLast) {
    const std::string ten = model_of(object_of(1, tetrahedron_mesh("10")), "<item objectid=\"1\"/>");
    const std::string fifty = model_of(object_of(1, tetrahedron_mesh("50")), "<item objectid=\"1\"/>");
    const auto package = [&](const std::vector<std::string>& targets) {
        return zip_of(
            {{"3D/3dmodel.model", ten}, {"other/Part.xml", fifty}, {"_rels/.rels", relationships(targets)}});
    };
    EXPECT_EQ(extent_of(good(read(package({"/3D/3dmodel.model"})))).x, 10);
    EXPECT_EQ(extent_of(good(read(package({"other/part.xml"})))).x, 50);
    EXPECT_EQ(extent_of(good(read(package({"/3D/3dmodel.model", "/other/Part.xml"})))).x, 50);
    EXPECT_EQ(extent_of(good(read(package({"/other/Part.xml", "/3D/../3D/3dmodel.model"})))).x, 10);
    EXPECT_EQ(extent_of(good(read(package({})))).x, 10);  // as many programs take it
    EXPECT_EQ(extent_of(good(read(zip_of({{"3D/3dmodel.model", ten}})))).x, 10);
    expect_holds(sentence(zip_of({{"a.txt", "x"}})), "no 3MF");
}

TEST(ThreeMfRead, PrefixesEncodingsAndPicturesChangeNothing) {
    const std::string prefixed =
        "<?xml version='1.0'?><c:model unit='inch' "
        "xmlns:c='http://schemas.microsoft.com/3dmanufacturing/core/2015/02' "
        "xmlns:m='http://schemas.microsoft.com/3dmanufacturing/material/2015/02'><c:resources><m:colorgroup "
        "id='1'>"
        "<m:color color='#000000'/></m:colorgroup><m:object id='1'/><c:object id='1'><c:mesh><c:vertices>"
        "<c:vertex x='0' y='0' z='0'/><m:vertex x='9' y='9' z='9'/><c:vertex x='1' y='0' z='0'/><c:vertex "
        "x='0' y='1' z='0'/>"
        "</c:vertices><c:triangles><c:triangle v1='0' v2='1' v3='2' pid='1' "
        "p1='0'/></c:triangles></c:mesh></c:object>"
        "</c:resources><c:build><c:item objectid='1'/></c:build></c:model>";
    std::string utf16("\xff\xfe");
    for (const char c : prefixed) utf16 += {c, '\0'};
    for (const std::string& text : {prefixed, "\xef\xbb\xbf" + prefixed, utf16}) {
        const Mesh mesh = good(read(threemf_of(text, {{"Metadata/thumbnail.png", "\x89PNG\r\n\x1a\n"}})));
        EXPECT_EQ(mesh.triangles.size(), 1u);
        EXPECT_NEAR(extent_of(mesh).x, 25.4, 1e-5);
    }
    // A few programs leave the namespace out.
    EXPECT_TRUE(read(threemf_of("<model><resources>" + object_of(1, tetrahedron_mesh("1")) +
                                "</resources><build><item objectid='1'/></build></model>")));
}

TEST(ThreeMfRead, ARequiredExtensionThatIsUnknownIsNamed) {
    const std::string body = object_of(1, tetrahedron_mesh("1"));
    const auto model = [&](const std::string& attributes) {
        return threemf_of(model_of(body, "<item objectid=\"1\"/>", attributes));
    };
    EXPECT_TRUE(read(model("requiredextensions=\"\"")));
    EXPECT_TRUE(
        read(model("requiredextensions=\"m p  s\" "
                   "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" "
                   "xmlns:s=\"http://schemas.microsoft.com/3dmanufacturing/slice/2015/07\"")));
    EXPECT_TRUE(read(model("recommendedextensions=\"x\" xmlns:x=\"http://example.org/warp/2030\"")));
    const std::string refused =
        sentence(model("requiredextensions=\"p x\" xmlns:x=\"http://example.org/warp/2030\""));
    expect_holds(refused, "\"x\"");
    expect_holds(refused, "http://example.org/warp/2030");
    expect_holds(sentence(model("requiredextensions=\"y\"")), "\"y\"");
}

TEST(ThreeMfRead, ShapesOfExtensionsAreRefusedWhereTheyArePlaced) {
    const std::string lattice =
        "<b:beamlattice xmlns:b=\"http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02\" "
        "radius=\"1\"><b:beams>";
    const std::string beams = lattice + "<b:beam v1=\"0\" v2=\"1\"/></b:beams></b:beamlattice>";
    const std::string none = lattice + "</b:beams></b:beamlattice>";
    const std::string beam_object = object_of(2, tetrahedron_mesh("1", beams));
    const std::string plain = object_of(1, tetrahedron_mesh("1"));
    expect_holds(sentence(with_body(beam_object, "<item objectid=\"2\"/>")),
                 "object 2 of \"3d/3dmodel.model\" is a beam lattice");
    EXPECT_TRUE(read(with_body(plain + beam_object)));
    EXPECT_TRUE(read(with_body(object_of(1, tetrahedron_mesh("1", none)))));
    const std::string cut =
        object_of(2,
                  "<o:booleanshape objectid=\"1\" xmlns:o=\"http://schemas.3mf.io/3dmanufacturing/"
                  "booleanoperations/2023/07\"><o:boolean objectid=\"1\"/></o:booleanshape>");
    expect_holds(sentence(with_body(plain + cut, "<item objectid=\"2\"/>")), "boolean operation");
}

TEST(ThreeMfRead, CirclesAndNestsWithoutEndAreSentences) {
    const auto nest = [](int levels, int copies) {
        std::string body = object_of(0, tetrahedron_mesh("1"));
        for (int level = 1; level <= levels; ++level) {
            std::string components;
            for (int i = 0; i < copies; ++i)
                components += "<component objectid=\"" + std::to_string(level - 1) + "\"/>";
            body += object_of(level, "<components>" + components + "</components>");
        }
        return with_body(body, "<item objectid=\"" + std::to_string(levels) + "\"/>");
    };
    EXPECT_EQ(good(read(nest(10, 2))).triangles.size(), 4096u);
    EXPECT_TRUE(read(nest(64, 1)));
    expect_holds(sentence(nest(65, 1)), "more than 64 deep");
    expect_holds(sentence(nest(60, 10)), "10,000,000 triangles");
    expect_holds(sentence(with_body(object_of(1, "<components><component objectid=\"2\"/></components>") +
                                    object_of(2, "<components><component objectid=\"1\"/></components>"))),
                 "a component of itself");
    // The deeper chain is found although each of its halves was seen before.
    std::string body = object_of(0, tetrahedron_mesh("1")), build;
    for (int level = 1; level <= 100; ++level) {
        body += object_of(
            level, "<components><component objectid=\"" + std::to_string(level - 1) + "\"/></components>");
        build += "<item objectid=\"" + std::to_string(level) + "\"/>";
    }
    expect_holds(sentence(with_body(body, build)), "more than 64 deep");
    expect_holds(sentence(with_body("", "<item objectid=\"3\"/>")),
                 "object 3 of \"3d/3dmodel.model\" is placed, but it is not there");
}

TEST(ThreeMfRead, TooMuchIsRefusedWhereItStandsAndNotAfterAllIsRead) {
    std::string objects;
    for (int id = 1; id <= 200'001; ++id) objects += "<object id=\"" + std::to_string(id) + "\"/>";
    expect_holds(sentence(with_body(objects + "<object id=\"no number\"/>")), "200,000 objects");
    std::string uses;
    for (int i = 0; i <= 1'000'000; ++i) uses += "<item objectid=\"1\"/>";
    expect_holds(sentence(with_body("", uses + "<item objectid=\"no number\"/>")),
                 "1,000,000 items and components");
}

TEST(ThreeMfRead, FacesThatAreNoneAreLeftOutAndCounted) {
    const std::string more =
        "<vertex x=\"nan\" y=\"0\" z=\"0\"/><vertex y=\"0\" z=\"0\"/></vertices><triangles>"
        "<triangle v1=\"0\" v2=\"1\" v3=\"4\"/><triangle v1=\"0\" v2=\"5\" v3=\"2\"/>"
        "<triangle v1=\"0\" v2=\"1\" v3=\"6\"/><triangle v1=\"0\" v2=\"-1\" v3=\"2\"/>";
    std::string mesh = tetrahedron_mesh("5");
    mesh.replace(mesh.find("</vertices><triangles>"), 22, more);
    const Mesh found =
        good(read(with_body(object_of(1, mesh), "<item objectid=\"1\"/><item objectid=\"1\"/>")));
    EXPECT_EQ(found.triangles.size(), 8u);
    EXPECT_EQ(found.read.faces, 16u);
    EXPECT_EQ(found.read.left_out_faces, 8u);
    EXPECT_TRUE(keeps_promises(found));
    mesh.replace(mesh.find("</triangles>"), 0, "<triangle/>");
    expect_holds(sentence(with_body(object_of(1, mesh))), "5 of its 9 triangles");
}

TEST(ThreeMfRead, DamagedModelsNameThePartAndTheLine) {
    const auto broken = [](const std::string& model) { return sentence(threemf_of(model)); };
    expect_holds(broken("<model>\n<resources>"), "\"3d/3dmodel.model\", line 2: it is cut off");
    expect_holds(broken("<svg/>"), "its first element is \"svg\"");
    expect_holds(broken(model_of(object_of(1, "") + object_of(1, ""), "")), "two objects with the id 1");
    expect_holds(broken(model_of("", "<item objectid=\"one\"/>")),
                 "objectid of an element \"item\" is not a whole number");
    expect_holds(
        broken(model_of(object_of(1, tetrahedron_mesh("1")), "<item objectid=\"1\" transform=\"1 0 0\"/>")),
        "not twelve numbers");
    expect_holds(broken("%3McF\1secret"), "encrypted");
}

TEST(ThreeMfRead, DamagedFilesAreSentencesOrWholeMeshes) {
    const std::string model = model_of(
        object_of(1, tetrahedron_mesh("10")) +
            object_of(2,
                      "<components><component objectid=\"1\"/>"
                      "<component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 9 0 0\"/></components>"),
        "<item objectid=\"2\"/><item objectid=\"1\"/>");
    for (std::uint64_t seed = 1; seed <= 5000; ++seed) {
        Random random(seed);
        std::string hurt = model;
        for (int turn = random.integer(1, 4); turn > 0; --turn) {
            const std::size_t at = random.bits() % hurt.size();
            if (random.chance(0.3))
                hurt.erase(at, random.bits() % 20);
            else
                hurt[at] = "<>/\"'&09-e \0v"[random.bits() % 13];
        }
        const auto mesh = read(zip_of({{"3D/3dmodel.model", hurt}}));
        EXPECT_TRUE(mesh ? keeps_promises(*mesh) : !snug::text(mesh.error().message).empty())
            << "seed " << seed;
    }
}

}  // namespace
}  // namespace snug::test
