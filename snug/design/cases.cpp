#include "snug/design/cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include <fast_float/fast_float.h>

#include "snug/base/text.h"
#include "snug/base/utf16.h"

namespace snug {
namespace {

constexpr std::array<std::string_view, 13> kColumns{
    "name",  "kind",    "length_mm", "width_mm", "height_mm", "lid_mm", "tare_kg",
    "price", "most_kg", "carrier",   "divisor",  "source",    "maker"};
constexpr std::size_t kLongestWord = 200;  // bytes of a name or note
constexpr std::size_t kProblemsNamed = 20;

/// Takes the next line off the text, without its end.
std::string_view next_line(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(text.size(), end + 1));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
}

std::string trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(" \t") + 1 - first));
}

/// The fields of a line; one in double quotes may hold commas, and "" stands for a quote in it. None where a
/// quote is not closed.
std::optional<std::vector<std::string>> fields_of(std::string_view line) {
    std::vector<std::string> fields;
    for (bool more = true; more;) {
        std::string field;
        const std::size_t begin = line.find_first_not_of(" \t");
        if (begin != std::string_view::npos && line[begin] == '"') {
            line.remove_prefix(begin + 1);
            for (bool open = true; open;) {
                const std::size_t quote = line.find('"');
                if (quote == std::string_view::npos) return {};
                open = line.substr(quote + 1).starts_with('"');
                field += line.substr(0, quote + (open ? 1 : 0));
                line.remove_prefix(quote + (open ? 2 : 1));
            }
            if (line.find_first_not_of(" \t") != std::string_view::npos &&
                line[line.find_first_not_of(" \t")] != ',')
                return {};
        } else {
            field = trimmed(line.substr(0, line.find(',')));
        }
        fields.push_back(std::move(field));
        const std::size_t comma = line.find(',');
        more = comma != std::string_view::npos;
        if (more) line.remove_prefix(comma + 1);
    }
    return fields;
}

/// One line of the list, by its columns.
class LineReader {
  public:
    LineReader(const std::vector<std::string>& columns, const std::vector<std::string>& fields)
        : columns_(columns), fields_(fields) {}

    [[nodiscard]] std::string word(std::string_view column) {
        const std::string* field = find(column);
        if (!field) return {};
        const bool control = std::any_of(field->begin(), field->end(), [](char c) {
            return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
        });
        if (field->size() > kLongestWord || control) refuse(column, say("cases.short_text"), *field);
        return *field;
    }

    [[nodiscard]] std::optional<double> value(std::string_view column, double least, double most) {
        const std::string* field = find(column);
        if (!field || field->empty()) return {};
        double number_read = 0;
        const char* end = field->data() + field->size();
        const auto result = fast_float::from_chars(field->data(), end, number_read);
        const bool good =
            result.ec == std::errc() && result.ptr == end && number_read >= least && number_read <= most;
        // As many digits as cases_csv() writes, so that a list is read back as it was.
        if (good) return std::floor(number_read * 1e6 + 0.5) / 1e6;
        refuse(column, say("cases.number", {{"least", number(least)}, {"most", number(most)}}), *field);
        return {};
    }

    [[nodiscard]] double required(std::string_view column, double least, double most) {
        const auto found = value(column, least, most);
        if (!found && !problem_) problem_ = say("cases.missing", {{"column", column}});
        return found.value_or(0);
    }

    void refuse(std::string_view column, Message expected, std::string_view found) {
        if (!problem_)
            problem_ = say("cases.column_must_be",
                           {{"column", column}, {"expected", std::move(expected)}, {"found", quoted(found)}});
    }

    [[nodiscard]] const std::optional<Message>& problem() const { return problem_; }

  private:
    [[nodiscard]] const std::string* find(std::string_view column) const {
        const auto place = std::find(columns_.begin(), columns_.end(), column);
        const auto i = static_cast<std::size_t>(place - columns_.begin());
        return i < fields_.size() ? &fields_[i] : nullptr;
    }

    const std::vector<std::string>& columns_;
    const std::vector<std::string>& fields_;
    std::optional<Message> problem_;
};

KnownCase case_from(LineReader& line) {
    KnownCase known;
    known.name = line.word("name");
    if (known.name.empty()) line.refuse("name", say("json.word"), "");
    known.kind = line.word("kind");
    const double length = line.required("length_mm", 1, 20000), width = line.required("width_mm", 1, 20000);
    known.inside_mm = {line.required("height_mm", 1, 20000), std::min(length, width),
                       std::max(length, width)};
    known.lid_mm = line.value("lid_mm", 0, 20000);
    if (known.lid_mm && *known.lid_mm >= known.inside_mm.x)
        line.refuse("lid_mm", say("cases.below_height"), number(*known.lid_mm));
    known.tare_kg = line.value("tare_kg", 0, 1e6);
    known.price = line.value("price", 0, 1e9);
    known.most_kg = line.value("most_kg", 0, 1e6);
    known.carrier = line.word("carrier");
    known.divisor = line.value("divisor", 1, 1e6);
    known.source = line.word("source");
    known.maker = line.word("maker");
    return known;
}

