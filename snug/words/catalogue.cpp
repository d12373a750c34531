#include "snug/words/catalogue.h"

namespace snug {

// The rows of each topic, which stand in the file of its name. Nothing but this list asks for them.
std::span<const Wording> words_of_archives();
std::span<const Wording> words_of_bricks();
std::span<const Wording> words_of_bricks_pages();
std::span<const Wording> words_of_design();
std::span<const Wording> words_of_edits();
std::span<const Wording> words_of_figures();
std::span<const Wording> words_of_files();
std::span<const Wording> words_of_fit();
std::span<const Wording> words_of_folder();
std::span<const Wording> words_of_foreign();
std::span<const Wording> words_of_general();
std::span<const Wording> words_of_gltf();
std::span<const Wording> words_of_gltf_packed();
std::span<const Wording> words_of_help();
std::span<const Wording> words_of_lists();
std::span<const Wording> words_of_manual();
std::span<const Wording> words_of_meshes();
std::span<const Wording> words_of_mill_pages();
std::span<const Wording> words_of_mould_pages();
std::span<const Wording> words_of_objects();
std::span<const Wording> words_of_options();
std::span<const Wording> words_of_packing_sheet();
std::span<const Wording> words_of_pages();
std::span<const Wording> words_of_plan();
std::span<const Wording> words_of_ply();
std::span<const Wording> words_of_preview();
std::span<const Wording> words_of_print_titles();
std::span<const Wording> words_of_printing();
std::span<const Wording> words_of_protection();
std::span<const Wording> words_of_session();
std::span<const Wording> words_of_sheets();
std::span<const Wording> words_of_sheets_pages();
std::span<const Wording> words_of_space();
std::span<const Wording> words_of_sponge_and_mill();
std::span<const Wording> words_of_sponge_pages();
std::span<const Wording> words_of_summary();
std::span<const Wording> words_of_usage();
std::span<const Wording> words_of_walls();
std::span<const Wording> words_of_zones();

const Wording* wording(std::string_view code) {
    for (const auto topic : {words_of_archives,     words_of_bricks,
                             words_of_bricks_pages, words_of_design,
                             words_of_edits,        words_of_figures,
                             words_of_files,        words_of_fit,
                             words_of_folder,       words_of_foreign,
                             words_of_general,      words_of_gltf,
                             words_of_gltf_packed,  words_of_help,
                             words_of_lists,        words_of_manual,
                             words_of_meshes,       words_of_mill_pages,
                             words_of_mould_pages,  words_of_objects,
                             words_of_options,      words_of_packing_sheet,
                             words_of_pages,        words_of_plan,
                             words_of_ply,          words_of_preview,
                             words_of_print_titles, words_of_printing,
                             words_of_protection,   words_of_session,
                             words_of_sheets,       words_of_sheets_pages,
                             words_of_space,        words_of_sponge_and_mill,
                             words_of_sponge_pages, words_of_summary,
                             words_of_usage,        words_of_walls,
                             words_of_zones})
        for (const Wording& row : topic())
            if (row.code == code) return &row;
    return nullptr;
}

}  // namespace snug
