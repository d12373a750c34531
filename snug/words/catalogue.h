#pragma once

#include <span>
#include <string_view>

// The catalogue of words: what Snug says, English and Japanese side by side. A row of a topic's file is used
// by its code: say("capped", {{"holes", 2}}). In its sentences stand, for the values of the message,
//   {name}            the value: text as it is, a count with groups (1,383,712), messages one behind the
//   other {name|one|many}   one of two words, by a count {name,}           messages as a list: "a, b, c"
//   {name;}           "a; b; c"
//   {name&}           "a, b and c" {name/}           "a, b or c"
// Both languages use the same values; what only chooses a word may be in one of them alone.

namespace snug {

struct Wording {
    std::string_view code, english, japanese;
};

/// The row of a code; null where there is none.
[[nodiscard]] const Wording* wording(std::string_view code);

// The rows of each topic.
std::span<const Wording> words_of_archives();
std::span<const Wording> words_of_bricks();
std::span<const Wording> words_of_bricks_pages();
std::span<const Wording> words_of_design();
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
std::span<const Wording> words_of_meshes();
std::span<const Wording> words_of_mill_pages();
std::span<const Wording> words_of_mould_pages();
std::span<const Wording> words_of_objects();
std::span<const Wording> words_of_options();
std::span<const Wording> words_of_packing_sheet();
std::span<const Wording> words_of_pages();
std::span<const Wording> words_of_ply();
std::span<const Wording> words_of_preview();
std::span<const Wording> words_of_print_titles();
std::span<const Wording> words_of_printing();
std::span<const Wording> words_of_session();
std::span<const Wording> words_of_sheets();
std::span<const Wording> words_of_sheets_pages();
std::span<const Wording> words_of_space();
std::span<const Wording> words_of_sponge_and_mill();
std::span<const Wording> words_of_sponge_pages();
std::span<const Wording> words_of_summary();
std::span<const Wording> words_of_usage();
std::span<const Wording> words_of_walls();

}  // namespace snug
