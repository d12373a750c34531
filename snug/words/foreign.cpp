#include "snug/words/catalogue.h"

// Files of kinds that Snug does not read.

namespace snug {
namespace {

constexpr Wording kWordsOfForeign[] = {
    {"foreign", "this is {what}: {advice}", "これは{what}です。{advice}。"},
    {"foreign.export", "export it as STL, OBJ or PLY instead", "STL、OBJ、PLY で書き出してください"},
    {"foreign.export_cloud", "export it as PLY or XYZ instead", "PLY か XYZ で書き出してください"},
    {"foreign.download", "download the file itself again", "ファイルそのものをダウンロードし直してください"},
    {"foreign.unpack", "unpack it first", "先に展開してください"},
    {"foreign.make", "make its foams with snug make, or inspect the object itself",
     "`snug make` で緩衝材を作るか、対象物そのものを調べてください"},
    {"foreign.project", "a project of Snug's", "Snug のプロジェクト"},
    {"foreign.xml_file", "an XML file", " XML ファイル"},
    {"foreign.json_file", "a JSON file", " JSON ファイル"},
    {"foreign.zip_or_3mf_file", "a zip or 3MF file", " zip か 3MF ファイル"},
    {"foreign.gltf_file", "a glTF file", " glTF ファイル"},
    {"foreign.step_file", "a STEP file", " STEP ファイル"},
    {"foreign.fbx_file", "an FBX file", " FBX ファイル"},
    {"foreign.blender_file", "a Blender file", " Blender ファイル"},
    {"foreign.e57_scan", "an E57 scan", " E57 のスキャン"},
    {"foreign.las_or_laz_scan", "a LAS or LAZ scan", " LAS か LAZ のスキャン"},
    {"foreign.pcd_cloud", "a PCD cloud", " PCD の点群"},
    {"foreign.vtk_file", "a VTK file", " VTK ファイル"},
    {"foreign.vrml_file", "a VRML file", " VRML ファイル"},
    {"foreign.draco_file", "a Draco file", " Draco ファイル"},
    {"foreign.solidworks_file", "a SolidWorks file", " SolidWorks ファイル"},
    {"foreign.cad_or_office_document", "a CAD or Office document", " CAD か Office の文書"},
    {"foreign.dwg_drawing", "a DWG drawing", " DWG 図面"},
    {"foreign.brep_file", "a BREP file", " BREP ファイル"},
    {"foreign.pdf_document", "a PDF document", " PDF 文書"},
    {"foreign.picture_png", "a picture (PNG)", "画像（PNG）"},
    {"foreign.picture_jpeg", "a picture (JPEG)", "画像（JPEG）"},
    {"foreign.picture_gif", "a picture (GIF)", "画像（GIF）"},
    {"foreign.gzip_archive", "a gzip archive", " gzip の書庫"},
    {"foreign.7_zip_archive", "a 7-Zip archive", " 7-Zip の書庫"},
    {"foreign.rar_archive", "a RAR archive", " RAR の書庫"},
    {"foreign.web_page", "a web page", "ウェブページ"},
    {"foreign.git_lfs", "a pointer of Git LFS and not the file",
     " Git LFS のポインターで、ファイルそのものではないもの"},
    {"foreign.collada_file", "a COLLADA file", " COLLADA ファイル"},
    {"foreign.x3d_file", "an X3D file", " X3D ファイル"},
    {"foreign.amf_file", "an AMF file", " AMF ファイル"},
    {"foreign.drawing_svg", "a drawing (SVG)", "図（SVG）"},
};

}  // namespace

std::span<const Wording> words_of_foreign() {
    return kWordsOfForeign;
}

}  // namespace snug
