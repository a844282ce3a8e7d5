#pragma once
/// \file
/// Local web page for files to diagnose.

#include <functional>
#include <string>

namespace plumbline::app {

/// Serves until the process is interrupted. Only this machine is listened to; only requests that know the
/// token in the address, name this server as their host and come from its own page are answered; what comes
/// in is bounded in size; nothing goes out but the answers.
/// \param port     0 for any that is free
/// \param started  called with the address, once it answers
/// \throws Error where the port is not to be had
void serve(int port, const std::function<void(const std::string& address)>& started);

}  // namespace plumbline::app
