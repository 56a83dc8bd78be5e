// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "view/site/exchange.h"

namespace pellucid::view {

/// An HttpServer listens on 127.0.0.1 alone and hands questions on, each on a thread of its own.
class HttpServer {
 public:
  using Respond = std::function<Answer(const Question&)>;

  /// Takes a port, 0: any free one. `check` answers what is refused, before a body is read; its
  /// answer has a status of 400 or above. Throws InputError when the port is taken.
  HttpServer(int port, const std::function<std::unique_ptr<Answer>(const Question&)>& check,
             Respond respond);
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  int port() const;

  /// Serves until stop(), which any other thread may call once it is certain that serve() is
  /// called.
  void serve();
  void stop();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pellucid::view
