#include "cli/system_error.h"

#include <cerrno>
#include <cstring>

namespace snug::cli {
namespace {

struct Known {
    int error;
    const char* code;
};
constexpr Known kKnown[] = {
    {EACCES, "system.no_permission"}, {EPERM, "system.not_permitted"},    {ENOENT, "system.nothing_there"},
    {EISDIR, "system.is_folder"},     {ENOTDIR, "system.no_folder"},      {EEXIST, "system.is_there"},
    {ENOSPC, "system.disk_full"},     {EDQUOT, "system.quota"},           {EROFS, "system.read_only"},
    {EFBIG, "system.file_too_large"}, {ENAMETOOLONG, "system.long_name"}, {EIO, "system.device"},
    {EMFILE, "system.many_files"},    {ENOMEM, "system.memory"},          {ENOTEMPTY, "system.not_empty"},
    {EBUSY, "system.busy"},           {ELOOP, "system.many_links"},       {ECANCELED, "system.cancelled"},
};

}  // namespace

Message reason(int error) {
    for (const Known& known : kKnown)
        if (known.error == error) return say(known.code);
    return say("system.other", {{"reason", std::strerror(error)}});
}

Message cannot_be_read(int error) {
    return say("file.unreadable", {{"reason", reason(error)}});
}

}  // namespace snug::cli
