#include "cli/folder_run.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <set>
#include <sys/stat.h>
#include <utility>

#include <fmt/core.h>

#include "snug/words/words.h"

#include "cli/interrupt.h"
#include "cli/sha256.h"
#include "cli/system_error.h"

namespace snug::cli {
namespace {

namespace fs = std::filesystem;

const std::string kList = ".snug-files";
const std::string kUnfinished = "UNFINISHED.txt";
const std::string kProject = "project.snug.json";  // is read and made anew in one folder
constexpr std::uint64_t kLongestList = 16 << 20;   // bytes; a file takes about 100
constexpr std::size_t kNamed = 5;
constexpr double kPatience = 60;  // seconds

constexpr std::string_view kListNote =
    "What snug made in this folder. The next run into it takes away those of these files\n"
    "that it does not make again and that nobody changed. Without this list it takes nothing away.\n";
constexpr std::string_view kUnfinishedNote =
    "This folder holds a mix of two runs of snug: the last one was stopped before it had finished.\n"
    "Do not make anything from these files. Run snug make into this folder again: that puts it right.\n";

Result<void> write_text(FileSet& set, const std::string& name, const std::string& text) {
    return set.write(name, std::as_bytes(std::span(text)));
}

/// "a, b and 3 more"
Message named(const std::vector<std::string>& names) {
    std::vector<Message> first, more;
    for (std::size_t i = 0; i < std::min(names.size(), kNamed); ++i) first.push_back(as_it_is(names[i]));
    if (names.size() > kNamed) more.push_back(say("and_more", {{"count", names.size() - kNamed}}));
    return say("names_and_more", {{"names", first}, {"more", more}});
}

/// "2 files of an earlier run (a, b)"
Message of_earlier(const std::vector<std::string>& names) {
    return say("of_earlier", {{"count", names.size()}, {"names", named(names)}});
}

std::string folder_of(const std::string& name) {
    const std::size_t slash = name.rfind('/');
    return slash == std::string::npos ? "" : name.substr(0, slash);
}

}  // namespace

FolderRun::FolderRun(fs::path folder, std::vector<std::string> pack_folders, std::vector<fs::path> inputs)
    : folder_(std::move(folder)),
      pack_folders_(std::move(pack_folders)),
      inputs_(std::move(inputs)),
      set_(folder_) {}

Result<void> FolderRun::open() {
    return set_.open();
}

Result<void> FolderRun::write(const std::string& name, std::span<const std::byte> bytes) {
    made_.push_back({name, bytes.size(), sha256(bytes)});
    return set_.write(name, bytes);
}

Result<std::vector<Finding>> FolderRun::look_back(std::span<const std::string> to_come) {
    auto inside = FolderInside::open(folder_);
    if (!inside) return tl::unexpected(inside.error());
    inside_ = std::move(*inside);
    if (auto done = inside_->lock(kPatience); !done) return tl::unexpected(done.error());

    was_unfinished_ = inside_->find(kUnfinished).state != FolderInside::State::missing;
    if (was_unfinished_) {
        const auto text = inside_->read(kUnfinished, kLongestList);
        auto files = text ? parse_manifest(*text) : std::nullopt;
        if (!files)
            return fail(ErrorKind::output,
                        say("folder.name_taken", {{"file", (folder_ / kUnfinished).string()}}));
        unfinished_ = std::move(*files);
    }
    if (inside_->find(kList).state != FolderInside::State::missing) {
        const auto text = inside_->read(kList, kLongestList);
        auto files = text ? parse_manifest(*text) : std::nullopt;
        untrusted_ = !files;
        if (files) earlier_ = std::move(*files);
    }
    earlier_.insert(earlier_.end(), unfinished_.begin(), unfinished_.end());
    std::vector<std::string> names(to_come.begin(), to_come.end());
    for (const MadeFile& file : made_) names.push_back(file.name);
    sort_out(names);
    if (auto done = find_foreign(names); !done) return tl::unexpected(done.error());
    if (InterruptGuard::interrupted()) return fail(ErrorKind::cancelled, say("cancelled.nothing_written"));
    return findings();
}

/// Files of earlier runs that are not made again: which go, and which stay and why.
void FolderRun::sort_out(const std::vector<std::string>& names) {
    const std::set<std::string> again(names.begin(), names.end());
    std::sort(earlier_.begin(), earlier_.end(), in_order);
    for (auto next = earlier_.begin(); next != earlier_.end();) {
        const auto first = next;
        next = std::find_if(first, earlier_.end(),
                            [&](const MadeFile& file) { return file.name != first->name; });
        if (again.count(first->name) > 0) continue;
        const FolderInside::Found found = inside_->find(first->name);
        if (found.state == FolderInside::State::missing) continue;
        const bool same = is_as_written(first->name, found, {first, next});
        if (same && found.removable && !is_input(found)) {
            gone_.push_back(first->name);
            continue;
        }
        (!same ? changed_ : is_input(found) ? read_ : fixed_).push_back(first->name);
        staying_.insert(staying_.end(), first, next);
    }
}

/// Files under names that this run makes, which no run wrote or which somebody changed since.
Result<void> FolderRun::find_foreign(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        const FolderInside::Found found = inside_->find(name);
        if (found.state != FolderInside::State::file) continue;
        if (is_input(found) && name != kProject)
            return fail(ErrorKind::output, say("folder.is_input", {{"file", (folder_ / name).string()}}));
        std::vector<MadeFile> written;
        for (const auto* files : {&earlier_, &made_})  // what is the same as the new one need not be kept
            for (const MadeFile& file : *files)
                if (file.name == name) written.push_back(file);
        if (!is_input(found) && !is_as_written(name, found, written)) foreign_.push_back(name);
    }
    return {};
}

