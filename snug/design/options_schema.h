#pragma once

#include <string>
#include <string_view>

#include "snug/design/option_list.h"

namespace snug {

/// What kind of value an option has: "switch", "integer", "number", "text", "word", "numbers", "integers",
/// "words", "pieces", "weights"; "missing" for a group that is absent.
[[nodiscard]] std::string_view kind_of(const Option& option);

/// How many numbers an option has; 0: any number of them, or it has none.
[[nodiscard]] int count_of(const Option& option);

/// The table as JSON, for the page's fields: {path: {kind, label, help, unit, least, most, above, or_zero,
/// step, often, count, or_one, words, optional, none, default, flag, scope}}. What an option does not have is
/// missing; `label` and `help`: in English and in Japanese; `count`: of its numbers, for which one number may
/// stand where `or_one` says so; `default` is as a project has it, and `none` the word that a project has for
/// no value; `fitted`: what no wall comes to where the space is fitted to the object, 0 elsewhere; `tray`:
/// the same of a tray. Groups that may be missing are there, too, of kind "group", and lists of them of kind
/// "list": "items", whose first is "items.0".
[[nodiscard]] std::string options_schema();

/// What follows from other choices of a design, as JSON: {path: {usual, least, most}}. `usual`: what an
/// option comes to that is left open; a bound is tighter than the table's.
[[nodiscard]] std::string dependent_options(const Design& design);

}  // namespace snug
