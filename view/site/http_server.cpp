// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/site/http_server.h"

#include <fmt/format.h>
#include <httplib.h>
#include <sys/socket.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "core/error.h"

namespace pellucid::view {
namespace {

constexpr std::size_t longest_body = 1 << 20;  // bytes
constexpr std::size_t threads = 16;            // connections that are answered at once
constexpr int keep_alive = 2;                  // seconds; while it waits the library looks up often
constexpr int patience = 10;                   // seconds, for a browser that sends or takes nothing

/// What pages may do: load what this program serves, and nothing else. The report brings styles and
/// scripts within itself, and says so in its own policy.
constexpr const char* page_policy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

Question question_of(const httplib::Request& request) {
  return {request.method,
          request.path,
          request.get_header_value("Host"),
          request.get_header_value("Origin"),
          request.get_header_value("Content-Type"),
          request.body};
}

void send(Answer answer, httplib::Response& response) {
  response.status = answer.status;
  if (!answer.location.empty()) response.set_header("Location", answer.location);
  response.body = std::move(answer.body);
  response.set_header("Content-Type", answer.type);
}

/// Two programs cannot listen on one port, as the library's own options would allow.
void set_options(socket_t socket) {
  const int yes = 1;
  ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
}

}  // namespace

struct HttpServer::State {
  httplib::Server server;
  int port = 0;
  std::atomic<bool> served = false;  // serve() has returned
};

HttpServer::HttpServer(int port,
                       const std::function<std::unique_ptr<Answer>(const Question&)>& check,
                       Respond respond)
    : state_(std::make_unique<State>()) {
  httplib::Server& server = state_->server;
  server.new_task_queue = [] { return new httplib::ThreadPool(threads); };
  server.set_socket_options(set_options);
  server.set_payload_max_length(longest_body);
  server.set_keep_alive_timeout(keep_alive);
  server.set_read_timeout(patience);
  server.set_write_timeout(patience);
  server.set_tcp_nodelay(true);
  server.set_default_headers({{"Cache-Control", "no-store"},
                              {"X-Content-Type-Options", "nosniff"},
                              {"Referrer-Policy", "no-referrer"},
                              {"Cross-Origin-Resource-Policy", "same-origin"}});
  using Handled = httplib::Server::HandlerResponse;
  server.set_pre_routing_handler(
      [check](const httplib::Request& request, httplib::Response& response) {
        auto refusal = check(question_of(request));
        if (!refusal) return Handled::Unhandled;
        send(std::move(*refusal), response);
        return Handled::Handled;
      });
  const auto answer = [respond = std::move(respond)](const httplib::Request& request,
                                                     httplib::Response& response) {
    if (request.path.find("/report/") == std::string::npos)
      response.set_header("Content-Security-Policy", page_policy);
    send(respond(question_of(request)), response);
  };
  server.Get(".*", answer);
  server.Post(".*", answer);
  state_->port = port == 0                                ? server.bind_to_any_port("127.0.0.1")
                 : server.bind_to_port("127.0.0.1", port) ? port
                                                          : -1;
  if (state_->port < 0)
    throw InputError(
        fmt::format("--port {}: it is taken; accepted: a free one, or 0 for any", port));
}

HttpServer::~HttpServer() = default;

int HttpServer::port() const { return state_->port; }

void HttpServer::serve() {
  state_->server.listen_after_bind();
  state_->served = true;
}

/// The library forgets a stop that comes before it has begun.
void HttpServer::stop() {
  while (!state_->served && !state_->server.is_running())
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  state_->server.stop();
}

}  // namespace pellucid::view