Result<void> FolderRun::keep_foreign() {
    for (const std::string& name : foreign_) {
        const auto kept = inside_->link_as_old(name);
        if (!kept)
            return fail(ErrorKind::output, say("folder.cannot_keep", {{"file", (folder_ / name).string()}}));
        kept_.push_back(*kept);
    }
    return {};
}

/// Whether a file is what one of several runs wrote under its name.
bool FolderRun::is_as_written(const std::string& name, const FolderInside::Found& found,
                              std::span<const MadeFile> written) const {
    const auto sized = [&](const MadeFile& file) { return file.bytes == found.bytes; };
    if (found.state != FolderInside::State::file || std::none_of(written.begin(), written.end(), sized))
        return false;
    const auto hash = inside_->sha256(name);
    return hash && std::any_of(written.begin(), written.end(),
                               [&](const MadeFile& file) { return sized(file) && file.sha256 == *hash; });
}

bool FolderRun::is_input(const FolderInside::Found& found) const {
    return std::any_of(inputs_.begin(), inputs_.end(), [&](const fs::path& input) {
        struct stat status {};
        return ::stat(input.c_str(), &status) == 0 && status.st_dev == found.device &&
               status.st_ino == found.inode;
    });
}

std::vector<Finding> FolderRun::findings() const {
    std::vector<Finding> found;
    const auto add = [&found](Severity severity, Message message) {
        found.push_back({severity, std::move(message)});
    };
    if (untrusted_) add(Severity::warning, say("earlier_unknown", {{"list", kList}}));
    if (!changed_.empty())
        add(Severity::warning, say("earlier_files_stay/changed", {{"files", of_earlier(changed_)}}));
    if (!foreign_.empty()) add(Severity::warning, say("earlier_files_kept", {{"names", named(foreign_)}}));
    if (!fixed_.empty())
        add(Severity::warning, say("earlier_files_stay/fixed", {{"files", of_earlier(fixed_)}}));
    if (!read_.empty()) add(Severity::note, say("earlier_files_stay/read", {{"files", of_earlier(read_)}}));
    if (was_unfinished_) add(Severity::note, say("earlier_unfinished"));
    if (!gone_.empty()) add(Severity::note, say("earlier_files", {{"files", of_earlier(gone_)}}));
    return found;
}

Result<void> FolderRun::commit() {
    std::vector<MadeFile> in_the_works = made_;
    in_the_works.insert(in_the_works.end(), unfinished_.begin(), unfinished_.end());
    std::vector<MadeFile> in_the_end = made_;
    in_the_end.insert(in_the_end.end(), staying_.begin(), staying_.end());
    FileSet marker(folder_), list(folder_);
    if (auto done = write_text(marker, kUnfinished, manifest_text(in_the_works, kUnfinishedNote)); !done)
        return done;
    if (auto done = write_text(list, kList, manifest_text(in_the_end, kListNote)); !done) return done;

    if (auto done = marker.commit(); !done) return done;
    auto done = keep_foreign();
    if (done) done = set_.commit();
    if (!done) {
        if (set_.begun())
            return fail(done.error().kind,
                        say("folder.mixed", {{"problem", done.error().message}, {"list", kUnfinished}}));
        for (const std::string& name : kept_) (void)inside_->remove_file(name);
        if (!was_unfinished_) (void)inside_->remove_file(kUnfinished);
        return done;
    }
    if (auto taken = take_away(); !taken) return taken;
    if (auto listed = list.commit(); !listed) return listed;
    (void)inside_->remove_file(kUnfinished);
    return {};
}

Result<void> FolderRun::take_away() {
    std::set<std::string, std::greater<>> folders;  // inner ones first
    for (const std::string& name : gone_)
        if (const int error = inside_->remove_file(name); error != 0)
            return fail(ErrorKind::output, say("folder.cannot_remove", {{"file", (folder_ / name).string()},
                                                                        {"reason", reason(error)},
                                                                        {"list", kUnfinished}}));
    for (const MadeFile& file : earlier_) folders.insert(folder_of(file.name));
    std::set<std::string> places(pack_folders_.begin(), pack_folders_.end());
    places.insert(folders.begin(), folders.end());
    for (const MadeFile& file : made_) places.insert(folder_of(file.name));
    places.insert("");
    for (const std::string& place : places)
        for (const std::string& name : inside_->leftovers(place, {FileSet::temporary_name(kList)})) {
            (void)inside_->remove_file(name);
            folders.insert(place);
        }
    folders.erase("");
    for (const std::string& folder : folders) inside_->remove_if_empty(folder);
    return {};
}

}  // namespace snug::cli
