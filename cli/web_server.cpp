#include "cli/web_server.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <httplib.h>
#include <system_error>
#include <thread>
#include <utility>

#include <fmt/core.h>

#include "cli/files.h"
#include "cli/interrupt.h"

namespace snug::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHost = "127.0.0.1";
constexpr int kUsualPort = 8737;
constexpr int kPortsToTry = 20;
constexpr auto kInterruptPause = std::chrono::milliseconds(50);
/// Browsers open connections and leave them idle. Each holds a thread so long, and Ctrl-C waits for it.
constexpr int kIdleSeconds = 1;
constexpr std::size_t kThreads = 32;
constexpr std::size_t kPieceBytes = 1 << 20;

/// The page says the same of itself; here it also holds for what is no page.
constexpr const char* kPolicy =
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' data: blob:; "
    "worker-src 'self'; connect-src 'self' blob:; manifest-src 'self'; base-uri 'none'; form-action 'none'; "
    "frame-ancestors 'none'";

const std::map<std::string, const char*> kTypes{
    {".html", "text/html; charset=utf-8"},
    {".js", "text/javascript; charset=utf-8"},
    {".mjs", "text/javascript; charset=utf-8"},
    {".css", "text/css; charset=utf-8"},
    {".json", "application/json"},
    {".svg", "image/svg+xml"},
    {".png", "image/png"},
    {".wasm", "application/wasm"},
    {".webmanifest", "application/manifest+json"},
};

const char* content_type(const fs::path& path) {
    const auto type = kTypes.find(path.extension().string());
    return type == kTypes.end() ? "application/octet-stream" : type->second;
}

/// From where the bytes lie: an object may be too large to be copied for each request.
void send_kept(httplib::Response& response, const std::vector<std::byte>& bytes) {
    response.set_content_provider(bytes.size(), "application/octet-stream",
                                  [&bytes](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
                                      const auto* start =
                                          reinterpret_cast<const char*>(bytes.data() + offset);
                                      return sink.write(start, std::min(length, kPieceBytes));
                                  });
}

void find(const Site& site, const httplib::Request& request, httplib::Response& response) {
    if (const auto kept = site.contents.find(request.path); kept != site.contents.end())
        return send_kept(response, kept->second);
    const auto file = site.files.find(request.path);
    if (file != site.files.end())
        if (const auto bytes = read_file(file->second))
            return response.set_content(reinterpret_cast<const char*>(bytes->data()), bytes->size(),
                                        content_type(file->second));
    response.status = 404;
    response.set_content("There is nothing here.\n", "text/plain; charset=utf-8");
}

/// Another site's name that was made to point here is none of ours.
bool asks_for_this_machine(const httplib::Request& request) {
    std::string host = request.get_header_value("Host");
    host.resize(std::min(host.rfind(':'), host.size()));
    return host == kHost || host == "localhost";
}

httplib::Server::HandlerResponse refuse_strangers(const httplib::Request& request,
                                                  httplib::Response& response) {
    const bool asks = request.method == "GET" || request.method == "HEAD";
    if (asks && asks_for_this_machine(request)) return httplib::Server::HandlerResponse::Unhandled;
    response.status = asks ? 403 : 405;
    if (!asks) response.set_header("Allow", "GET, HEAD");
    response.set_content("Refused.\n", "text/plain; charset=utf-8");
    return httplib::Server::HandlerResponse::Handled;
}

void own_port_alone(socket_t socket) {
    // Not SO_REUSEPORT, httplib's choice: another program could share the port.
    const int yes = 1;
    (void)setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

Result<int> bound(httplib::Server& server, int port) {
    if (port != 0) {
        if (server.bind_to_port(kHost, port)) return port;
        return fail(ErrorKind::output, say("server.port_taken", {{"port", port}, {"host", kHost}}));
    }
    for (int usual = kUsualPort; usual < kUsualPort + kPortsToTry; ++usual)
        if (server.bind_to_port(kHost, usual)) return usual;
    const int any = server.bind_to_any_port(kHost);
    if (any <= 0) return fail(ErrorKind::output, say("server.no_port", {{"host", kHost}}));
    return any;
}

}  // namespace

Result<Site> site_of_folder(const fs::path& folder) {
    Site site;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const fs::path name = entry->path().lexically_relative(folder);
        if (entry->is_symlink(error) || !entry->is_regular_file(error)) continue;
        if (name.generic_string().find("/.") != std::string::npos || name.generic_string().front() == '.')
            continue;
        site.files["/" + name.generic_string()] = entry->path();
    }
    const auto index = site.files.find("/index.html");
    if (error || index == site.files.end())
        return fail(ErrorKind::input, say("server.no_studio", {{"folder", folder.string()}}));
    site.files["/"] = index->second;
    return site;
}

Result<void> serve(const Site& site, int port, const std::function<void(int)>& on_ready) {
    httplib::Server server;
    server.set_socket_options(own_port_alone);
    server.set_keep_alive_timeout(kIdleSeconds);
    server.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    server.set_default_headers({{"Content-Security-Policy", kPolicy},
                                {"X-Content-Type-Options", "nosniff"},
                                {"Referrer-Policy", "no-referrer"},
                                {"Cross-Origin-Resource-Policy", "same-origin"},
                                {"Cache-Control", "no-cache"}});
    server.set_pre_routing_handler(refuse_strangers);
    server.Get(".*", [&site](const httplib::Request& request, httplib::Response& response) {
        find(site, request, response);
    });

    const auto place = bound(server, port);
    if (!place) return tl::unexpected(place.error());
    const InterruptGuard guard;
    std::atomic<bool> ended = false;
    std::thread watcher([&] {
        // Again and again: a server that does not listen yet cannot be stopped.
        for (; !ended; std::this_thread::sleep_for(kInterruptPause))
            if (InterruptGuard::interrupted()) server.stop();
    });
    on_ready(*place);
    const bool listened = server.listen_after_bind();
    ended = true;
    watcher.join();
    if (!listened && !InterruptGuard::interrupted())
        return fail(ErrorKind::output, say("server.not_served", {{"port", *place}, {"host", kHost}}));
    return {};
}

}  // namespace snug::cli
