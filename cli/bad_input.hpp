#pragma once

#include <stdexcept>

namespace cli {

/// Exit statuses of the program: 0 done, 1 the result could not be delivered, 2 bad input.
enum Status : int { done = 0, failed = 1, bad_input = 2 };

/// Something the user gave that cannot be used. The message is one line without the program's name: where it
/// stood, the value, what was expected.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace cli
