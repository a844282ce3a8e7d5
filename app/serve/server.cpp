#include "app/serve/server.hpp"

#include <fmt/format.h>
#include <httplib.h>
#include <openssl/rand.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <mutex>
#include <plumbline/base/error.hpp>

#include "app/serve/page_files.hpp"
#include "app/serve/work_bench.hpp"
#include "support/files/printable.hpp"
#include "support/files/tar_archive.hpp"

namespace plumbline::app {
namespace {

using httplib::Request, httplib::Response;
using nlohmann::json;

/// A model and tables of a person; beyond, it is no lab's.
constexpr std::size_t largest_request = std::size_t{32} << 20, most_files = 200;
/// Each connection has a thread, and may be silent for a while: so many at once stall nobody.
constexpr std::size_t most_connections = 256;
constexpr std::chrono::seconds longest_silence{5};

/// Nothing that anybody could guess.
std::string new_token() {
  std::array<unsigned char, 16> bytes{};
  if (RAND_bytes(bytes.data(), bytes.size()) != 1)
    throw Error("token", "no random numbers", "those of the system");
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

/// Compares all of both, however soon they differ.
bool same(const std::string& a, const std::string& b) {
  unsigned char difference = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    difference |= static_cast<unsigned char>(a[i] ^ b[i]);
  return difference == 0;
}

class Page {
 public:
  explicit Page(int port) {
    server_.set_payload_max_length(largest_request);
    server_.set_read_timeout(longest_silence);
    server_.set_write_timeout(longest_silence);
    server_.set_keep_alive_max_count(100);
    server_.new_task_queue = [] { return new httplib::ThreadPool(most_connections); };
    server_.set_socket_options([](socket_t) {});  // by itself it would share a port that is taken
    port_ = port == 0                                 ? server_.bind_to_any_port("127.0.0.1")
            : server_.bind_to_port("127.0.0.1", port) ? port
                                                      : -1;
    if (port_ <= 0) throw Error("--port", std::to_string(port) + ", which is taken", "a free one, or none");
    root_ = "/" + token_ + "/";
    server_.set_pre_routing_handler(
        [this](const Request& request, Response& response) { return guard(request, response); });
    server_.set_exception_handler(
        [this](const Request&, Response& response, const std::exception_ptr& thrown) {
          try {
            std::rethrow_exception(thrown);
          } catch (const Error& error) {
            answer(response, 422, {{"error", bench_.in_own_names(error.what())}});
          } catch (...) {
            answer(response, 500, {{"error", "something went wrong inside"}});
          }
        });
    add_pages();
    add_work();
    add_results();
  }

  [[nodiscard]] std::string address() const { return fmt::format("http://127.0.0.1:{}{}", port_, root_); }
  void listen() { server_.listen_after_bind(); }

 private:
  using Handled = httplib::Server::HandlerResponse;

  static void answer(Response& response, int status, const json& what) {
    response.status = status;
    response.set_content(what.dump(-1, ' ', false, json::error_handler_t::replace), "application/json");
  }

  /// A page elsewhere may send what it likes to this machine, under any name that its own server gives it.
  Handled guard(const Request& request, Response& response) {
    response.set_header("X-Content-Type-Options", "nosniff");
    response.set_header("X-Frame-Options", "SAMEORIGIN");
    response.set_header("Referrer-Policy", "no-referrer");
    response.set_header("Cache-Control", "no-store");
    response.set_header("Cross-Origin-Resource-Policy", "same-origin");
    response.set_header(
        "Content-Security-Policy",
        "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src data:; "
        "frame-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'self'");
    const std::string host = request.get_header_value("Host"), port = ":" + std::to_string(port_);
    const bool here = host == "127.0.0.1" + port || host == "localhost" + port;
    const bool foreign =
        request.has_header("Origin") && request.get_header_value("Origin") != "http://" + host;
    const bool known =
        request.path.size() >= root_.size() && same(request.path.substr(0, root_.size()), root_);
    const bool asks = request.method == "GET" || request.method == "HEAD";
    const bool by_page =
        request.has_header("Origin") || request.get_header_value("Sec-Fetch-Site") == "same-origin";
    if (here && !foreign && known && (asks || by_page)) return Handled::Unhandled;
    answer(response, here && !foreign ? 404 : 403, {{"error", "not for you"}});
    return Handled::Handled;
  }

  void add_pages() {
    for (const auto& [name, text] : page_files) {
      const std::string file = name;
      const std::string path = root_ + (file == "page.html" ? "" : file);
      const char* const type = file.ends_with(".html")  ? "text/html; charset=utf-8"
                               : file.ends_with(".css") ? "text/css; charset=utf-8"
                                                        : "text/javascript; charset=utf-8";
      server_.Get(path, [text = std::string(text), type](const Request&, Response& response) {
        response.set_content(text, type);
      });
    }
  }

  /// What a person does, one thing after the other.
  void on(const char* name, const std::function<json(const Request&)>& work) {
    server_.Post(root_ + name, [this, work](const Request& request, Response& response) {
      const std::lock_guard lock(working_);
      answer(response, 200, work(request));
    });
  }

  void add_work() {
    on("take", [this](const Request& request) { return take(request); });
    on("example", [this](const Request&) { return bench_.take_example(); });
    on("correct", [this](const Request& request) { return bench_.correct(request.body); });
    on("begin", [this](const Request& request) { return bench_.begin(request.body == "as it is"); });
    on("cancel", [this](const Request&) {
      bench_.cancel();
      return bench_.progress();
    });
    server_.Get(root_ + "progress",
                [this](const Request&, Response& response) { answer(response, 200, bench_.progress()); });
  }

  json take(const Request& request) {
    if (!request.is_multipart_form_data()) throw Error("files", "something else", "a form with files");
    if (request.files.size() > most_files)
      throw Error("files", std::to_string(request.files.size()), fmt::format("at most {}", most_files));
    std::vector<NamedFile> models, tables;
    std::vector<std::string> joints;
    std::string columns;
    for (const auto& [field, file] : request.files) {
      if (field == "model") models.push_back({file.filename, file.content});
      if (field == "table") tables.push_back({file.filename, file.content});
      if (field == "joint") joints.push_back(file.content);
      if (field == "columns") columns = file.content;
    }
    if (models.size() != 1)
      throw Error("model", std::to_string(models.size()), "one: .xml (MJCF), .urdf, .sdf or .toml");
    return bench_.take(models.front(), tables, joints, columns);
  }

  void add_results() {
    server_.Get(root_ + "report", [this](const Request&, Response& response) {
      // The report has its style within, and no script; whatever stands in it can reach nothing. Of one
      // origin with the page, its frame is made as high as it is.
      response.headers.erase("Content-Security-Policy");
      response.set_header(
          "Content-Security-Policy",
          "sandbox allow-same-origin; default-src 'none'; style-src 'unsafe-inline'; img-src data:; "
          "frame-ancestors 'self'");
      const std::string page = bench_.report();
      page.empty() ? answer(response, 404, {{"error", "no report yet"}})
                   : response.set_content(page, "text/html; charset=utf-8");
    });
    server_.Get(root_ + "model/([^/]+)", [this](const Request& request, Response& response) {
      for (const NamedFile& one : bench_.corrected())
        if (one.name == request.matches[1].str()) return download(response, one.name, one.text);
      answer(response, 404, {{"error", "no such model"}});
    });
    server_.Get(root_ + "experiment.tar", [this](const Request&, Response& response) {
      const std::lock_guard lock(working_);
      files::TarArchive archive;
      for (const NamedFile& one : bench_.folder()) archive.add("experiment/" + one.name, one.text);
      download(response, "experiment.tar", archive.bytes());
    });
  }

  static void download(Response& response, const std::string& name, const std::string& text) {
    response.set_header("Content-Disposition", "attachment; filename=\"" + name + "\"");
    response.set_content(text, "application/octet-stream");
  }

  std::string token_ = new_token(), root_;
  httplib::Server server_;
  int port_ = 0;
  std::mutex working_;
  WorkBench bench_;
};

}  // namespace

void serve(int port, const std::function<void(const std::string& address)>& started) {
  Page page(port);
  started(page.address());
  page.listen();
}

}  // namespace plumbline::app
