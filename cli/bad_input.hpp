#pragma once

#include <stdexcept>
#include <string>

namespace cli {

/// Exit statuses of the program: 0 done, 1 the result could not be delivered, 2 bad input; 128 + n:
/// Interrupted by signal n.
enum Status : int { done = 0, failed = 1, bad_input = 2 };

/// Something the user gave that cannot be used. The message is one line without the program's name: where it
/// stood, the value, what was expected.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A signal ended the work early, in good order.
struct Interrupted : std::runtime_error {
  Interrupted(const std::string& what, int by) : std::runtime_error(what), signal(by) {}
  int signal;
};

}  // namespace cli
