#include "snug/words/catalogue.h"

namespace snug {

const Wording* wording(std::string_view code) {
    for (const auto topic : {words_of_archives,     words_of_bricks,        words_of_bricks_pages,
                             words_of_design,       words_of_figures,       words_of_files,
                             words_of_fit,          words_of_folder,        words_of_foreign,
                             words_of_general,      words_of_gltf,          words_of_gltf_packed,
                             words_of_help,         words_of_lists,         words_of_meshes,
                             words_of_mill_pages,   words_of_mould_pages,   words_of_objects,
                             words_of_options,      words_of_packing_sheet, words_of_pages,
                             words_of_ply,          words_of_preview,       words_of_print_titles,
                             words_of_printing,     words_of_session,       words_of_sheets,
                             words_of_sheets_pages, words_of_space,         words_of_sponge_and_mill,
                             words_of_sponge_pages, words_of_summary,       words_of_usage,
                             words_of_walls})
        for (const Wording& row : topic())
            if (row.code == code) return &row;
    return nullptr;
}

}  // namespace snug
