#include "snug/fabricate/kit/start_here.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "snug/words/words.h"

namespace snug {
namespace {

/// "sponge/" of "sponge/lower-01.svg"; a file that stands in no folder by its own name.
std::string place_of(const std::string& name) {
    const std::size_t slash = name.find('/');
    return slash == std::string::npos ? name : name.substr(0, slash + 1);
}

/// How many files stand in each place, in the order of the pack.
std::vector<std::pair<std::string, int>> places_of(const WorkshopPack& pack) {
    std::vector<std::pair<std::string, int>> places;
    const auto add = [&](const std::string& name) {
        const std::string place = place_of(name);
        const auto found =
            std::find_if(places.begin(), places.end(), [&](const auto& each) { return each.first == place; });
        if (found == places.end())
            places.emplace_back(place, 1);
        else
            ++found->second;
    };
    for (const PackFile& file : pack.files) add(file.name);
    for (const PackContainer& container : pack.containers) add(container.name);
    return places;
}

Message document_line(const DrawingDocument& document) {
    const std::string file = document.name + ".pdf";
    const std::size_t pages = document.pages.size();
    return document.true_size
               ? say("start.true_size", {{"file", file}, {"title", document.title}, {"pages", pages}})
               : say("start.document", {{"file", file}, {"title", document.title}, {"pages", pages}});
}

Message place_line(const std::pair<std::string, int>& place) {
    if (place.first.back() != '/') return as_it_is(place.first);
    return say("start.folder", {{"folder", place.first}, {"files", place.second}});
}

}  // namespace

PackFile start_here(const WorkshopPack& pack, const std::string& object_name, Language language) {
    std::vector<Message> lines;
    for (const DrawingDocument& document : pack.documents) lines.push_back(document_line(document));
    // The packing sheet, which travels with the box, comes last.
    const auto last = lines.empty() ? lines.end() : lines.end() - 1;
    std::vector<Message> places;
    for (const auto& place : places_of(pack)) places.push_back(place_line(place));
    lines.insert(last, places.begin(), places.end());
    std::string all = text(say("start.title", {{"name", object_name}}), language) + "\n\n";
    for (std::size_t i = 0; i < lines.size(); ++i)
        all += std::to_string(i + 1) + ". " + text(lines[i], language) + "\n";
    all += "\n" + text(say("start.rest"), language) + "\n";
    return text_file("start-here.txt", all);
}

}  // namespace snug