/// What is wrong with the line that names the columns.
std::optional<Message> problem_of_columns(const std::vector<std::string>& columns) {
    for (const std::string& column : columns)
        if (std::find(kColumns.begin(), kColumns.end(), column) == kColumns.end())
            return say("cases.unknown_column",
                       {{"name", quoted(column)}, {"known", each_as_it_is(kColumns)}});
    for (const std::string_view needed : {kColumns[0], kColumns[2], kColumns[3], kColumns[4]})
        if (std::find(columns.begin(), columns.end(), needed) == columns.end())
            return say("cases.no_column", {{"name", needed}});
    return {};
}

std::string field_text(std::string_view text) {
    if (text.find_first_of(",\"#") == std::string_view::npos && trimmed(text) == text)
        return std::string(text);
    std::string field = "\"";
    for (const char c : text) field += c == '"' ? std::string("\"\"") : std::string(1, c);
    return field + "\"";
}

std::string in_lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

/// "1450", "peli 1450" and, since makers have longer names elsewhere, "pelican protector 1450".
bool is_called(const KnownCase& known, const std::string& typed) {
    const std::string name = in_lower_case(known.name);
    if (typed == name) return true;
    return !known.maker.empty() && typed.starts_with(in_lower_case(known.maker)) &&
           typed.ends_with(" " + name);
}

std::string field_text(const std::optional<double>& value) {
    return value ? number(*value, 6) : std::string();
}

}  // namespace

CaseList parse_cases(std::string_view text) {
    CaseList list;
    const auto decoded = utf8_of_utf16(std::as_bytes(std::span(text.data(), text.size())));
    if (decoded) text = *decoded;
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    std::vector<std::string> columns;
    std::size_t unnamed = 0;
    const auto problem = [&](int line, Message what) {
        if (list.problems.size() < kProblemsNamed)
            list.problems.push_back(say(
                "at_place",
                {{"place", say("at_line", {{"line", std::to_string(line)}})}, {"problem", std::move(what)}}));
        else
            ++unnamed;
    };
    for (int number_of_line = 1; !text.empty(); ++number_of_line) {
        const std::string_view line = next_line(text);
        const std::size_t begin = line.find_first_not_of(" \t");
        if (begin == std::string_view::npos || line[begin] == '#') continue;
        auto fields = fields_of(line);
        if (!fields) {
            problem(number_of_line, say("cases.quotes"));
            if (columns.empty()) return list;
            continue;
        }
        if (columns.empty()) {
            if (const auto wrong = problem_of_columns(*fields)) {
                problem(number_of_line, *wrong);
                return list;
            }
            columns = std::move(*fields);
            continue;
        }
        if (fields->size() > columns.size()) {
            problem(number_of_line, say("cases.fields", {{"fields", std::to_string(fields->size())},
                                                         {"columns", std::to_string(columns.size())}}));
            continue;
        }
        LineReader reader(columns, *fields);
        KnownCase known = case_from(reader);
        if (reader.problem())
            problem(number_of_line, *reader.problem());
        else
            list.cases.push_back(std::move(known));
    }
    if (unnamed > 0) list.problems.push_back(say("cases.more_lines", {{"lines", unnamed}}));
    return list;
}

std::string cases_csv(const std::vector<KnownCase>& cases) {
    std::string text;
    for (const auto column : kColumns) text += (text.empty() ? "" : ",") + std::string(column);
    text += "\n";
    for (const KnownCase& known : cases) {
        const std::array<std::string, kColumns.size()> fields{
            field_text(known.name),        field_text(known.kind),        field_text(known.inside_mm.z),
            field_text(known.inside_mm.y), field_text(known.inside_mm.x), field_text(known.lid_mm),
            field_text(known.tare_kg),     field_text(known.price),       field_text(known.most_kg),
            field_text(known.carrier),     field_text(known.divisor),     field_text(known.source),
            field_text(known.maker)};
        for (std::size_t i = 0; i < fields.size(); ++i) text += (i ? "," : "") + fields[i];
        text += "\n";
    }
    return text;
}

Result<KnownCase> find_case(const std::vector<KnownCase>& known, std::string_view name) {
    const std::string typed = in_lower_case(name);
    for (const bool exact : {true, false}) {
        const auto found = std::find_if(known.rbegin(), known.rend(), [&](const KnownCase& c) {
            return exact ? c.name == name : is_called(c, typed);
        });
        if (found != known.rend()) return *found;
    }
    return fail(ErrorKind::usage, say("case.unknown", {{"name", quoted(name)}}));
}

void apply(const KnownCase& known, CaseOptions& options) {
    options.name = known.name;
    options.inside_mm = known.inside_mm;
    options.lid_mm = known.lid_mm;
    options.divisor = known.divisor;
    if (!known.divisor && !known.has_flat_rate()) options.divisor = CaseOptions{}.divisor;
}

}  // namespace snug
