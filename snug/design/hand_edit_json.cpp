#include "snug/design/hand_edit_json.h"

#include "snug/design/json_reader.h"

namespace snug {

nlohmann::ordered_json edits_json(const HandEdits& edits) {
    auto json = nlohmann::ordered_json::array();
    for (const HandEdit& edit : edits) {
        nlohmann::ordered_json each{
            {"piece", edit.piece}, {"j", edit.j}, {"k", edit.k}, {"blocks", edit.blocks}};
        if (edit.under) each["under"] = true;
        json.push_back(std::move(each));
    }
    return json;
}

bool read_edits(const nlohmann::json& json, HandEdits& edits) {
    edits.clear();
    if (!json.is_array()) return false;
    for (const nlohmann::json& each : json) {
        if (!each.is_object()) return false;
        HandEdit edit;
        JsonReader reader(each, "");
        for (const char* needed : {"piece", "j", "k", "blocks"}) reader.require(needed);
        reader.read("piece", edit.piece)
            .read("j", edit.j)
            .read("k", edit.k)
            .read("blocks", edit.blocks)
            .read("under", edit.under);
        if (reader.problem()) return false;
        edits.push_back(std::move(edit));
    }
    return true;
}

}  // namespace snug
