#include "output.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "bad_input.hpp"
#include "numbers.hpp"

namespace cli {
namespace {

void write_to_standard_output(const std::string& text) {
  const bool written =
      std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!written) {
    throw std::runtime_error("standard output: cannot be written: " + std::string(std::strerror(errno)));
  }
}

}  // namespace

void deliver(const std::string& text, const std::optional<std::string>& out) {
  if (!out) return write_to_standard_output(text);

  try {
    contensou::write_file(text, *out);
  } catch (const std::runtime_error&) {
    throw BadInput("--out: " + in_quotes(*out) +
                   " cannot be written; expected the name of a regular file to write");
  }
}

void deliver(const contensou::Table& table, const std::optional<std::string>& out) {
  deliver(contensou::to_text(table), out);
}

}  // namespace cli
